// vision/colour_classes.hpp: the class of a colour by one look-up in a table of the chroma plane.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "vision/camera_parameters.hpp"
#include "vision/pixel_reader.hpp"

namespace teamsight::vision {

/// The chroma plane cut into classes: each place belongs to the nearest sample whose disc holds it,
/// else to the first hue sector that does.
class ColourClasses {
 public:
  explicit ColourClasses(const ColourParameters& parameters);

  /// By chroma alone; kNone where neither disc nor sector reaches.
  [[nodiscard]] ColourClass of(Chroma chroma) const {
    return table_[std::size_t{chroma.u} << 8U | chroma.v];
  }

  /// By chroma, and where that has no colour by luminance: kBlack, kWhite or kNone.
  [[nodiscard]] ColourClass of(std::uint8_t y, Chroma chroma) const {
    const ColourClass colour = of(chroma);
    if (colour != ColourClass::kNone) return colour;
    if (y <= black_max_y_) return ColourClass::kBlack;
    return y >= white_min_y_ ? ColourClass::kWhite : ColourClass::kNone;
  }

  [[nodiscard]] std::uint8_t white_min_y() const { return white_min_y_; }

  [[nodiscard]] std::uint8_t black_max_y() const { return black_max_y_; }

 private:
  std::array<ColourClass, std::size_t{256} * 256> table_{};
  std::uint8_t white_min_y_;
  std::uint8_t black_max_y_;
};

}  // namespace teamsight::vision
