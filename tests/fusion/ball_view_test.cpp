// tests/fusion/ball_view_test.cpp: what a ray says of a ball in space, and its slopes.
#include "fusion/ball_view.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/angle.hpp"

namespace teamsight::fusion {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kStep = 1e-6;
constexpr double kRadius = 0.11;

BallRay ray_towards(double azimuth, double elevation) {
  BallRay ray;
  ray.ray_R.origin = {0.02, -0.01, 0.8};
  ray.ray_R.direction = {std::cos(elevation) * std::cos(azimuth),
                         std::cos(elevation) * std::sin(azimuth),
                         std::sin(elevation)};
  ray.cov_direction << 4e-6, 0.0, 0.0, 9e-6;
  ray.angular_radius = 0.03;
  ray.sigma_angular_radius = 0.003;
  return ray;
}

BallObserver observer_at(const Pose<Field, Robot>& X_FR) {
  BallObserver observer;
  observer.posture.status = PostureStatus::kOk;
  observer.posture.X_FR = X_FR;
  observer.posture.cov = Eigen::Vector3d(0.01, 0.02, 0.003).asDiagonal();
  observer.place = 0;
  observer.ball_radius = kRadius;
  return observer;
}

/// How the gap changes from one view to the next; the azimuth may wrap.
Eigen::Vector3d change(const ConsideredView<6, 3>& to, const ConsideredView<6, 3>& from) {
  Eigen::Vector3d change = to.gap - from.gap;
  change(0) = wrap_angle(change(0));
  return change;
}

struct Look {
  BallVector ball;
  BallObserver observer;
};

/// Near and far, on the floor and in the air, straight ahead and right behind.
std::vector<Look> looks() {
  std::vector<Look> looks;
  for (const double theta : {0.0, 0.7, kPi - 1e-9, -2.0}) {
    const BallObserver observer = observer_at({1.0, -2.0, theta});
    for (const double azimuth : {0.0, 1.2, kPi - 1e-9, -kPi + 1e-9}) {
      for (const double range : {0.5, 5.0}) {
        BallVector ball;
        ball << 1.0 + range * std::cos(theta + azimuth), -2.0 + range * std::sin(theta + azimuth),
            range < 1.0 ? kRadius : 1.5, 1.0, -2.0, 0.5;
        looks.push_back({ball, observer});
      }
    }
  }
  return looks;
}

TEST(BallView, ItsSlopeByTheBallIsTheDerivative) {
  const BallRay ray = ray_towards(0.3, -0.2);
  for (const Look& look : looks()) {
    const auto view = view_of_ball(look.ball, ray, look.observer);

    for (int i = 0; i < 6; ++i) {
      const BallVector step = kStep * BallVector::Unit(i);
      const Eigen::Vector3d slope = change(view_of_ball(look.ball - step, ray, look.observer),
                                           view_of_ball(look.ball + step, ray, look.observer)) /
                                    (2.0 * kStep);
      EXPECT_LT((slope - view.slope.col(i)).norm(), 1e-6) << "by component " << i;
    }
  }
}

TEST(BallView, ItsSlopeByTheObserversErrorsIsTheDerivative) {
  const BallRay ray = ray_towards(0.3, -0.2);
  for (const Look& look : looks()) {
    const auto view = view_of_ball(look.ball, ray, look.observer);

    for (int i = 0; i < 4; ++i) {
      Look less = look;
      Look more = look;
      less.observer.errors(i) -= kStep;
      more.observer.errors(i) += kStep;
      const Eigen::Vector3d slope = change(view_of_ball(less.ball, ray, less.observer),
                                           view_of_ball(more.ball, ray, more.observer)) /
                                    (2.0 * kStep);
      EXPECT_LT((slope - view.slope_errors.col(i)).norm(), 1e-6) << "by error " << i;
    }
  }
}

TEST(BallView, IsTheLessSureTheMoreThePostureErrsAnew) {
  const Look look = looks()[1];
  BallObserver shaking = look.observer;
  shaking.cov_fresh = look.observer.posture.cov;

  const auto steady = view_of_ball(look.ball, ray_towards(0.0, -0.1), look.observer);
  const auto shaken = view_of_ball(look.ball, ray_towards(0.0, -0.1), shaking);

  EXPECT_GT(shaken.cov(0, 0), steady.cov(0, 0) + 0.003);  // the heading's variance, and the place's
}

TEST(BallView, WithoutAnAngularRadiusSaysNothingAboutIt) {
  const Look look = looks()[1];
  BallRay ray = ray_towards(0.0, -0.1);
  ray.angular_radius = 0.0;

  const auto view = view_of_ball(look.ball, ray, look.observer);

  EXPECT_EQ(view.gap(2), 0.0);
  EXPECT_GT(view.cov(2, 2), 1.0);
}

}  // namespace
}  // namespace teamsight::fusion
