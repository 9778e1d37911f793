// vision/light_adaptation.hpp: which light it is now, from the field's own green and white.
#pragma once

#include <cstdint>
#include <optional>

#include "vision/camera_parameters.hpp"
#include "vision/light_gains.hpp"

namespace teamsight::vision {

/// How much an adaptation may do, and how fast.
struct LightRules {
  double settle{0.4};         ///< s; time constant of the gains
  double trust{2.0};          ///< s; time constant of the confidence
  double most_exposure{2.5};  ///< brighter or darker than the camera file's light, by this factor
  double most_cast{1.6};      ///< one colour against the others, by this factor
  double most_mismatch{3.0};  ///< of the colours that the gains do not explain; sigmas, RMS
};

enum class LightStatus : std::uint8_t {
  kNoReference,  ///< the camera file does not say what the field looked like: nothing is adapted
  kWaiting,      ///< green and white have not been seen for a while: the gains stay as they are
  kFollowing,    ///< the gains are those of the light that is seen
  kAtBound,      ///< the light is further off than the rules allow: the gains stay at their bound
  kDisputed,     ///< green and white call for different gains: the gains stay as they are
};

/// What is known of the light.
struct LightState {
  LightStatus status{LightStatus::kNoReference};
  LightGains gains;        ///< of the light against the camera file's
  double confidence{0.0};  ///< share of the last seconds in which green and white agreed with them

  friend bool operator==(const LightState&, const LightState&) = default;
};

/// Follows the light. Each measurement says what the light is against the camera file's, not
/// against the last one, so that nothing adds up unseen over a match; what is not explained by
/// gains of red, green and blue is no change of light and changes nothing.
class LightAdaptation {
 public:
  /// @param reference  what the field looked like when the classes were chosen
  explicit LightAdaptation(const std::optional<FieldColours>& reference,
                           const LightRules& rules = {});

  /// Takes a look at the field.
  ///
  /// @param now        nothing: the field's colours did not stand out
  /// @param elapsed_s  since the look before; s, not negative
  void take(const std::optional<FieldColours>& now, double elapsed_s);

  [[nodiscard]] const LightState& state() const { return state_; }

 private:
  void follow(const LightGains& measured, double share);

  std::optional<FieldColours> reference_;
  LightRules rules_;
  LightState state_;
};

}  // namespace teamsight::vision
