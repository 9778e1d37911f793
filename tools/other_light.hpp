// tools/other_light.hpp: a picture as the same camera might have taken it in another light.
#pragma once

#include <string_view>
#include <vector>

#include "tools/image_file.hpp"
#include "vision/light_gains.hpp"

namespace teamsight::tools {

/// What becomes of a picture.
struct OtherLight {
  std::string_view name;
  vision::LightGains gains{};  ///< of what it shows; brighter than white stays white
  double noise{0.0};           ///< grey levels; sigma of each pixel's red, green and blue
  bool is_blurred{false};      ///< each pixel mixed with its neighbours, by 1/4, 1/2, 1/4 both ways

  friend bool operator==(const OtherLight&, const OtherLight&) = default;
};

/// Brighter and darker, other casts, noise and blur.
[[nodiscard]] const std::vector<OtherLight>& other_lights();

/// The picture as BGR; the same noise each time.
[[nodiscard]] ImageFile in_light(const ImageFile& picture, const OtherLight& light);

}  // namespace teamsight::tools
