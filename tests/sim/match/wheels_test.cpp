// tests/sim/match/wheels_test.cpp: the wheels count the way, nearly.
#include "sim/match/wheels.hpp"

#include <numbers>

#include <gtest/gtest.h>

namespace teamsight::sim {
namespace {

// Faces +y and drives along +y: forward in R.
Player driving_left_in_F() {
  Player player;
  player.number = 1;
  player.X_FR = {0.0, 0.0, std::numbers::pi / 2.0};
  player.v_FR = {0.0, 1.0};
  player.wheels_F = player.v_FR;
  return player;
}

TEST(Wheels, CountForwardWhatIsForwardInR) {
  Wheels wheels({0.0, 0.0, 0.0, 0.0}, 1);
  for (int i = 0; i < 100; ++i) {
    wheels.roll(driving_left_in_F(), 0.01);
  }

  EXPECT_NEAR(wheels.pose().x(), 1.0, 1e-9);
  EXPECT_NEAR(wheels.pose().y(), 0.0, 1e-9);
  EXPECT_NEAR(wheels.velocity().x, 1.0, 1e-9);
}

TEST(Wheels, DriftApartWithDifferentSeedsOnly) {
  Wheels a({}, 1);
  Wheels same({}, 1);
  Wheels other({}, 2);
  for (int i = 0; i < 1000; ++i) {
    a.roll(driving_left_in_F(), 0.01);
    same.roll(driving_left_in_F(), 0.01);
    other.roll(driving_left_in_F(), 0.01);
  }

  EXPECT_EQ(a.pose(), same.pose());
  EXPECT_FALSE(a.pose() == other.pose());
  EXPECT_NEAR(a.pose().x(), 10.0, 1.0);
}

TEST(Wheels, CountWhatTheyTurnWhileTheBodyStands) {
  Player spinning = driving_left_in_F();
  spinning.v_FR = {0.0, 0.0};
  Wheels wheels({0.0, 0.0, 0.0, 0.0}, 1);

  wheels.roll(spinning, 0.1);

  EXPECT_NEAR(wheels.pose().x(), 0.1, 1e-9);
}

}  // namespace
}  // namespace teamsight::sim
