// bench/locate_score/spoils.cpp: hidden paint, false white, a leaning head, an eye's remainder.
#include "bench/locate_score/spoils.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include <Eigen/Geometry>

namespace teamsight::locate_score {

namespace {

constexpr double kFaultRange = 6.0;   // m, at which a bend is given
constexpr double kLeanSigma = 0.007;  // rad

// The covariance of the point whose distance comes nearest, turned to this direction.
Eigen::Matrix2d cov_at(std::span<const vision::LinePoint> points, const Point<Robot>& p_R) {
  const double distance = p_R.vector().norm();
  const auto like = std::ranges::min_element(points, {}, [distance](const vision::LinePoint& one) {
    return std::abs(one.p_R.vector().norm() - distance);
  });
  const double turn = std::atan2(p_R.y, p_R.x) - std::atan2(like->p_R.y, like->p_R.x);
  const Eigen::Matrix2d rotation = Eigen::Rotation2Dd(turn).toRotationMatrix();
  return rotation * like->cov_R * rotation.transpose();
}

// Where a floor point is seen by a head that leans. @param tilt  roll, pitch; rad
Point<Robot> leaning(const Point<Robot>& p_R, const Eigen::Vector2d& tilt, double eye_height) {
  const double lift = (tilt.x() * p_R.y - tilt.y() * p_R.x) / eye_height;
  return {p_R.x / (1.0 + lift), p_R.y / (1.0 + lift)};
}

}  // namespace

Spoil hide(double share) {
  return [share](auto& points, const Pose<Field, Robot>& truth, std::mt19937& random) {
    const auto salt = static_cast<std::uint32_t>(random());
    std::erase_if(points, [&](const vision::LinePoint& point) {
      const Point<Field> p = truth * point.p_R;
      const auto cell = static_cast<std::uint32_t>(static_cast<int>(std::floor(p.x)) * 7919 +
                                                   static_cast<int>(std::floor(p.y)) * 104729);
      std::minstd_rand hash(1U + ((cell ^ salt) & 0x7fffffffU));
      hash.discard(3);
      const double drawn =
          static_cast<double>(hash()) / static_cast<double>(std::minstd_rand::max());
      return drawn < share;
    });
  };
}

Spoil falsify(double share) {
  return [share](auto& points, const Pose<Field, Robot>& /*truth*/, std::mt19937& random) {
    if (points.empty()) return;
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const std::size_t honest = points.size();
    const auto more = static_cast<std::size_t>(static_cast<double>(honest) * share / (1.0 - share));
    for (std::size_t i = 0; i < more; ++i) {
      vision::LinePoint point = points[i % honest];
      const double r = kFaultRange * std::sqrt(unit(random));
      const double a = 2.0 * std::numbers::pi * unit(random);
      point.p_R = {r * std::cos(a), r * std::sin(a)};
      point.cov_R = cov_at({points.data(), honest}, point.p_R);
      points.push_back(point);
    }
  };
}

Spoil lean(double eye_height) {
  return [eye_height](auto& points, const Pose<Field, Robot>& /*truth*/, std::mt19937& random) {
    std::normal_distribution<double> normal(0.0, kLeanSigma);
    const double roll = normal(random);
    const double pitch = normal(random);
    for (vision::LinePoint& point : points) {
      point.p_R = leaning(point.p_R, {roll, pitch}, eye_height);
    }
  };
}

Eye::Eye(const CalibrationRemainder& remainder, double eye_height, std::mt19937& random)
    : eye_height_(eye_height) {
  std::normal_distribution<double> normal;
  fault_ = {remainder.shift * normal(random),
            remainder.shift * normal(random),
            remainder.turn * normal(random),
            remainder.scale * normal(random),
            remainder.bend * normal(random)};
  const double roll = remainder.tilt * normal(random);
  const double pitch = remainder.tilt * normal(random);
  tilt_ = {roll, pitch};
}

void Eye::look(std::vector<vision::LinePoint>& points, const Eigen::Vector2d& lean) const {
  for (vision::LinePoint& point : points) {
    point.p_R = fault_.seen(leaning(point.p_R, tilt_ + lean, eye_height_), kFaultRange);
  }
  std::erase_if(points, [](const auto& p) { return p.p_R.vector().norm() > kFaultRange; });
}

}  // namespace teamsight::locate_score
