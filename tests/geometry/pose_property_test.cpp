// tests/geometry/pose_property_test.cpp: what holds for all poses.
#include <numbers>

#include <Eigen/LU>
#include <gmock/gmock.h>

#include "geometry/pose.hpp"
#include "geometry/uncertainty.hpp"
#include "tests/support/geometry_matchers.hpp"
#include "tests/support/property.hpp"

namespace teamsight {
namespace {

using testing_support::holds_for_all;
using testing_support::number;

using RobotPose = Pose<Field, Robot>;

constexpr double kTolerance = 1e-9;

RobotPose some_pose() {
  return {*number(-12.0, 12.0), *number(-9.0, 9.0), *number(-10.0, 10.0)};
}

template <class Frame>
Point<Frame> some_point() {
  return {*number(-20.0, 20.0), *number(-20.0, 20.0)};
}

template <class A, class B>
bool is_same(const Pose<A, B>& a, const Pose<A, B>& b) {
  return testing::Value(a, testing_support::IsPoseNear(b, kTolerance, kTolerance));
}

template <class Frame>
bool is_same(const Point<Frame>& a, const Point<Frame>& b) {
  return testing::Value(a, testing_support::IsNear(b, kTolerance));
}

Eigen::Matrix3d some_cov() {
  const Eigen::Matrix3d factor = Eigen::Matrix3d::NullaryExpr([](auto) { return *number(-1, 1); });
  return factor * factor.transpose() + 1e-3 * Eigen::Matrix3d::Identity();
}

TEST(PoseProperty, InverseLeadsBack) {
  holds_for_all(11, [] {
    const RobotPose X_FR = some_pose();
    const Point<Robot> p_R = some_point<Robot>();

    RC_ASSERT(is_same(X_FR.inverse() * (X_FR * p_R), p_R));
    RC_ASSERT(is_same(X_FR * X_FR.inverse(), Pose<Field, Field>()));
    RC_ASSERT(is_same(X_FR.inverse().inverse(), X_FR));
  });
}

TEST(PoseProperty, ProductIsOneAfterTheOther) {
  holds_for_all(12, [] {
    const RobotPose X_FR = some_pose();
    const RobotPose pose = some_pose();
    const Pose<Robot, Camera> X_RC(pose.x(), pose.y(), pose.theta());
    const Point<Camera> p_C = some_point<Camera>();

    RC_ASSERT(is_same((X_FR * X_RC) * p_C, X_FR * (X_RC * p_C)));
    RC_ASSERT(is_same((X_FR * X_RC).inverse(), X_RC.inverse() * X_FR.inverse()));
  });
}

TEST(PoseProperty, DistancesStay) {
  holds_for_all(13, [] {
    const RobotPose X_FR = some_pose();
    const Point<Robot> a = some_point<Robot>();
    const Point<Robot> b = some_point<Robot>();

    const double before = (a.vector() - b.vector()).norm();
    const double after = ((X_FR * a).vector() - (X_FR * b).vector()).norm();

    RC_ASSERT(std::abs(before - after) < kTolerance);
  });
}

TEST(PoseProperty, DirectionIsAlwaysWrapped) {
  holds_for_all(14, [] {
    const RobotPose product = some_pose() * Pose<Robot, Robot>(0.0, 0.0, *number(-1e4, 1e4));

    RC_ASSERT(product.theta() > -std::numbers::pi);
    RC_ASSERT(product.theta() <= std::numbers::pi);
  });
}

TEST(PoseProperty, MirroringTwiceChangesNothing) {
  holds_for_all(15, [] {
    const RobotPose X_FR = some_pose();
    const Point<Field> centre = some_point<Field>();

    RC_ASSERT(is_same(mirrored(mirrored(X_FR, centre), centre), X_FR));
  });
}

TEST(PoseProperty, MirroringTurnsWhatTheRobotSees) {
  holds_for_all(16, [] {
    const RobotPose X_FR = some_pose();
    const Point<Field> centre = some_point<Field>();
    const Point<Robot> p_R = some_point<Robot>();

    const Eigen::Vector2d turned = 2.0 * centre.vector() - (X_FR * p_R).vector();

    RC_ASSERT(is_same(mirrored(X_FR, centre) * p_R, Point<Field>::from(turned)));
  });
}

TEST(PoseProperty, TransformedCovarianceIsACovarianceAndNoSmaller) {
  holds_for_all(17, [] {
    const Eigen::Matrix3d cov_X = some_cov();
    const Eigen::Matrix2d cov_R = some_cov().topLeftCorner<2, 2>();

    const Eigen::Matrix2d cov =
        transform_covariance(some_pose(), cov_X, some_point<Robot>(), cov_R);

    RC_ASSERT(is_covariance(cov));
    RC_ASSERT(cov.determinant() >= cov_R.determinant());
  });
}

}  // namespace
}  // namespace teamsight
