// bench/locate_score/tally.hpp: errors of one method in one case, and what to say of them.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "geometry/pose.hpp"

namespace teamsight::locate_score {

/// Lower and upper end of Wilson's 95 % interval of a share.
struct Interval {
  double low{0.0};
  double high{1.0};
};

[[nodiscard]] Interval wilson(std::size_t hits, std::size_t tries);

/// What one method said of one pose.
struct Answer {
  std::optional<Pose<Field, Robot>> X_FR;  ///< nothing: it said it does not know
  std::optional<Eigen::Matrix3d> cov;      ///< of (x, y, theta)
  double time_ms{0.0};
};

/// Collects answers beside the truth.
class Tally {
 public:
  /// @param bound    trace of the bound's position covariance and the heading's variance; m^2,
  /// rad^2
  /// @param centre   a mirror image about it counts as right; nothing: it does not
  void add(const Answer& answer,
           const Pose<Field, Robot>& truth,
           const Eigen::Vector2d& bound,
           const std::optional<Point<Field>>& centre);

  [[nodiscard]] std::size_t count() const { return count_; }

  /// Further than half a metre or 0.35 rad away, or no answer.
  [[nodiscard]] std::size_t failures() const { return failures_; }

  [[nodiscard]] std::size_t silent() const { return silent_; }

  /// Of all answers; m.
  [[nodiscard]] double place_quantile(double share) const;

  /// Root mean square of the answers that are no failures; m, rad.
  [[nodiscard]] double place_rms() const;
  [[nodiscard]] double turn_rms() const;

  /// Mean and standard deviation of x, y, theta over the answers that are no failures.
  [[nodiscard]] Eigen::Vector3d mean() const;
  [[nodiscard]] Eigen::Vector3d deviation() const;

  /// RMS over the bound's, same poses; nothing without bounds.
  [[nodiscard]] std::optional<double> bound_ratio() const;
  [[nodiscard]] std::optional<double> turn_bound_ratio() const;

  /// Mean normalised squared error per degree of freedom; nothing without covariances.
  [[nodiscard]] std::optional<double> nees() const;

  [[nodiscard]] double time_least() const;
  [[nodiscard]] double time_quantile(double share) const;

  /// Errors of x, y, theta of the answers that are no failures.
  [[nodiscard]] const std::vector<Eigen::Vector3d>& errors() const { return errors_; }

 private:
  std::size_t count_{0};
  std::size_t failures_{0};
  std::size_t silent_{0};
  std::vector<double> places_;
  std::vector<double> times_;
  std::vector<Eigen::Vector3d> errors_;
  Eigen::Vector2d bound_{Eigen::Vector2d::Zero()};
  double nees_{0.0};
  std::size_t nees_count_{0};
};

}  // namespace teamsight::locate_score
