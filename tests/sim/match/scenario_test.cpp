// tests/sim/match/scenario_test.cpp: every scenario shows what its name says.
#include "sim/match/scenario.hpp"

#include <algorithm>
#include <functional>

#include <gtest/gtest.h>

#include "tests/sim/match/fields.hpp"

namespace teamsight::sim {
namespace {

// The share of the first minute in which something holds.
double share_of_time(std::string_view name, const std::function<bool(const MatchState&)>& holds) {
  Match match(make_scenario(name, 7, plain_field()).value(), plain_field());
  int count = 0;
  for (int i = 1; i <= 6000; ++i) {
    match.advance_to(0.01 * i);
    count += holds(match.state()) ? 1 : 0;
  }
  return count / 6000.0;
}

bool is_high(const MatchState& state) {
  return state.balls.front().p_FB.z > 0.3;
}

TEST(Scenario, EachNameMakesAMatchThatKeepsItsWorldInOrder) {
  for (const ScenarioName& name : scenario_names()) {
    Match match(make_scenario(name.name, 1, plain_field()).value(), plain_field());
    for (int i = 1; i <= 3000; ++i) {
      match.advance_to(0.01 * i);
      for (const Ball& ball : match.state().balls) {
        ASSERT_TRUE(ball.p_FB.vector().allFinite()) << name.name;
        ASSERT_LT(std::abs(ball.p_FB.x), 12.0) << name.name;
        ASSERT_LE(ball.v_FB.vector().norm(), 10.5) << name.name;
      }
    }
  }
}

TEST(Scenario, AnUnknownNameMakesNone) {
  EXPECT_FALSE(make_scenario("rugby", 1, plain_field()).has_value());
}

TEST(Scenario, HighBallsAreOftenInTheAirAndKicksNever) {
  EXPECT_GT(share_of_time("high_balls", is_high), 0.12);
  EXPECT_EQ(share_of_time("kicks", is_high), 0.0);
}

TEST(Scenario, KicksReachTenMetresPerSecond) {
  EXPECT_GT(share_of_time("kicks",
                          [](const MatchState& state) {
                            return state.balls.front().v_FB.vector().norm() > 8.0;
                          }),
            0.02);
}

TEST(Scenario, TwoBallsAreThereForPartOfTheTime) {
  const double share =
      share_of_time("two_balls", [](const MatchState& state) { return state.balls.size() == 2; });
  EXPECT_NEAR(share, 0.6, 0.05);
}

TEST(Scenario, ACrowdIsCloserToTheBallThanOrdinaryPlay) {
  const auto many_near = [](const MatchState& state) {
    const Eigen::Vector2d ball = state.balls.front().p_FB.on_floor().vector();
    return std::count_if(state.players.begin(), state.players.end(), [&](const Player& player) {
             return (player.X_FR.origin().vector() - ball).norm() < 3.0;
           }) >= 6;
  };
  EXPECT_GT(share_of_time("crowd", many_near), 0.4);
  EXPECT_LT(share_of_time("play", many_near), 0.2);
}

TEST(Scenario, PlayersLeaveAndAllComeBack) {
  const auto is_somebody_away = [](const MatchState& state) {
    return std::any_of(state.players.begin(), state.players.end(), [](const Player& player) {
      return !player.on_field;
    });
  };
  Match match(make_scenario("join_and_leave", 3, plain_field()).value(), plain_field());
  EXPECT_GT(share_of_time("join_and_leave", is_somebody_away), 0.2);
  match.advance_to(60.0);
  EXPECT_FALSE(is_somebody_away(match.state()));
}

}  // namespace
}  // namespace teamsight::sim
