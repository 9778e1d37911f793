// tests/geometry/pose_test.cpp: poses, their products, and covariances through them.
#include "geometry/pose.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Cholesky>
#include <gmock/gmock.h>

#include "tests/support/geometry_matchers.hpp"

namespace teamsight {
namespace {

using testing_support::IsMatrixNear;
using testing_support::IsNear;
using testing_support::IsPoseNear;

constexpr double kPi = std::numbers::pi;
using RobotPose = Pose<Field, Robot>;

TEST(Pose, TurnsAPointOfTheRobotIntoThefield) {
  const RobotPose X_FR(1.0, 2.0, 0.5 * kPi);

  EXPECT_THAT(X_FR * (Point<Robot>{3.0, 1.0}), IsNear(Point<Field>{0.0, 5.0}, 1e-12));
}

TEST(Pose, LeavesHeightsAlone) {
  const RobotPose X_FR(1.0, 2.0, kPi);

  const Point3<Field> p_FB = X_FR * Point3<Robot>{1.0, 0.0, 0.7};

  EXPECT_THAT(p_FB, IsNear(Point3<Field>{0.0, 2.0, 0.7}, 1e-12));
}

TEST(Pose, TurnsVelocitiesWithoutMovingThem) {
  const RobotPose X_FR(10.0, 20.0, -0.5 * kPi);

  EXPECT_THAT(X_FR * (Velocity<Robot>{1.0, 0.0}), IsNear(Velocity<Field>{0.0, -1.0}, 1e-12));
}

TEST(Pose, CarriesARayAlong) {
  const RobotPose X_FR(1.0, 0.0, 0.5 * kPi);
  const Ray<Robot> ray_R{{0.1, 0.0, 0.8}, {0.6, 0.0, -0.8}};

  const Ray<Field> ray_F = X_FR * ray_R;

  EXPECT_THAT(ray_F.origin, IsNear(Point3<Field>{1.0, 0.1, 0.8}, 1e-12));
  EXPECT_THAT(ray_F.direction, IsMatrixNear(Eigen::Vector3d(0.0, 0.6, -0.8), 1e-12));
}

TEST(Pose, WrapsItsDirection) {
  EXPECT_NEAR(RobotPose(0.0, 0.0, 3.5 * kPi).theta(), -0.5 * kPi, 1e-12);
  EXPECT_EQ(RobotPose(0.0, 0.0, -kPi).theta(), kPi);
}

TEST(Mirrored, TurnsHalfAboutTheCentreOfAShiftedField) {
  const RobotPose X_FR(2.0, 0.5, 0.25 * kPi);

  EXPECT_THAT(mirrored(X_FR, {1.0, 0.5}),
              IsPoseNear(RobotPose(0.0, 0.5, -0.75 * kPi), 1e-12, 1e-12));
}

// ---- covariances -------------------------------------------------------------------------------

const Eigen::Matrix2d kCovR = (Eigen::Matrix2d() << 0.04, 0.01, 0.01, 0.09).finished();
const Eigen::Matrix3d kCovX =
    (Eigen::Matrix3d() << 0.010, 0.002, 0.001, 0.002, 0.020, -0.003, 0.001, -0.003, 0.005)
        .finished();

// d(X_FR p_R)/d(x, y, theta) by central differences.
Eigen::Matrix<double, 2, 3> numeric_jacobian(const RobotPose& X_FR, const Point<Robot>& p_R) {
  constexpr double kStep = 1e-6;
  Eigen::Matrix<double, 2, 3> jacobian;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(i);
    const auto moved = [&](const Eigen::Vector3d& x) {
      return (RobotPose(x(0), x(1), x(2)) * p_R).vector();
    };
    jacobian.col(i) = (moved(X_FR.vector() + step) - moved(X_FR.vector() - step)) / (2.0 * kStep);
  }
  return jacobian;
}

TEST(TransformCovariance, AgreesWithNumericDifferentiationAlsoNearPi) {
  const Point<Robot> p_R{2.0, -1.5};

  for (const double theta : {0.0, 1e-9, 0.7, -2.0, kPi, -kPi + 1e-9, kPi - 1e-9}) {
    const RobotPose X_FR(3.0, -1.0, theta);
    const auto jacobian = numeric_jacobian(X_FR, p_R);
    const Eigen::Matrix2d rotation = X_FR.rotation();
    const Eigen::Matrix2d expected =
        rotation * kCovR * rotation.transpose() + jacobian * kCovX * jacobian.transpose();

    EXPECT_THAT(transform_covariance(X_FR, kCovX, p_R, kCovR), IsMatrixNear(expected, 1e-8))
        << "theta " << theta;
  }
}

TEST(TransformCovariance, AgreesWithRandomDraws) {
  constexpr int kDraws = 20000;
  constexpr double kSmall = 0.01;  // of the angle's variance: the formula is of first order
  const RobotPose X_FR(1.0, 2.0, 3.0);
  const Point<Robot> p_R{1.0, 0.5};
  const Eigen::Matrix3d chol_X = (kSmall * kCovX).llt().matrixL();
  const Eigen::Matrix2d chol_R = (kSmall * kCovR).llt().matrixL();
  std::mt19937 random(7);
  std::normal_distribution<double> normal;

  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (int i = 0; i < kDraws; ++i) {
    const auto draw = [&](double) {
      return normal(random);
    };
    const Eigen::Vector3d x =
        X_FR.vector() + chol_X * Eigen::Vector3d::NullaryExpr([&](auto) { return draw(0.0); });
    const Eigen::Vector2d p =
        p_R.vector() + chol_R * Eigen::Vector2d::NullaryExpr([&](auto) { return draw(0.0); });
    const Eigen::Vector2d error =
        (RobotPose(x(0), x(1), x(2)) * Point<Robot>::from(p)).vector() - (X_FR * p_R).vector();
    spread += error * error.transpose() / kDraws;
  }

  const Eigen::Matrix2d cov = transform_covariance(X_FR, kSmall * kCovX, p_R, kSmall * kCovR);
  // A sample variance of n draws has a relative sigma of sqrt(2/n) = 1 %; four of those.
  EXPECT_THAT(spread, IsMatrixNear(cov, 0.04 * cov.trace()));
}

TEST(TransformCovariance, OfACertainPoseOnlyTurns) {
  const Eigen::Matrix2d cov = transform_covariance(
      RobotPose(5.0, 5.0, 0.5 * kPi), Eigen::Matrix3d::Zero(), {3.0, 3.0}, kCovR);

  EXPECT_THAT(cov, IsMatrixNear((Eigen::Matrix2d() << 0.09, -0.01, -0.01, 0.04).finished(), 1e-12));
}

}  // namespace
}  // namespace teamsight
