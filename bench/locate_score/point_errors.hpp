// bench/locate_score/point_errors.hpp: how well line points lie on the paint.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "geometry/pose.hpp"
#include "vision/line_map.hpp"
#include "vision/line_points.hpp"

namespace teamsight::locate_score {

/// Distances of line points from the paint they belong to, the robot standing where it truly does.
/// A point farther than 0.15 m from any paint belongs to none and is counted apart.
class PointErrors {
 public:
  /// The points of one frame.
  ///
  /// @param eye_height  of the viewpoint over the floor; m
  void add(const vision::LineMap& map,
           const Pose<Field, Robot>& truth,
           std::span<const vision::LinePoint> points,
           double eye_height);

  [[nodiscard]] std::size_t frames() const { return frames_; }

  /// Of those on paint; 0 if there are none.
  [[nodiscard]] double rms() const;  ///< m
  /// @param share  0.5: half of the points are nearer; m
  [[nodiscard]] double quantile(double share) const;
  /// Root mean square of the distances over the sigmas that are claimed; nothing without points.
  [[nodiscard]] std::optional<double> over_claimed() const;
  [[nodiscard]] double points_per_frame() const;
  /// Share of all points that belong to no paint.
  [[nodiscard]] double share_off_paint() const;

 private:
  std::size_t frames_{0};
  std::size_t off_paint_{0};
  double sum_squared_sizes_{0.0};  // distances over claimed sigmas
  std::vector<double> distances_;  // m, not negative
};

}  // namespace teamsight::locate_score
