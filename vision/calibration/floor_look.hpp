// vision/calibration/floor_look.hpp: a pixel on the floor, with its slopes over pixel and knobs.
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "geometry/pose.hpp"
#include "vision/camera_knobs.hpp"
#include "vision/camera_model.hpp"
#include "vision/line_map.hpp"

namespace teamsight::vision {

/// Something per knob, without the heap.
using KnobVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxCameraKnobs, 1>;
using KnobSlopes = Eigen::Matrix<double, 2, Eigen::Dynamic, 0, 2, kMaxCameraKnobs>;

/// Where a pixel meets the floor, in R, and what moves it.
struct FloorLook {
  Pixel pixel;
  Eigen::Vector2d p_R;
  Eigen::Matrix2d per_px;  ///< d p_R / d (u, v)
  KnobSlopes per_knob;     ///< d p_R / d knobs; no columns if not asked for
};

/// A camera with some knobs turned, and its neighbours for the slopes.
class FloorLooker {
 public:
  /// @return nothing if no such camera can be
  [[nodiscard]] static std::optional<FloorLooker> make(const CameraParameters& camera,
                                                       std::span<const CameraKnob> knobs,
                                                       const Eigen::VectorXd& turn,
                                                       bool with_slopes);

  /// @return nothing where the pixel, or one beside it, shows no floor
  [[nodiscard]] std::optional<FloorLook> look(const Pixel& pixel) const;

 private:
  struct Neighbours {
    CameraModel ahead;
    CameraModel behind;
    double step{0.0};  // between the two
  };

  explicit FloorLooker(CameraModel model) : model_(std::move(model)) {}

  CameraModel model_;
  std::vector<Neighbours> neighbours_;  // of each knob
};

/// How a pixel misses the nearest paint.
struct FloorMiss {
  double distance{0.0};        ///< signed; m
  double var{1.0};             ///< of the pixel, across the paint; m^2
  Eigen::Vector2d by_pixel;    ///< d distance / d (u, v)
  Eigen::Vector3d by_posture;  ///< d distance / d (x, y, theta)
  KnobVector by_knob;          ///< d distance / d knobs
};

/// @param sigma_px  of the pixel in either direction
[[nodiscard]] FloorMiss miss_of(const LineMap& map,
                                const Pose<Field, Robot>& X_FR,
                                const FloorLook& seen,
                                double sigma_px);

}  // namespace teamsight::vision
