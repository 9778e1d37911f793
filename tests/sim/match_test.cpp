// tests/sim/match_test.cpp: the match repeats itself and keeps to what bodies can do.
#include "sim/match.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace teamsight::sim {
namespace {

FieldModel plain_field() {
  FieldModel field;
  field.length = 22.0;
  field.width = 14.0;
  field.surround = 1.0;
  field.line_width = 0.125;
  return field;
}

MatchParameters five_against_five(std::uint32_t seed) {
  MatchParameters parameters;
  parameters.seed = seed;
  parameters.own = {1, 2, 3, 4, 5};
  return parameters;
}

TEST(Match, IsTheSameForTheSameSeedHoweverItIsAdvanced) {
  Match a(five_against_five(3), plain_field());
  Match b(five_against_five(3), plain_field());
  Match other(five_against_five(4), plain_field());

  a.advance_to(5.0);
  other.advance_to(5.0);
  for (int i = 1; i <= 500; ++i) {
    b.advance_to(0.01 * i);
  }

  EXPECT_EQ(a.state().p_FB, b.state().p_FB);
  EXPECT_EQ(a.state().players[7].X_FR, b.state().players[7].X_FR);
  EXPECT_FALSE(a.state().players[7].X_FR == other.state().players[7].X_FR);
}

TEST(Match, StartsTheOwnRobotsInTheirOwnHalf) {
  const Match match(five_against_five(1), plain_field());

  ASSERT_EQ(match.state().players.size(), 10U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(match.state().players[i].number, i + 1);
    EXPECT_LT(match.state().players[i].X_FR.x(), 0.0);
    EXPECT_EQ(match.state().players[i + 5].number, 17 + i);
    EXPECT_GT(match.state().players[i + 5].X_FR.x(), 0.0);
  }
}

TEST(Match, KeepsSpeedAndTurningWithinLimits) {
  const MatchParameters limits = five_against_five(2);
  Match match(limits, plain_field());
  for (int i = 1; i <= 2000; ++i) {
    match.advance_to(Match::kStep * i);
    for (const Player& player : match.state().players) {
      ASSERT_LE(player.v_FR.vector().norm(), limits.max_speed + 1e-9);
      ASSERT_LE(std::abs(player.omega), limits.max_turn + 1e-9);
    }
  }
}

TEST(Match, LetsNobodyStandInAnybodyElse) {
  Match match(five_against_five(5), plain_field());
  for (int i = 1; i <= 3000; ++i) {
    match.advance_to(Match::kStep * i);
    const auto& players = match.state().players;
    for (std::size_t a = 0; a < players.size(); ++a) {
      for (std::size_t b = a + 1; b < players.size(); ++b) {
        const double distance =
            (players[a].X_FR.origin().vector() - players[b].X_FR.origin().vector()).norm();
        ASSERT_GT(distance, 0.4) << "at " << match.time() << " s";
      }
    }
  }
}

TEST(Match, KicksTheBallAndLetsItRollOutWithinTheCarpet) {
  Match match(five_against_five(6), plain_field());
  double fastest = 0.0;
  double slowest_after = 1e9;
  for (int i = 1; i <= 3000; ++i) {
    match.advance_to(Match::kStep * i);
    const MatchState& state = match.state();
    const double speed = state.v_FB.vector().norm();
    slowest_after = speed > fastest ? 1e9 : std::min(slowest_after, speed);
    fastest = std::max(fastest, speed);
    ASSERT_LE(std::abs(state.p_FB.x), 12.0);
    ASSERT_LE(std::abs(state.p_FB.y), 8.0);
  }

  EXPECT_GT(fastest, 1.5);
  EXPECT_LT(slowest_after, 0.5 * fastest);
}

}  // namespace
}  // namespace teamsight::sim
