// bench/locate_score/tally.cpp: sums, quantiles, Wilson's interval.
#include "bench/locate_score/tally.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"
#include "geometry/uncertainty.hpp"

namespace teamsight::locate_score {

namespace {

constexpr double kFarPlace = 0.5;  // m
constexpr double kFarTurn = 0.35;  // rad

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto at = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
  return values[at];
}

Eigen::Vector3d error_of(const Pose<Field, Robot>& X_FR, const Pose<Field, Robot>& truth) {
  Eigen::Vector3d error = X_FR.vector() - truth.vector();
  error.z() = wrap_angle(error.z());
  return error;
}

}  // namespace

Interval wilson(std::size_t hits, std::size_t tries) {
  if (tries == 0) return {};
  constexpr double kZ = 1.959964;
  const auto n = static_cast<double>(tries);
  const double p = static_cast<double>(hits) / n;
  const double scale = 1.0 / (1.0 + kZ * kZ / n);
  const double middle = scale * (p + kZ * kZ / (2.0 * n));
  const double half = scale * kZ * std::sqrt(p * (1.0 - p) / n + kZ * kZ / (4.0 * n * n));
  return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

void Tally::add(const Answer& answer,
                const Pose<Field, Robot>& truth,
                const Eigen::Vector2d& bound,
                const std::optional<Point<Field>>& centre) {
  ++count_;
  times_.push_back(answer.time_ms);
  if (!answer.X_FR) {
    ++silent_;
    ++failures_;
    return;
  }
  Eigen::Vector3d error = error_of(*answer.X_FR, truth);
  Eigen::Vector3d sides = Eigen::Vector3d::Ones();
  if (centre) {
    const Pose<Field, Robot> image = mirrored(truth, *centre);
    const Eigen::Vector3d other = error_of(*answer.X_FR, image);
    if (other.head<2>().norm() + std::abs(other.z()) <
        error.head<2>().norm() + std::abs(error.z())) {
      error = other;
      sides.head<2>() *= -1.0;  // as the truth's own half would have it
    }
  }
  error = error.cwiseProduct(sides);
  places_.push_back(error.head<2>().norm());
  if (error.head<2>().norm() > kFarPlace || std::abs(error.z()) > kFarTurn) {
    ++failures_;
    return;
  }
  errors_.push_back(error);
  bound_ += bound;
  if (answer.cov && is_covariance(*answer.cov)) {
    const Eigen::Matrix3d cov = sides.asDiagonal() * *answer.cov * sides.asDiagonal();
    nees_ += squared_mahalanobis(error, cov) / 3.0;
    ++nees_count_;
  }
}

double Tally::place_quantile(double share) const {
  return quantile(places_, share);
}

double Tally::place_rms() const {
  double sum = 0.0;
  for (const auto& error : errors_) sum += error.head<2>().squaredNorm();
  return errors_.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(errors_.size()));
}

double Tally::turn_rms() const {
  double sum = 0.0;
  for (const auto& error : errors_) sum += error.z() * error.z();
  return errors_.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(errors_.size()));
}

Eigen::Vector3d Tally::mean() const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& error : errors_) sum += error;
  return errors_.empty() ? sum : Eigen::Vector3d(sum / static_cast<double>(errors_.size()));
}

Eigen::Vector3d Tally::deviation() const {
  const Eigen::Vector3d middle = mean();
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& error : errors_) sum += (error - middle).cwiseAbs2();
  if (errors_.size() < 2) return Eigen::Vector3d::Zero();
  return (sum / static_cast<double>(errors_.size() - 1)).cwiseSqrt();
}

std::optional<double> Tally::bound_ratio() const {
  if (!(bound_.x() > 0.0) || errors_.empty()) return std::nullopt;
  return place_rms() / std::sqrt(bound_.x() / static_cast<double>(errors_.size()));
}

std::optional<double> Tally::turn_bound_ratio() const {
  if (!(bound_.y() > 0.0) || errors_.empty()) return std::nullopt;
  return turn_rms() / std::sqrt(bound_.y() / static_cast<double>(errors_.size()));
}

std::optional<double> Tally::nees() const {
  if (nees_count_ == 0) return std::nullopt;
  return nees_ / static_cast<double>(nees_count_);
}

double Tally::time_least() const {
  return times_.empty() ? 0.0 : *std::ranges::min_element(times_);
}

double Tally::time_quantile(double share) const {
  return quantile(times_, share);
}

}  // namespace teamsight::locate_score
