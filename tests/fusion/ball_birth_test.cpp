// tests/fusion/ball_birth_test.cpp: a ball that nobody has seen on the floor before.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "fusion/fusion.hpp"
#include "fusion/measurement.hpp"
#include "tests/fusion/scenario.hpp"
#include "tests/fusion/watch.hpp"

namespace teamsight::fusion {
namespace {

using test::at_second;
using test::Eye;
using test::kLeftOfBall;
using test::kRightOfBall;
using test::make_fusion;
using test::watch;

constexpr double kMirrorHeight = 0.8;  // m
constexpr double kRadius = 0.11;       // m

/// The ray of a robot that sees a ball there, with its size.
BallRay ray_to_ball(const Pose<Field, Robot>& X_FR, const Eigen::Vector3d& p_F) {
  const double c = std::cos(X_FR.theta());
  const double s = std::sin(X_FR.theta());
  const Eigen::Vector2d way = p_F.head<2>() - X_FR.origin().vector();
  const Eigen::Vector3d p_R(
      c * way.x() + s * way.y(), -s * way.x() + c * way.y(), p_F.z() - kMirrorHeight);
  BallRay ray;
  ray.ray_R.origin = {0.0, 0.0, kMirrorHeight};
  ray.ray_R.direction = p_R.normalized();
  ray.cov_direction = 2.5e-5 * Eigen::Matrix2d::Identity();
  ray.angular_radius = std::asin(kRadius / p_R.norm());
  ray.sigma_angular_radius = 0.1 * ray.angular_radius;
  ray.confidence = 0.9;
  return ray;
}

/// Kicked up at (-0.5, 0.5) m when the clock shows 0.
Eigen::Vector3d flying(double t) {
  return {-0.5 + 3.0 * t, 0.5, 0.3 + 6.5 * t - 0.5 * 9.81 * t * t};
}

/// What is made of a ball that these robots see from `from` to `to` s, above everybody's head.
Fusion watched(const std::vector<Pose<Field, Robot>>& robots, double from, double to) {
  Fusion fusion = make_fusion();
  std::vector<Eye> eyes;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    eyes.emplace_back(static_cast<RobotId>(i + 1), 11U * static_cast<std::uint32_t>(i + 1));
  }
  for (double t = from; t < to; t += 0.033) {
    for (std::size_t i = 0; i < robots.size(); ++i) {
      watch(fusion, eyes[i], robots[i], {t, t + 0.02}, [&](Eye& eye) {
        eye.frame().balls.push_back(ray_to_ball(robots[i], flying(t)));
      });
    }
  }
  return fusion;
}

TEST(BallBirth, ABallOverEverybodysHeadIsFollowedWhereTwoRobotsSeeIt) {
  const Fusion fusion = watched({kLeftOfBall, kRightOfBall}, 0.25, 0.65);

  const WorldModel world = fusion.world_at(at_second(0.65));

  ASSERT_EQ(world.balls.size(), 1U);
  EXPECT_LT((world.balls[0].p_FB.vector() - flying(0.65)).norm(), 0.15);
}

TEST(BallBirth, WhereOneSeesItItIsFollowedForASecondFirst) {
  EXPECT_TRUE(watched({kLeftOfBall}, 0.15, 0.9).world_at(at_second(0.9)).balls.empty());

  const WorldModel world = watched({kLeftOfBall}, 0.15, 1.25).world_at(at_second(1.25));

  ASSERT_EQ(world.balls.size(), 1U);
  EXPECT_LT((world.balls[0].p_FB.vector() - flying(1.25)).norm(), 0.3);
}

TEST(BallBirth, WhatHangsInTheAirIsSeldomTakenForABall) {
  Fusion fusion = make_fusion();
  Eye eye(1, 11);
  int listed = 0;
  for (int i = 0; i < 100; ++i) {
    const double t = 0.1 * i;
    watch(fusion, eye, kLeftOfBall, {t, t + 0.099}, [](Eye& e) {
      e.frame().balls.push_back(ray_to_ball(kLeftOfBall, {0.5, 0.5, 2.5}));
    });
    if (!fusion.world_at(at_second(t + 0.1)).balls.empty()) ++listed;
  }

  EXPECT_LT(listed, 10);
}

TEST(BallInSpace, ErrsAsItsDirectionAndSizeDo) {
  const Pose<Field, Robot> X_FR(0.0, 0.0, 0.0);
  BallRay ray = ray_to_ball(X_FR, {2.0, -1.0, 1.7});
  ray.cov_direction << 4e-4, 1e-4, 1e-4, 2e-4;
  const auto place = [&](double azimuth, double elevation, double radius) {
    const Eigen::Vector3d& d = ray.ray_R.direction;
    const double a = std::atan2(d.y(), d.x()) + azimuth;
    const double e = std::asin(d.z()) + elevation;
    BallRay moved = ray;
    moved.ray_R.direction << std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e);
    moved.angular_radius += radius;
    return ball_by_size(moved, kRadius)->p_R;
  };
  constexpr double kStep = 1e-6;
  Eigen::Matrix3d slope;
  slope << (place(kStep, 0, 0) - place(-kStep, 0, 0)) / (2.0 * kStep),
      (place(0, kStep, 0) - place(0, -kStep, 0)) / (2.0 * kStep),
      (place(0, 0, kStep) - place(0, 0, -kStep)) / (2.0 * kStep);
  Eigen::Matrix3d cov = Eigen::Matrix3d::Zero();
  cov.topLeftCorner<2, 2>() = ray.cov_direction;
  cov(2, 2) = std::pow(ray.sigma_angular_radius, 2);

  const auto ball = ball_by_size(ray, kRadius);

  ASSERT_TRUE(ball);
  EXPECT_TRUE(ball->p_R.isApprox(Eigen::Vector3d(2.0, -1.0, 1.7), 1e-9));
  EXPECT_TRUE(ball->cov.isApprox(slope * cov * slope.transpose(), 1e-6));
}

TEST(BallInSpace, IsNotToldWithoutASize) {
  BallRay ray = ray_to_ball({0.0, 0.0, 0.0}, {2.0, -1.0, 1.7});
  ray.sigma_angular_radius = 0.0;

  EXPECT_FALSE(ball_by_size(ray, kRadius));
}

}  // namespace
}  // namespace teamsight::fusion
