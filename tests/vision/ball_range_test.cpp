// tests/vision/ball_range_test.cpp: a ball's range by the floor and by its size, and which holds.
#include "vision/ball_range.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace teamsight::vision {
namespace {

constexpr double kRadius = 0.11;
constexpr double kEye = 0.75;

// To a ball's centre at this distance over the floor and this height.
BallRay ray_to(double distance, double height) {
  BallRay ray;
  ray.ray_R.origin = {0.0, 0.0, kEye};
  const Eigen::Vector3d way{distance, 0.0, height - kEye};
  ray.ray_R.direction = way.normalized();
  ray.cov_direction = Eigen::Vector2d(1e-5, 1e-5).asDiagonal();
  ray.angular_radius = std::asin(kRadius / way.norm());
  ray.sigma_angular_radius = 0.1 * ray.angular_radius;
  return ray;
}

TEST(BallRange, AgreesBothWaysForABallOnTheFloor) {
  const BallRange range = range_of(ray_to(2.0, kRadius));

  const double truth = std::hypot(2.0, kEye - kRadius);
  EXPECT_NEAR(range.on_floor, truth, 1e-9);
  EXPECT_NEAR(range.by_size, truth, 1e-9);
  EXPECT_NEAR(range.sigma_by_size, 0.1 * truth, 0.01 * truth);
  EXPECT_LT(range.flying_log_odds, -0.5);
}

TEST(BallRange, TakesTheSizesWordForABallInTheAir) {
  const BallRange range = range_of(ray_to(1.0, 0.55));

  EXPECT_NEAR(range.by_size, std::hypot(1.0, 0.2), 1e-9);
  EXPECT_GT(range.on_floor, 2.0 * range.by_size);
  EXPECT_GT(range.flying_log_odds, 3.0);
}

TEST(BallRange, KnowsThatNoBallLiesOnARayThatRises) {
  const BallRange range = range_of(ray_to(2.0, 0.9));

  EXPECT_EQ(range.on_floor, 0.0);
  EXPECT_GT(range.by_size, 0.0);
  EXPECT_GT(range.flying_log_odds, 3.0);
}

TEST(BallRange, SaysNothingOfFlyingWhereTheSizeIsNotMeasured) {
  BallRay ray = ray_to(2.0, kRadius);
  ray.angular_radius = 0.0;
  ray.sigma_angular_radius = 0.0;

  const BallRange range = range_of(ray);

  EXPECT_EQ(range.by_size, 0.0);
  EXPECT_EQ(range.flying_log_odds, 0.0);
  EXPECT_GT(range.sigma_on_floor, 0.0);
}

TEST(BallRange, KnowsHowWrongItMayBe) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0.0, 1.0);
  const double distance = 3.0;
  const double truth = std::hypot(distance, kEye - kRadius);
  double by_size = 0.0;
  double on_floor = 0.0;
  constexpr int kRounds = 2000;
  for (int i = 0; i < kRounds; ++i) {
    BallRay ray = ray_to(distance, kRadius);
    ray.sigma_angular_radius = 0.03 * ray.angular_radius;
    ray.angular_radius += ray.sigma_angular_radius * normal(random);
    const double sigma = std::hypot(0.0052, std::sqrt(1e-5));
    const double elevation = std::asin(ray.ray_R.direction.z()) + sigma * normal(random);
    ray.ray_R.direction = {std::cos(elevation), 0.0, std::sin(elevation)};
    const BallRange range = range_of(ray);
    by_size += std::pow((range.by_size - truth) / range.sigma_by_size, 2);
    on_floor += std::pow((range.on_floor - truth) / range.sigma_on_floor, 2);
  }

  EXPECT_NEAR(by_size / kRounds, 1.0, 0.1);
  EXPECT_NEAR(on_floor / kRounds, 1.0, 0.1);
}

TEST(BallRange, IsSeldomSureAndWrong) {
  std::mt19937 random(4);
  std::normal_distribution<double> normal(0.0, 1.0);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int wrong = 0;
  constexpr int kRounds = 2000;
  for (int i = 0; i < kRounds; ++i) {
    const bool flies = i % 2 == 0;
    const double height = flies ? kRadius + 0.5 * uniform(random) : kRadius;
    BallRay ray = ray_to(1.0 + 2.0 * uniform(random), height);
    ray.angular_radius += ray.sigma_angular_radius * normal(random);
    const double odds = range_of(ray).flying_log_odds;
    if (std::abs(odds) > 3.0 && (odds > 0.0) != flies) ++wrong;
  }

  // At odds of twenty to one, fewer than one in twenty.
  EXPECT_LT(wrong, kRounds / 20);
}

}  // namespace
}  // namespace teamsight::vision
