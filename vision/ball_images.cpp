// vision/ball_images.cpp: where two rays pass each other.
#include "vision/ball_images.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include <Eigen/Core>
#include <Eigen/LU>

namespace teamsight::vision {

namespace {

constexpr double kSure = 2.0;         // sigmas
constexpr double kMostOddSize = 1.6;  // the ratio of a ball's size where the rays meet to that seen

/// Where two rays are nearest to each other.
struct Passing {
  double along_a{0.0};  ///< m
  double along_b{0.0};  ///< m
  double gap{0.0};      ///< m
};

std::optional<Passing> passing_of(const Ray<Robot>& a, const Ray<Robot>& b) {
  const Eigen::Vector3d between = b.origin.vector() - a.origin.vector();
  const double cosine = a.direction.dot(b.direction);
  const double square = 1.0 - cosine * cosine;
  if (square < 1e-9) return std::nullopt;
  const double on_a = between.dot(a.direction);
  const double on_b = between.dot(b.direction);
  Passing passing;
  passing.along_a = (on_a - cosine * on_b) / square;
  passing.along_b = (cosine * on_a - on_b) / square;
  passing.gap = (between + passing.along_b * b.direction - passing.along_a * a.direction).norm();
  return passing;
}

double sigma_of(const BallRay& ball) {
  const double level = ball.ray_R.direction.head<2>().norm();
  return std::max(level * std::sqrt(ball.cov_direction(0, 0)), std::sqrt(ball.cov_direction(1, 1)));
}

bool has_size_at(const BallRay& ball, double range, double ball_radius) {
  if (range <= ball_radius) return false;
  const double ratio = std::asin(ball_radius / range) / ball.angular_radius;
  const double most = kMostOddSize + kSure * ball.sigma_angular_radius / ball.angular_radius;
  return ratio < most && ratio > 1.0 / most;
}

double variance_of(const BallRay& ball) {
  return ball.cov_direction.determinant();
}

}  // namespace

bool are_images_of_one(const BallCandidate& a, const BallCandidate& b, double ball_radius) {
  if (a.pixels.mirror_part == b.pixels.mirror_part) return false;
  if (a.ray.angular_radius <= 0.0 || b.ray.angular_radius <= 0.0) return false;
  const auto passing = passing_of(a.ray.ray_R, b.ray.ray_R);
  if (!passing || passing->along_a <= 0.0 || passing->along_b <= 0.0) return false;
  const double sigma =
      std::hypot(passing->along_a * sigma_of(a.ray), passing->along_b * sigma_of(b.ray));
  return passing->gap < ball_radius + kSure * sigma &&
         has_size_at(a.ray, passing->along_a, ball_radius) &&
         has_size_at(b.ray, passing->along_b, ball_radius);
}

void join_images(std::vector<BallCandidate>& found, double ball_radius) {
  for (std::size_t i = 0; i < found.size(); ++i) {
    for (std::size_t k = found.size() - 1; k > i; --k) {
      if (!are_images_of_one(found[i], found[k], ball_radius)) continue;
      const double confidence = std::max(found[i].ray.confidence, found[k].ray.confidence);
      if (variance_of(found[k].ray) < variance_of(found[i].ray)) found[i] = found[k];
      found[i].ray.confidence = confidence;
      found.erase(found.begin() + static_cast<std::ptrdiff_t>(k));
    }
  }
}

}  // namespace teamsight::vision
