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
#include "vision/radial_scan.hpp"
#include "vision/ray_table.hpp"
#include "vision/scan_lines.hpp"

namespace teamsight::vision {

/// Where a frame's image shows a ball candidate; the pixel side of a BallRay.
struct BallPixels {
  double u_px{0.0};
  double v_px{0.0};
  double r_px{0.0};  ///< radius of the disc of the same area
  /// At least half of what surrounds it is carpet or paint.
  bool on_carpet{true};

  friend bool operator==(const BallPixels&, const BallPixels&) = default;
};

/// What the detectors look at: one frame, and the tables of its camera.
struct FrameTables {
  const PixelReader& pixels;
  const ColourClasses& colours;
  const ScanLines& lines;
  const RayTable& rays;
  const RadialScan& scan;  ///< of the same frame
};

/// A ball candidate on both sides of the lens.
struct BallCandidate {
  BallRay ray;
  BallPixels pixels;
};

/// Grows blobs of ball-coloured pixels from seeds on the radial scan lines, and keeps those that
/// have a ball's size for their place, a ball's shape, and carpet around them. Its buffers are its
/// only state.
class BallDetector {
 public:
  /// @param ball_radius m; judges whether a blob's size fits a ball on the floor
  BallDetector(const RayTable& rays, const Mask& mask, const Pixel& centre, double ball_radius);

  /// @return best first, at most kMaxBallRays; valid until the next call
  [[nodiscard]] std::span<const BallCandidate> find(const FrameTables& frame);

 private:
  /// What a blob's pixels add up to.
  struct Blob {
    std::size_t pixels{0};
    double solid_angle{0.0};  // sr
    double sum_u{0.0};
    double sum_v{0.0};
    double sum_uu{0.0};
    double sum_uv{0.0};
    double sum_vv{0.0};
    double sum_luminance{0.0};
    double sum_u_chroma{0.0};
    double sum_v_chroma{0.0};
    Eigen::Vector3d sum_direction{Eigen::Vector3d::Zero()};  // weighted by solid angle
    Eigen::Vector3d sum_origin{Eigen::Vector3d::Zero()};
    Eigen::Matrix3d sum_square{Eigen::Matrix3d::Zero()};  // of the directions, weighted
  };

  [[nodiscard]] Blob grow(const FrameTables& frame, std::size_t seed);
  void judge(const FrameTables& frame, const Blob& blob);
  void seed_from(const FrameTables& frame, std::size_t radial_line);

  /// Half axes of the ellipse with the blob's second moments, and its direction.
  struct Ellipse {
    double u{0.0};
    double v{0.0};
    double major{0.0};
    double minor{0.0};
    double direction{0.0};  // of the major axis, clockwise from image right; rad
  };

  [[nodiscard]] static Ellipse ellipse_of(const Blob& blob);
  [[nodiscard]] static Blob sum_of(const Blob& a, const Blob& b);
  /// Of a ball on the floor whose middle is seen there; px; 0 where none can be seen.
  [[nodiscard]] double expected_radius(const FrameTables& frame, double u, double v) const;
  /// Of one ball, on both sides of a strut, a hand or the mirror's seam.
  [[nodiscard]] bool are_parts(const FrameTables& frame, const Blob& a, const Blob& b) const;
  void join_parts(const FrameTables& frame);
  /// 1 where the carpet goes on beside the blob, less where it ends before it.
  [[nodiscard]] double carpet_beside(const FrameTables& frame, const Ellipse& ellipse) const;
  /// Mean over the pixel and its eight neighbours: a single one is noisy.
  [[nodiscard]] Chroma chroma_around(const FrameTables& frame, std::size_t pixel) const;
  /// 2 for carpet, 1 for paint, 0 for neither; negative for the own body, if that is near.
  [[nodiscard]] int ground_points(const FrameTables& frame, std::size_t pixel, bool is_near) const;
  /// Share of a ring around the blob that is carpet or paint, in [0, 1].
  [[nodiscard]] double ground_around(const FrameTables& frame, const Ellipse& ellipse) const;

  Pixel centre_;
  double ball_radius_;
  double near_px_{0.0};  // from the image centre, to where a ball may touch the own body
  std::uint32_t frame_{0};
  std::vector<float> solid_angle_;      // of each pixel; 0 where the mask or the mirror ends
  std::vector<std::uint32_t> visited_;  // the frame in which a pixel was last taken
  std::vector<std::size_t> open_;
  std::vector<Blob> blobs_;
  std::vector<BallCandidate> found_;
};

}  // namespace teamsight::vision
