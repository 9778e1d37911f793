// tests/fusion/ball_beliefs_test.cpp: possibilities of what became of a ball.
#include "fusion/ball_beliefs.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

namespace teamsight::fusion {
namespace {

constexpr double kStep = 0.02;  // s
const BallMotion kMotion;
const Kickers kNobodyNear;

BallBeliefs rolling_ball() {
  BallBelief belief;
  belief.state.mean << 5.0, 2.0, kMotion.radius, 1.0, 0.0, 0.0;
  belief.state.cov = 0.01 * BallMatrix::Identity();
  belief.probability = 1.0;
  lay_down(belief.state, kMotion);
  BallBeliefs beliefs;
  beliefs.push_back(belief);
  return beliefs;
}

double total(const BallBeliefs& beliefs) {
  return std::accumulate(
      beliefs.begin(), beliefs.end(), 0.0, [](double sum, const BallBelief& belief) {
        return sum + belief.probability;
      });
}

TEST(BallBeliefs, AKickLeavesTheBallThatRollsAsSharpAsItWas) {
  BallBeliefs beliefs = rolling_ball();

  split_off_kicks(beliefs, kStep, kNobodyNear, kMotion);

  ASSERT_EQ(beliefs.size(), 5U);
  EXPECT_EQ(beliefs[4].mode, BallMode::kLed);
  EXPECT_EQ(beliefs[0].state.cov, rolling_ball()[0].state.cov);
  EXPECT_GT(beliefs[0].probability, 0.95);
  EXPECT_GT(beliefs[1].state.cov(3, 3), 10.0);
  EXPECT_GT(beliefs[1].state.cov(3, 3), beliefs[2].state.cov(3, 3));
  EXPECT_EQ(beliefs[3].mode, BallMode::kFlying);
}

/// Nobody has ever looked where robots stand.
Kickers anybody(const UnseenMap& unseen) {
  Kickers kickers;
  kickers.unseen = &unseen;
  kickers.carpet = {{0.0, 0.0}, {30.0, 20.0}};
  kickers.density = 0.017;
  return kickers;
}

TEST(BallBeliefs, StayOneProbabilityHoweverLongNobodySeesTheBall) {
  BallBeliefs beliefs = rolling_ball();
  const UnseenMap unseen;

  for (int i = 0; i < 100; ++i) {
    advance(beliefs, kStep, kMotion);
    split_off_kicks(beliefs, kStep, anybody(unseen), kMotion);
    ASSERT_NEAR(total(beliefs), 1.0, 1e-9) << i;
  }

  // It has rolled on for two seconds, less what friction took; a kick may have led anywhere.
  EXPECT_NEAR(moments_of(beliefs).mean.x(), 6.1, 0.7);
  EXPECT_GT(moments_of(beliefs).cov(0, 0), 1.0);
}

TEST(BallBeliefs, ManyThatHardlyMatterAreKeptAsOneBesideAFullList) {
  BallBeliefs beliefs;
  BallBeliefs others;
  for (int i = 0; i < 10; ++i) {
    BallBelief belief = rolling_ball()[0];
    belief.state.mean.x() += i;
    belief.probability = 1e-3;
    beliefs.push_back(belief);
    belief.state.mean.y() += 5.0;
    belief.probability = 2e-4;
    others.push_back(belief);
  }
  beliefs[0].probability = 1.0;

  add_others(beliefs, others);

  ASSERT_EQ(beliefs.size(), 10U);
  const auto& added = *std::find_if(beliefs.begin(), beliefs.end(), [](const BallBelief& belief) {
    return belief.state.mean.y() > 6.0;
  });
  ASSERT_GT(added.state.mean.y(), 6.0);
  EXPECT_NEAR(added.probability, 2e-3, 1e-9);
  EXPECT_NEAR(added.state.mean.x(), rolling_ball()[0].state.mean.x() + 4.5, 1e-6);
  EXPECT_GT(added.state.cov(0, 0), 8.0);
}

/// A robot behind the ball: the ball rolls along x.
Kickers foot_at(double behind) {
  Kickers kickers;
  kickers.known.push_back({{5.0 - behind, 2.0}, 1e-4, 0.25});
  return kickers;
}

TEST(BallBeliefs, ABallIsKickedByWhoTouchesIt) {
  const BallBeliefs beliefs = rolling_ball();

  EXPECT_NEAR(kick_rate(beliefs, foot_at(0.2), kMotion), kMotion.kicks_at_foot, 0.1);
  EXPECT_NEAR(kick_rate(beliefs, foot_at(2.0), kMotion), kMotion.kicks_alone, 1e-6);
  EXPECT_EQ(kick_rate(beliefs, kNobodyNear, kMotion), kMotion.kicks_alone);
}

TEST(BallBeliefs, ABallThatRunsIntoARobotComesBackAtOnce) {
  const BallBeliefs beliefs = rolling_ball();

  const double from = kick_rate(beliefs, foot_at(0.3), kMotion);
  const double into = kick_rate(beliefs, foot_at(-0.3), kMotion);

  EXPECT_GT(into, from + 0.7 / kMotion.stopping_way);
}

TEST(BallBeliefs, WhomNobodyHasSeenMayKickABallWhereNobodyLooks) {
  const BallBeliefs beliefs = rolling_ball();
  const UnseenMap unseen;

  const double rate = kick_rate(beliefs, anybody(unseen), kMotion);

  // Robots of whom so many stand on a square metre, on the disc from where the ball is reached.
  EXPECT_NEAR(rate, kMotion.kicks_alone + 0.017 * 0.785 * kMotion.kicks_at_foot, 0.002);
}

TEST(BallBeliefs, ABallThatMayBeAnywhereIsHardlyEverAtOneRobotsFoot) {
  BallBeliefs beliefs = rolling_ball();
  beliefs[0].state.cov.topLeftCorner<2, 2>() = 4.0 * Eigen::Matrix2d::Identity();

  const double rate = kick_rate(beliefs, foot_at(0.0), kMotion);

  // The disc's area times the density in the middle.
  const double touched = 0.25 * 3.1416 / (2.0 * 3.1416 * 4.0);
  EXPECT_NEAR(rate, kMotion.kicks_alone + touched * kMotion.kicks_at_foot, 0.1);
}

TEST(BallBeliefs, AKickLeadsAwayFromTheFoot) {
  BallBeliefs beliefs = rolling_ball();

  split_off_kicks(beliefs, kStep, foot_at(0.4), kMotion);

  ASSERT_EQ(beliefs.size(), 5U);
  EXPECT_GT(beliefs[1].state.mean(3), 0.5 * kMotion.sigma_shot);
  EXPECT_NEAR(beliefs[1].state.mean(4), 0.0, 1e-9);
}

TEST(BallBeliefs, WhileNobodySaysAnythingItIsKickedAsOftenAsInPlay) {
  Kickers nobody_speaks = kNobodyNear;
  nobody_speaks.is_silence = true;

  const double rate = kick_rate(rolling_ball(), nobody_speaks, kMotion);

  EXPECT_NEAR(rate, kMotion.kicks_alone + kMotion.kicks_in_play, 1e-9);
}

TEST(BallBeliefs, ABallThatIsTouchedIsTheSoonerLed) {
  BallBeliefs alone = rolling_ball();
  BallBeliefs touched = rolling_ball();

  split_off_kicks(alone, kStep, kNobodyNear, kMotion);
  split_off_kicks(touched, kStep, foot_at(0.4), kMotion);

  ASSERT_EQ(alone[4].mode, BallMode::kLed);
  ASSERT_EQ(touched[4].mode, BallMode::kLed);
  EXPECT_GT(touched[4].probability, 20.0 * alone[4].probability);
}

TEST(BallBeliefs, WhatNobodySeesRollsByItselfAgain) {
  BallBeliefs beliefs = rolling_ball();
  beliefs[0].mode = BallMode::kLed;

  for (int i = 0; i < 100; ++i) {
    advance(beliefs, kStep, kMotion);
    split_off_kicks(beliefs, kStep, kNobodyNear, kMotion);
    tidy(beliefs);
  }

  double led = 0.0;
  for (const BallBelief& belief : beliefs) {
    if (belief.mode == BallMode::kLed) led += belief.probability;
  }
  EXPECT_NEAR(led, std::exp(-100.0 * kStep * kMotion.leads_end), 0.03);
}

TEST(BallBeliefs, ABallOverEverybodysHeadIsNotKicked) {
  BallBeliefs beliefs = rolling_ball();
  beliefs[0].mode = BallMode::kFlying;
  beliefs[0].state.mean(2) = 1.0;

  split_off_kicks(beliefs, kStep, foot_at(0.2), kMotion);

  EXPECT_EQ(beliefs.size(), 1U);
}

TEST(BallBeliefs, WhatNobodyHasSeenYetMayBeAKickIntoTheAir) {
  BallMoments moments = moments_of(rolling_ball());
  const double before = moments.cov(5, 5);
  BallMotion high = kMotion;
  high.high_share = 0.22;

  doubt_kicks(moments, 0.05, high.kicks_at_foot, high);

  EXPECT_GT(moments.cov(5, 5), before + 0.5);
  EXPECT_GT(moments.cov(3, 3), 1.0);
}

TEST(BallBeliefs, AlikeOnesBecomeOneWithTheirCommonMoments) {
  BallBeliefs beliefs = rolling_ball();
  BallBelief other = beliefs[0];
  beliefs[0].probability = other.probability = 0.5;
  other.state.mean(0) += 0.02;
  beliefs.push_back(other);
  const BallMoments before = moments_of(beliefs);

  tidy(beliefs);

  ASSERT_EQ(beliefs.size(), 1U);
  EXPECT_TRUE(beliefs[0].state.mean.isApprox(before.mean));
  EXPECT_TRUE(beliefs[0].state.cov.isApprox(before.cov));
}

}  // namespace
}  // namespace teamsight::fusion
