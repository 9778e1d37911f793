// agent/light_follower.hpp: keeps the colour classes in the light that it is, and says so.
#pragma once

#include <optional>
#include <string>

#include "geometry/time.hpp"
#include "process/meter.hpp"
#include "vision/image.hpp"
#include "vision/light.hpp"
#include "vision/light_adaptation.hpp"
#include "vision/perception.hpp"

namespace teamsight::agent {

/// Looks at the field's green and white some times a second. Use from one thread.
class LightFollower {
 public:
  /// @param reference  of the camera file; nothing: the classes stay as they are
  explicit LightFollower(const std::optional<vision::FieldColours>& reference)
      : adaptation_(reference) {}

  /// After each frame; takes time in few of them.
  ///
  /// @param light     of that frame: only a good one is followed
  /// @param exposure  of that frame
  void follow(vision::Perception& perception,
              const vision::ImageView& frame,
              vision::Light light,
              HostTime exposure);

  /// The present state, for Diagnostics: exposure, and red and blue against green, in percent of
  /// the camera file's light; confidence in percent. Nothing where no light is followed.
  void tell(process::ProcessMeter& meter) const;

  /// What the coach station shows; "" if all is well.
  ///
  /// @return at most 95 characters
  [[nodiscard]] std::string complaint() const;

 private:
  vision::LightAdaptation adaptation_;
  vision::Light light_{vision::Light::kUnknown};
  HostTime looked_{};  // zero: not yet
};

/// The complaint about a light and what was made of it.
[[nodiscard]] std::string light_complaint(vision::Light light, const vision::LightState& state);

}  // namespace teamsight::agent
