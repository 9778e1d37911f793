// tests/support/geometry_matchers.hpp: geometry compared with words: both values and their
// distance.
#pragma once

#include <ostream>

#include <Eigen/Core>
#include <gmock/gmock.h>

#include "geometry/angle.hpp"
#include "geometry/frames.hpp"
#include "geometry/pose.hpp"

namespace teamsight {

template <class Frame>
void PrintTo(const Point<Frame>& p, std::ostream* out) {
  *out << "(" << p.x << ", " << p.y << ") m";
}

template <class Frame>
void PrintTo(const Point3<Frame>& p, std::ostream* out) {
  *out << "(" << p.x << ", " << p.y << ", " << p.z << ") m";
}

template <class Frame>
void PrintTo(const Velocity<Frame>& v, std::ostream* out) {
  *out << "(" << v.x << ", " << v.y << ") m/s";
}

template <class A, class B>
void PrintTo(const Pose<A, B>& X, std::ostream* out) {
  *out << "(" << X.x() << " m, " << X.y() << " m, " << X.theta() << " rad)";
}

namespace testing_support {

/// Points, points in space and velocities: no further apart than `tolerance` (their own unit).
// NOLINTNEXTLINE: the macro of gmock expands to what clang-tidy does not like
MATCHER_P2(IsNear, expected, tolerance, "") {
  const double distance = (arg.vector() - expected.vector()).norm();
  *result_listener << "which is " << distance << " away from " << testing::PrintToString(expected);
  return distance <= tolerance;
}

/// Poses: origins no further apart than `tolerance_m`, directions no more than `tolerance_rad`,
/// the shorter way round.
// NOLINTNEXTLINE: the macro of gmock expands to what clang-tidy does not like
MATCHER_P3(IsPoseNear, expected, tolerance_m, tolerance_rad, "") {
  const double distance = (arg.origin().vector() - expected.origin().vector()).norm();
  const double turn = angle_difference(arg.theta(), expected.theta());
  *result_listener << "which is " << distance << " m and " << turn << " rad away from "
                   << testing::PrintToString(expected);
  return distance <= tolerance_m && std::abs(turn) <= tolerance_rad;
}

/// Eigen matrices and vectors: largest difference of an element no more than `tolerance`.
// NOLINTNEXTLINE: the macro of gmock expands to what clang-tidy does not like
MATCHER_P2(IsMatrixNear, expected, tolerance, "") {
  const double distance = (arg - expected).cwiseAbs().maxCoeff();
  *result_listener << "which differs by up to " << distance << " from\n" << expected;
  return distance <= tolerance;
}

}  // namespace testing_support
}  // namespace teamsight
