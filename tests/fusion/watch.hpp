// tests/fusion/watch.hpp: two robots that look at one ball for a while.
#pragma once

#include <chrono>
#include <cmath>

#include <gtest/gtest.h>

#include "fusion/fusion.hpp"
#include "tests/fusion/scenario.hpp"

namespace teamsight::fusion::test {

inline const Pose<Field, Robot> kLeftOfBall(-2.0, 0.0, 0.0);
inline const Pose<Field, Robot> kRightOfBall(3.0, 1.0, 2.0);
inline const Point<Field> kBall{1.0, 0.5};

inline Fusion make_fusion() {
  return Fusion(Parameters{}, plain_field());
}

inline void see_the_ball(Eye& eye) {
  eye.see_ball(kBall);
}

/// From one instant up to another; s.
struct Stretch {
  double from{0.0};
  double to{0.0};
};

/// One frame every 33 ms in [from, to); `see` adds what is seen.
template <class See>
void watch(
    Fusion& fusion, Eye& eye, const Pose<Field, Robot>& X_FR, const Stretch& stretch, See see) {
  constexpr double kPeriod = 0.033;  // s
  const int frames = static_cast<int>(std::ceil((stretch.to - stretch.from) / kPeriod - 1e-9));
  for (int i = 0; i < frames; ++i) {
    const double t = stretch.from + kPeriod * i;
    eye.look(X_FR, at_second(t));
    see(eye);
    EXPECT_EQ(fusion.insert(eye.frame(), at_second(t + 0.01)), Intake::kAccepted);
  }
}

}  // namespace teamsight::fusion::test
