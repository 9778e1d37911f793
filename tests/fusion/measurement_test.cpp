// tests/fusion/measurement_test.cpp: rays and feet become points in F with the right covariance.
#include "fusion/measurement.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "geometry/uncertainty.hpp"
#include "tests/fusion/scenario.hpp"

namespace teamsight::fusion {
namespace {

using test::Eye;
using test::kBallRadius;
using test::kMirrorHeight;

constexpr double kPi = std::numbers::pi;
constexpr double kStep = 1e-6;

BallRay ray_of(double azimuth, double elevation) {
  BallRay ray;
  ray.ray_R.origin = {0.02, -0.01, kMirrorHeight};
  ray.ray_R.direction = {std::cos(elevation) * std::cos(azimuth),
                         std::cos(elevation) * std::sin(azimuth),
                         std::sin(elevation)};
  ray.cov_direction << 4e-4, 1e-4, 1e-4, 9e-4;
  return ray;
}

PostureEstimate posture_of(const Pose<Field, Robot>& X_FR) {
  PostureEstimate posture;
  posture.status = PostureStatus::kOk;
  posture.X_FR = X_FR;
  posture.cov << 0.01, 0.002, 0.001, 0.002, 0.02, -0.001, 0.001, -0.001, 0.003;
  return posture;
}

Eigen::Vector2d place(double azimuth, double elevation, const Pose<Field, Robot>& X_FR) {
  return measure_ball(ray_of(azimuth, elevation), posture_of(X_FR), kBallRadius)->p_F;
}

TEST(BallMeasurement, LiesWhereTheRayMeetsTheBallsHeight) {
  Eye eye(1, 1);
  eye.look({1.0, -2.0, 0.7}, test::at_second(0.0));
  eye.see_ball({4.0, 1.5});

  const auto measured = measure_ball(eye.frame().balls.front(), eye.frame().posture, kBallRadius);

  ASSERT_TRUE(measured.has_value());
  EXPECT_NEAR(measured->p_F.x(), 4.0, 1e-9);
  EXPECT_NEAR(measured->p_F.y(), 1.5, 1e-9);
}

TEST(BallMeasurement, OfARayThatDoesNotComeDownIsNothing) {
  EXPECT_FALSE(ball_on_floor(ray_of(0.3, 0.0), kBallRadius).has_value());
  EXPECT_FALSE(ball_on_floor(ray_of(0.3, 0.4), kBallRadius).has_value());
  EXPECT_FALSE(ball_on_floor(ray_of(0.3, -0.001), kBallRadius).has_value());
}

TEST(BallMeasurement, OfARayFromBelowTheBallIsNothing) {
  BallRay ray = ray_of(0.3, -0.5);
  ray.ray_R.origin.z = 0.05;

  EXPECT_FALSE(ball_on_floor(ray, kBallRadius).has_value());
}

TEST(BallMeasurement, RangeSlopeIsTheDerivative) {
  for (const double elevation : {-0.05, -0.3, -1.0, -1.5}) {
    const double up = ball_on_floor(ray_of(0.0, elevation + kStep), kBallRadius)->range;
    const double down = ball_on_floor(ray_of(0.0, elevation - kStep), kBallRadius)->range;

    const double slope = range_slope(kMirrorHeight - kBallRadius, elevation);

    EXPECT_NEAR((up - down) / (2.0 * kStep), slope, 1e-5 * slope) << "at " << elevation;
  }
}

TEST(BallMeasurement, PolarJacobianIsTheDerivative) {
  for (const double azimuth : {0.0, 1e-9, 1.0, kPi / 2, kPi - 1e-9, -kPi + 1e-9, -2.0}) {
    const double range = 3.0;
    const auto point = [](double a, double r) {
      return Eigen::Vector2d(r * std::cos(a), r * std::sin(a));
    };
    Eigen::Matrix2d numeric;
    numeric.col(0) =
        (point(azimuth + kStep, range) - point(azimuth - kStep, range)) / (2.0 * kStep);
    numeric.col(1) =
        (point(azimuth, range + kStep) - point(azimuth, range - kStep)) / (2.0 * kStep);

    EXPECT_TRUE(polar_jacobian(azimuth, range).isApprox(numeric, 1e-8)) << "at " << azimuth;
  }
}

TEST(BallMeasurement, CovarianceIsThatOfNumericalDerivatives) {
  for (const double turn : {0.0, 2.0, kPi - 1e-7, -kPi + 1e-7}) {
    const double azimuth = turn;
    const double elevation = -0.2;
    const Pose<Field, Robot> X_FR(1.0, 2.0, -turn);
    Eigen::Matrix<double, 2, 5> numeric;
    const auto difference = [&](double da, double de, double dx, double dy, double dt) {
      const auto at = [&](double s) {
        return place(azimuth + s * da,
                     elevation + s * de,
                     {X_FR.x() + s * dx, X_FR.y() + s * dy, X_FR.theta() + s * dt});
      };
      return Eigen::Vector2d((at(kStep) - at(-kStep)) / (2.0 * kStep));
    };
    numeric << difference(1, 0, 0, 0, 0), difference(0, 1, 0, 0, 0), difference(0, 0, 1, 0, 0),
        difference(0, 0, 0, 1, 0), difference(0, 0, 0, 0, 1);
    Eigen::Matrix<double, 5, 5> cov = Eigen::Matrix<double, 5, 5>::Zero();
    cov.topLeftCorner<2, 2>() = ray_of(0.0, 0.0).cov_direction;
    cov.bottomRightCorner<3, 3>() = posture_of(X_FR).cov;

    const auto measured = measure_ball(ray_of(azimuth, elevation), posture_of(X_FR), kBallRadius);

    // The robot's turn acts about R's origin, two centimetres beside the mirror.
    const Eigen::Matrix2d expected = numeric * cov * numeric.transpose();
    EXPECT_TRUE(measured->cov_F.isApprox(expected, 1e-4)) << measured->cov_F << "\nexpected\n"
                                                          << expected << "\nat " << turn;
  }
}

TEST(BallMeasurement, ApparentSizeNarrowsTheRange) {
  BallRay ray = ray_of(0.5, -0.2);
  const PolarBall plain = *ball_on_floor(ray, kBallRadius);
  const double slant = (kMirrorHeight - kBallRadius) / std::sin(0.2);
  ray.angular_radius = std::asin(kBallRadius / slant);
  ray.sigma_angular_radius = 0.003;

  const PolarBall sized = *ball_on_floor(ray, kBallRadius);

  EXPECT_NEAR(sized.range, plain.range, 1e-9);
  EXPECT_LT(sized.cov(1, 1), 0.9 * plain.cov(1, 1));
  EXPECT_TRUE(is_covariance(sized.cov));
}

TEST(BallMeasurement, SizeThatContradictsTheFloorWidensTheRangeInstead) {
  BallRay ray = ray_of(0.5, -0.2);
  const PolarBall plain = *ball_on_floor(ray, kBallRadius);
  ray.angular_radius = std::asin(kBallRadius / 1.2);  // 1.2 m away on a ray of 3.5 m: in the air
  ray.sigma_angular_radius = 0.001;

  const PolarBall sized = *ball_on_floor(ray, kBallRadius);

  const double gap = plain.range - 1.2 * std::cos(0.2);
  EXPECT_DOUBLE_EQ(sized.range, plain.range);
  EXPECT_NEAR(sized.cov(1, 1), plain.cov(1, 1) + gap * gap, 1e-9);
}

TEST(BallMeasurement, StraightBelowTheMirrorStillHasACovariance) {
  const auto measured =
      measure_ball(ray_of(0.5, -kPi / 2 + 1e-9), posture_of({0.0, 0.0, 0.0}), kBallRadius);

  ASSERT_TRUE(measured.has_value());
  EXPECT_TRUE(is_covariance(measured->cov_F));
}

TEST(ObstacleMeasurement, IsTheCentreBehindTheFoot) {
  Eye eye(1, 1);
  eye.look({1.0, -2.0, 2.7}, test::at_second(0.0));
  eye.see_obstacle({-3.0, 1.5});
  const ObstacleSighting& sighting = eye.frame().obstacles.front();

  const auto measured = measure_obstacle(sighting, eye.frame().posture, radius_of(sighting, 0.2));

  EXPECT_NEAR(measured.p_F.x(), -3.0, 1e-9);
  EXPECT_NEAR(measured.p_F.y(), 1.5, 1e-9);
  EXPECT_TRUE(is_covariance(measured.cov_F));
}

TEST(ObstacleMeasurement, UsesTheFallbackRadiusWhenTheWidthCannotBeARobots) {
  ObstacleSighting sighting;
  sighting.width = 0.0;
  EXPECT_DOUBLE_EQ(radius_of(sighting, 0.25), 0.25);

  sighting.width = 3.0;
  EXPECT_DOUBLE_EQ(radius_of(sighting, 0.25), 0.25);

  sighting.width = 0.4;
  EXPECT_DOUBLE_EQ(radius_of(sighting, 0.25), 0.2);
}

}  // namespace
}  // namespace teamsight::fusion
