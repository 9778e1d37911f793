// bench/locate_score/point_errors.cpp: see bench/locate_score/point_errors.hpp.
#include "bench/locate_score/point_errors.hpp"

#include <algorithm>
#include <cmath>

#include "vision/posture_fit.hpp"

namespace teamsight::locate_score {

namespace {

constexpr double kOnPaint = 0.15;  // m

}  // namespace

void PointErrors::add(const vision::LineMap& map,
                      const Pose<Field, Robot>& truth,
                      std::span<const vision::LinePoint> points,
                      double eye_height) {
  ++frames_;
  for (const vision::LinePoint& point : points) {
    const auto residual =
        vision::line_residual(map, truth, point, Eigen::Vector2d::Zero(), eye_height);
    if (std::abs(residual.distance) > kOnPaint) {
      ++off_paint_;
      continue;
    }
    distances_.push_back(std::abs(residual.distance));
    sum_squared_sizes_ += residual.distance * residual.distance / residual.var;
  }
}

double PointErrors::rms() const {
  if (distances_.empty()) return 0.0;
  double sum = 0.0;
  for (const double distance : distances_) sum += distance * distance;
  return std::sqrt(sum / static_cast<double>(distances_.size()));
}

double PointErrors::quantile(double share) const {
  if (distances_.empty()) return 0.0;
  std::vector<double> sorted = distances_;
  const auto last = static_cast<double>(sorted.size() - 1);
  const auto at = sorted.begin() + std::lround(share * last);
  std::nth_element(sorted.begin(), at, sorted.end());
  return *at;
}

std::optional<double> PointErrors::over_claimed() const {
  if (distances_.empty()) return std::nullopt;
  return std::sqrt(sum_squared_sizes_ / static_cast<double>(distances_.size()));
}

double PointErrors::points_per_frame() const {
  const auto all = static_cast<double>(distances_.size() + off_paint_);
  return frames_ == 0 ? 0.0 : all / static_cast<double>(frames_);
}

double PointErrors::share_off_paint() const {
  const std::size_t all = distances_.size() + off_paint_;
  return all == 0 ? 0.0 : static_cast<double>(off_paint_) / static_cast<double>(all);
}

}  // namespace teamsight::locate_score
