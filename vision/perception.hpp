// vision/perception.hpp: one frame in, everything it says out.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/frames.hpp"
#include "geometry/sighting.hpp"

namespace teamsight::vision {

/// A place where the image shows the middle of a painted line.
struct LinePoint {
  double u_px{0.0};
  double v_px{0.0};
  Point<Robot> p_R;  ///< on the floor; m
  Eigen::Matrix2d cov_R{Eigen::Matrix2d::Identity()};  ///< m^2
};

enum class Light : std::uint8_t { kUnknown, kGood, kDark, kGlare, kCovered };

/// Everything one frame says.
struct FrameObservation {
  PostureEstimate posture;
  std::vector<BallRay> balls;               ///< best first, at most kMaxBallRays
  std::vector<ObstacleSighting> obstacles;  ///< nearest first, at most kMaxObstacleSightings
  std::vector<LinePoint> line_points;
  Light light{Light::kUnknown};
};

// The class `Perception` is designed by this folder; its public face:
//   Perception(const CameraParameters&, const FieldModel&)           tables made once
//   Result<const FrameObservation*, FrameReject> see(const ImageView&, const MotionPrior&)
// with MotionPrior = where the robot may be before this frame (nothing: no prior), and the start side.

}  // namespace teamsight::vision
