// tests/sim/match/match_test.cpp: the match repeats itself and keeps to what bodies can do.
#include "sim/match/match.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/sim/match/fields.hpp"

namespace teamsight::sim {
namespace {

MatchParameters seeded(std::uint32_t seed) {
  MatchParameters parameters;
  parameters.seed = seed;
  parameters.own = {1, 2, 3, 4, 5};
  return parameters;
}

// Everybody stands, and only the script moves anything.
MatchParameters scripted(std::vector<ScriptLine> script) {
  MatchParameters parameters = seeded(1);
  parameters.style.plays = false;
  parameters.body.slips_per_second = 0.0;
  parameters.script = std::move(script);
  return parameters;
}

const Player& player(const Match& match, std::uint8_t number) {
  return *std::find_if(match.state().players.begin(),
                       match.state().players.end(),
                       [number](const Player& one) { return one.number == number; });
}

TEST(Match, IsTheSameForTheSameSeedHoweverItIsAdvanced) {
  Match a(seeded(3), plain_field());
  Match b(seeded(3), plain_field());
  Match other(seeded(4), plain_field());

  a.advance_to(5.0);
  other.advance_to(5.0);
  for (int i = 1; i <= 500; ++i) {
    b.advance_to(0.01 * i);
  }

  EXPECT_EQ(a.state().balls, b.state().balls);
  EXPECT_EQ(a.state().players[7].X_FR, b.state().players[7].X_FR);
  EXPECT_FALSE(a.state().players[7].X_FR == other.state().players[7].X_FR);
}

TEST(Match, GoesOnAsACopyThatNeitherDisturbsTheOther) {
  Match match(seeded(3), plain_field());
  match.advance_to(4.0);
  Match copy = match;

  copy.advance_to(9.0);
  EXPECT_EQ(match.time(), 4.0);
  match.advance_to(9.0);

  EXPECT_EQ(match.state().balls, copy.state().balls);
}

TEST(Match, StartsTheOwnRobotsInTheirOwnHalf) {
  const Match match(seeded(1), plain_field());

  ASSERT_EQ(match.state().players.size(), 10U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(match.state().players[i].number, i + 1);
    EXPECT_LT(match.state().players[i].X_FR.x(), 0.0);
    EXPECT_EQ(match.state().players[i + 5].number, 17 + i);
    EXPECT_GT(match.state().players[i + 5].X_FR.x(), 0.0);
  }
}

TEST(Match, KeepsSpeedTurningAndAccelerationWithinLimits) {
  const MatchParameters limits = seeded(2);
  const double dt = Match::kStep;
  Match match(limits, plain_field());
  std::vector<Player> before = match.state().players;
  for (int i = 1; i <= 2000; ++i) {
    match.advance_to(dt * i);
    for (std::size_t k = 0; k < before.size(); ++k) {
      const Player& now = match.state().players[k];
      const double change = (now.wheels_F.vector() - before[k].wheels_F.vector()).norm();
      ASSERT_LE(now.v_FR.vector().norm(), limits.body.max_speed + 1e-9);
      ASSERT_LE(std::abs(now.omega), limits.body.max_turn + 1e-9);
      ASSERT_LE(change, limits.body.max_acceleration * dt + 1e-9);
    }
    before = match.state().players;
  }
}

TEST(Match, LetsNobodyStandInAnybodyElse) {
  Match match(seeded(5), plain_field());
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

TEST(Match, IsPlayedByBothTeamsWithTheBallOnTheCarpet) {
  Match match(seeded(6), plain_field());
  double fastest = 0.0;
  int held_by_us = 0;
  int held_by_them = 0;
  for (int i = 1; i <= 12000; ++i) {
    match.advance_to(Match::kStep * i);
    const Ball& ball = match.state().balls.front();
    fastest = std::max(fastest, ball.v_FB.vector().norm());
    held_by_us += ball.holder != 0 && ball.holder < kFirstOpponent ? 1 : 0;
    held_by_them += ball.holder >= kFirstOpponent ? 1 : 0;
    ASSERT_LE(std::abs(ball.p_FB.x), 12.0);
    ASSERT_LE(std::abs(ball.p_FB.y), 8.0);
    ASSERT_GE(ball.p_FB.z, 0.11 - 1e-9);
  }

  EXPECT_GT(fastest, 5.0);
  EXPECT_GT(held_by_us, 600);  // 5 % of the time
  EXPECT_GT(held_by_them, 600);
}

TEST(Match, FollowsItsScript) {
  Match match(scripted({{1.0, PlacePlayer{2, {3.0, 2.0, 1.0}}},
                        {1.0, SendPlayer{2, {5.0, 2.0}}},
                        {2.0, TakePlayer{18}},
                        {2.0, PutBall{1, {0.0, 5.0, 0.11}, {1.0, 0.0, 0.0}}},
                        {3.0, TakeBall{}},
                        {3.0, KickBall{0, {0.0, 10.0, 0.0}}}}),
              plain_field());

  match.advance_to(1.0);
  EXPECT_EQ(player(match, 2).X_FR.x(), 3.0);
  match.advance_to(2.5);
  EXPECT_FALSE(player(match, 18).on_field);
  ASSERT_EQ(match.state().balls.size(), 2U);
  EXPECT_GT(match.state().balls[1].p_FB.x, 0.3);
  match.advance_to(3.0);
  ASSERT_EQ(match.state().balls.size(), 1U);
  EXPECT_EQ(match.state().balls[0].v_FB.y, 10.0);
  match.advance_to(5.0);
  EXPECT_NEAR(player(match, 2).X_FR.x(), 5.0, 0.1);
}

TEST(Match, WheelsThatSlipTurnMoreThanTheBodyMoves) {
  Match match(scripted({{0.0, PlacePlayer{1, {-5.0, 0.0, 0.0}}},
                        {0.0, SendPlayer{1, {5.0, 0.0}}},
                        {0.0, SlipPlayer{1, 0.5}},
                        {0.0, PutBall{0, {0.0, 6.0, 0.11}, {}}}}),
              plain_field());

  match.advance_to(0.5);

  EXPECT_GT(player(match, 1).wheels_F.x, player(match, 1).v_FR.x + 0.5);
}

}  // namespace
}  // namespace teamsight::sim
