// vision/camera_knob_names.hpp: which knobs each kind of mirror has, and what they are called.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <variant>

#include "vision/camera_parameters.hpp"

namespace teamsight::vision {

/// By CameraKnob, as the camera file and reports have them.
inline constexpr std::array<std::string_view, 16> kKnobNames{"centre_u_px",
                                                             "centre_v_px",
                                                             "focal_ratio",
                                                             "offset_x_m",
                                                             "offset_y_m",
                                                             "offset_z_m",
                                                             "tilt_x_rad",
                                                             "tilt_y_rad",
                                                             "head_roll_rad",
                                                             "head_pitch_rad",
                                                             "pinhole_height_m",
                                                             "radial_0_ratio",
                                                             "radial_1_ratio",
                                                             "radial_2_ratio",
                                                             "radial_3_ratio",
                                                             "radial_4_ratio"};

inline constexpr std::array kProfileKnobs{CameraKnob::kCentreU,
                                          CameraKnob::kCentreV,
                                          CameraKnob::kFocal,
                                          CameraKnob::kOffsetX,
                                          CameraKnob::kOffsetY,
                                          CameraKnob::kOffsetZ,
                                          CameraKnob::kTiltX,
                                          CameraKnob::kTiltY,
                                          CameraKnob::kHeadRoll,
                                          CameraKnob::kHeadPitch,
                                          CameraKnob::kHeight};

inline constexpr std::array kRadialKnobs{CameraKnob::kCentreU,
                                         CameraKnob::kCentreV,
                                         CameraKnob::kHeadRoll,
                                         CameraKnob::kHeadPitch,
                                         CameraKnob::kRadial0,
                                         CameraKnob::kRadial1,
                                         CameraKnob::kRadial2,
                                         CameraKnob::kRadial3,
                                         CameraKnob::kRadial4};

static_assert(kProfileKnobs.size() <= kMaxCameraKnobs && kRadialKnobs.size() <= kMaxCameraKnobs);

/// Name with unit, such as "centre_u_px".
[[nodiscard]] constexpr std::string_view name_of(CameraKnob knob) {
  return kKnobNames.at(static_cast<std::size_t>(knob));
}

/// The knobs of a profile mirror, or of a radial table.
[[nodiscard]] constexpr std::span<const CameraKnob> knobs_of_mirror(bool is_profile) {
  if (is_profile) return kProfileKnobs;
  return kRadialKnobs;
}

}  // namespace teamsight::vision
