// tests/examples/attacker_test.cpp: who goes to the ball.
#include "examples/behaviour/attacker.hpp"

#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

namespace behaviour {
namespace {

using teamsight::RobotId;
using teamsight::WorldModel;
using teamsight::WorldTeammate;

WorldTeammate mate(RobotId robot, double x, double y, double theta) {
  WorldTeammate teammate;
  teammate.robot = robot;
  teammate.status = teamsight::PostureStatus::kOk;
  teammate.X_FR = {x, y, theta};
  teammate.trust = 1.0;
  return teammate;
}

WorldModel world_with_ball() {
  WorldModel world;
  world.balls.emplace_back();
  return world;
}

TEST(ChooseAttacker, TakesTheNearest) {
  WorldModel world = world_with_ball();
  world.teammates = {mate(1, -6.0, 0.0, 0.0), mate(2, -3.0, 0.0, 0.0)};

  const auto attacker = choose_attacker(world);

  ASSERT_TRUE(attacker.has_value());
  EXPECT_EQ(attacker->robot, 2);
  EXPECT_NEAR(attacker->time_to_ball, 1.0, 1e-9);
}

TEST(ChooseAttacker, CountsTheTurn) {
  WorldModel world = world_with_ball();
  world.teammates = {mate(1, -3.0, 0.0, std::numbers::pi), mate(2, -3.3, 0.0, 0.0)};

  EXPECT_EQ(choose_attacker(world)->robot, 2);
}

TEST(ChooseAttacker, TellsEquallyQuickOnesApartById) {
  WorldModel world = world_with_ball();
  world.teammates = {mate(4, 3.0, 0.0, 0.0), mate(2, 3.0, 0.0, 0.0)};
  const auto one = choose_attacker(world);
  std::reverse(world.teammates.begin(), world.teammates.end());

  EXPECT_EQ(one->robot, 2);
  EXPECT_EQ(choose_attacker(world)->robot, 2);
}

TEST(ChooseAttacker, LeavesOutTheUntrustedAndTheSilent) {
  WorldModel world = world_with_ball();
  world.teammates = {mate(1, -1.0, 0.0, 0.0), mate(2, -2.0, 0.0, 0.0), mate(3, -9.0, 0.0, 0.0)};
  world.teammates[0].trust = 0.0;
  world.teammates[1].age = std::chrono::seconds(1);

  EXPECT_EQ(choose_attacker(world)->robot, 3);
}

TEST(ChooseAttacker, IsNobodyWithoutABallOrATeam) {
  WorldModel no_ball;
  no_ball.teammates = {mate(1, 0.0, 0.0, 0.0)};

  EXPECT_FALSE(choose_attacker(no_ball).has_value());
  EXPECT_FALSE(choose_attacker(world_with_ball()).has_value());
}

}  // namespace
}  // namespace behaviour
