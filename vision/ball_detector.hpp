// vision/ball_detector.hpp: blobs of the ball's colour as rays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/sighting.hpp"
#include "vision/camera_parameters.hpp"
#include "vision/colour_classes.hpp"
#include "vision/pixel_reader.hpp"
#include "vision/ray_table.hpp"
#include "vision/scan_lines.hpp"

namespace teamsight::vision {

/// Where a frame's image shows a ball candidate; the pixel side of a BallRay.
struct BallPixels {
  double u_px{0.0};
  double v_px{0.0};
  double r_px{0.0};  ///< radius of the disc of the same area

  friend bool operator==(const BallPixels&, const BallPixels&) = default;
};

/// A ball candidate on both sides of the lens.
struct BallCandidate {
  BallRay ray;
  BallPixels pixels;
};

/// Grows blobs of ball-coloured pixels from seeds on the radial scan lines. Its buffers are its
/// only state.
class BallDetector {
 public:
  /// @param ball_radius m; judges whether a blob's size fits a ball on the floor
  BallDetector(const RayTable& rays, const Mask& mask, const Pixel& centre, double ball_radius);

  /// @return best first, at most kMaxBallRays; valid until the next call
  [[nodiscard]] std::span<const BallCandidate> find(const PixelReader& pixels,
                                                    const ColourClasses& colours,
                                                    const ScanLines& lines,
                                                    const RayTable& rays);

 private:
  /// What a blob's pixels add up to.
  struct Blob {
    std::size_t pixels{0};
    double solid_angle{0.0};  // sr
    double sum_u{0.0};
    double sum_v{0.0};
    double sum_u_chroma{0.0};
    double sum_v_chroma{0.0};
    Eigen::Vector3d sum_direction{Eigen::Vector3d::Zero()};  // weighted by solid angle
    Eigen::Vector3d sum_origin{Eigen::Vector3d::Zero()};
    Eigen::Matrix3d sum_square{Eigen::Matrix3d::Zero()};  // of the directions, weighted
  };

  [[nodiscard]] Blob grow(const PixelReader& pixels,
                          const ColourClasses& colours,
                          const RayTable& rays,
                          std::size_t seed);
  void judge(const Blob& blob);
  void seed_from(std::span<const ScanSample> line,
                 const PixelReader& pixels,
                 const ColourClasses& colours,
                 const RayTable& rays);

  double ball_radius_;
  std::uint32_t frame_{0};
  std::vector<float> solid_angle_;      // of each pixel; 0 where the mask or the mirror ends
  std::vector<std::uint32_t> visited_;  // the frame in which a pixel was last taken
  std::vector<std::size_t> open_;
  std::vector<BallCandidate> found_;
};

}  // namespace teamsight::vision
