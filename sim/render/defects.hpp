// sim/render/defects.hpp: how one robot's eye differs from its camera file.
#pragma once

#include <array>
#include <cstdint>

#include "vision/camera_parameters.hpp"

namespace teamsight::sim {

/// What assembly got wrong on one robot. The agent is never told.
struct CameraDefects {
  std::array<double, 3> mirror_offset{};  ///< in C; m
  std::array<double, 2> mirror_tilt{};    ///< about C's x and y; rad
  double head_roll{0.0};                  ///< of camera and mirror together; rad
  double head_pitch{0.0};                 ///< rad
  double focal_scale{1.0};                ///< dimensionless
  double centre_u_px{0.0};                ///< of the image centre against the file's
  double centre_v_px{0.0};
};

/// Standard deviations from which defects are drawn; the defaults are those of an assembly by hand.
struct DefectSizes {
  double sigma_lateral{0.0005};                              ///< of the mirror, in C's x and y; m
  double sigma_axial{0.0005};                                ///< in C's z; m
  double sigma_mirror_tilt{0.3 * 3.14159265358979 / 180.0};  ///< about C's x and y; rad
  double sigma_head_tilt{0.3 * 3.14159265358979 / 180.0};    ///< roll and pitch; rad
  double sigma_focal{0.01};                                  ///< of the focal length; dimensionless
  double sigma_centre_px{0.0};  ///< beyond what a lateral offset does to the centre
};

/// Draws one robot's defects; the same seed gives the same.
[[nodiscard]] CameraDefects draw_defects(std::uint32_t seed, const DefectSizes& sizes = {});

/// The eye as it really is: what the renderer draws with, and what a calibration should find.
///
/// @pre the camera has a ProfileMirror, or no defects but of focal length and centre: a radial
///      table has no mirror that could lie wrong
[[nodiscard]] vision::CameraParameters with_defects(vision::CameraParameters camera,
                                                    const CameraDefects& defects);

}  // namespace teamsight::sim
