// tests/fusion/ball_beliefs_test.cpp: possibilities of what became of a ball.
#include "fusion/ball_beliefs.hpp"

#include <numeric>

#include <gtest/gtest.h>

namespace teamsight::fusion {
namespace {

constexpr double kStep = 0.02;  // s
const BallMotion kMotion;

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

  split_off_kicks(beliefs, kStep, kMotion);

  ASSERT_EQ(beliefs.size(), 3U);
  EXPECT_EQ(beliefs[0].state.cov, rolling_ball()[0].state.cov);
  EXPECT_GT(beliefs[0].probability, 0.95);
  EXPECT_GT(beliefs[1].state.cov(3, 3), 10.0);
  EXPECT_EQ(beliefs[2].mode, BallMode::kFlying);
}

TEST(BallBeliefs, StayOneProbabilityHoweverLongNobodySeesTheBall) {
  BallBeliefs beliefs = rolling_ball();

  for (int i = 0; i < 100; ++i) {
    advance(beliefs, kStep, kMotion);
    split_off_kicks(beliefs, kStep, kMotion);
    ASSERT_NEAR(total(beliefs), 1.0, 1e-9) << i;
  }

  // It has rolled on for two seconds, less what friction took; a kick may have led anywhere.
  EXPECT_NEAR(moments_of(beliefs).mean.x(), 6.1, 0.7);
  EXPECT_GT(moments_of(beliefs).cov(0, 0), 1.0);
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
