// vision/line_points.hpp: where scan lines cross painted lines, to a fraction of a pixel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "geometry/frames.hpp"
#include "vision/colour_classes.hpp"
#include "vision/pixel_reader.hpp"
#include "vision/scan_lines.hpp"

namespace teamsight::vision {

/// A place where the image shows the middle of a painted line.
struct LinePoint {
  double u_px{0.0};
  double v_px{0.0};
  Point<Robot> p_R;                                    ///< on the floor; m
  Eigen::Matrix2d cov_R{Eigen::Matrix2d::Identity()};  ///< m^2
};

/// How a painted line must look to be one.
struct LineRules {
  double line_width{0.125};   ///< of the paint; m
  double min_contrast{18.0};  ///< against the floor on the brighter side, grey levels
};

inline constexpr std::size_t kMaxLinePoints = 800;

/// Of the paint's width, how wide a scan line may cross it: at a slant of 50 degrees.
inline constexpr double kWidestCrossing = 1.6;

/// A piece of a scan line with what was read along it.
struct ScanProfile {
  std::span<const ScanSample> samples;
  std::span<const SampleTap> taps;          ///< about a pixel apart, the first at the first sample
  std::span<const std::uint8_t> luminance;  ///< at each tap, from read_luminance
  std::size_t pitch{1};                     ///< taps from one sample to the next
};

/// Appends the line points of a piece of a scan line.
///
/// A line is a bright bump whose two edges, at half height, are as far apart on the floor as the
/// paint is wide (crossed at up to 50 degrees), with carpet on both sides.
///
/// @param points grows up to kMaxLinePoints
void find_line_points(const PixelReader& pixels,
                      const ColourClasses& colours,
                      const ScanProfile& scan,
                      const LineRules& rules,
                      std::vector<LinePoint>& points);

}  // namespace teamsight::vision
