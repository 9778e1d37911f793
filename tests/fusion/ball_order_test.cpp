// tests/fusion/ball_order_test.cpp: which of several balls is the game's.
#include <cmath>

#include <gtest/gtest.h>

#include "fusion/ball_choice.hpp"
#include "fusion/ball_identity.hpp"
#include "tests/fusion/scenario.hpp"

namespace teamsight::fusion {
namespace {

using test::at_second;

const Parameters kParameters;

/// A ball at (x, 0) m that rolls along y, seen by one robot.
BallTrack ball_at(double x, double speed, double born, double last_hit) {
  BallTrack ball;
  ball.book = first_page(7, {1, at_second(born), 0.9}, kParameters.ball);
  write_hit(ball.book, {1, at_second(last_hit), 0.9}, 1.0, kParameters.ball);
  ball.book.is_confirmed = true;
  BallBelief belief;
  belief.probability = 1.0;
  belief.state.mean << x, 0.0, 0.11, 0.0, speed, 0.0;
  belief.state.cov.setIdentity();
  belief.state.cov *= 0.01;
  ball.beliefs.push_back(belief);
  return ball;
}

/// Adds the possibility that the ball was kicked a second ago.
void doubt(BallTrack& ball, double probability) {
  BallBelief kicked = ball.beliefs[0];
  ball.beliefs[0].probability = 1.0 - probability;
  kicked.probability = probability;
  kicked.state.cov.diagonal() << 16.0, 16.0, 0.01, 16.0, 16.0, 0.01;
  for (const int axis : {0, 1}) {
    kicked.state.cov(axis, axis + 3) = kicked.state.cov(axis + 3, axis) = 15.0;
  }
  ball.beliefs.push_back(kicked);
}

TEST(LogExplained, ANewBallWhereTheLostOneRollsIsThatOne) {
  const BallTrack lost = ball_at(0.0, 1.0, 0.0, 2.0);

  EXPECT_GT(log_explained(lost, ball_at(0.1, 1.0, 2.5, 2.7), kParameters.choice), 3.0);
  EXPECT_LT(log_explained(lost, ball_at(4.0, 1.0, 2.5, 2.7), kParameters.choice), -20.0);
}

TEST(LogExplained, AKickExplainsABallThatRollsAwayFromWhereItWas) {
  BallTrack lost = ball_at(0.0, 0.0, 0.0, 2.0);
  doubt(lost, 0.2);
  BallTrack away = ball_at(4.0, 0.0, 2.5, 2.7);
  away.beliefs[0].state.mean(3) = 4.0;
  BallTrack back = away;
  back.beliefs[0].state.mean(3) = -4.0;

  EXPECT_GT(log_explained(lost, away, kParameters.choice), 0.0);
  EXPECT_LT(log_explained(lost, back, kParameters.choice), -3.0);
}

TEST(LogExplained, WhatABallGoesOnFromIsToldWhileItIsYoung) {
  BallList balls;
  balls.push_back(ball_at(0.0, 0.0, 0.0, 2.0));
  doubt(balls[0], 0.2);
  BallTrack away = ball_at(4.0, 0.0, 2.5, 2.7);
  away.book.key = 6;
  away.book.is_confirmed = false;
  away.beliefs[0].state.mean(3) = 4.0;
  balls.push_back(away);
  const double when_young = log_explained(balls[0], away, kParameters.choice);
  (void)recognise(balls, BallKeys{}, 0, kParameters);

  // Who sees the new ball does not see the old one there, whatever became of it.
  balls[0].beliefs[1].probability = 1e-9;
  const BallTrack stranger = ball_at(4.0, 0.0, 2.5, 2.7);

  EXPECT_EQ(balls[1].goes_on_from, balls[0].book.key);
  EXPECT_NEAR(log_explained(balls[0], balls[1], kParameters.choice), when_young, 1e-9);
  EXPECT_LT(log_explained(balls[0], stranger, kParameters.choice), -3.0);
}

TEST(LogExplained, NothingExplainsABallThatWasSeenBesideTheOther) {
  const BallTrack ball = ball_at(0.0, 1.0, 0.0, 2.0);

  EXPECT_LT(log_explained(ball, ball_at(0.1, 1.0, 1.5, 2.0), kParameters.choice), -50.0);
}

TEST(OrderOfChoice, AnUnseenKickLetsTheNewBallGoFirstAndWithoutOneTheOldStays) {
  BallList balls;
  balls.push_back(ball_at(0.0, 0.0, 0.0, 2.0));
  BallTrack away = ball_at(4.0, 0.0, 2.5, 2.9);
  away.beliefs[0].state.mean(3) = 4.0;
  balls.push_back(away);
  const auto first = [&]() {
    return order_of_choice(balls, HintedBall{}, at_second(3.0), kParameters)[0];
  };

  EXPECT_EQ(first(), 0U);
  doubt(balls[0], 0.2);
  EXPECT_EQ(first(), 1U);
}

TEST(OrderOfChoice, ABallOfRobotsThatAreFoundElsewhereGoesBehindTheOthersBall) {
  BallList balls;
  balls.push_back(ball_at(0.0, 0.0, 0.0, 2.0));
  balls.push_back(ball_at(4.0, 0.0, 1.0, 2.0));
  for (const RobotId liar : {RobotId{1}, RobotId{2}}) {
    for (int i = 0; i < 3; ++i) {
      write_hit(balls[0].book, {liar, at_second(2.0), 0.9}, 1.0, kParameters.ball);
    }
  }
  for (const RobotId sound : {RobotId{3}, RobotId{4}}) {
    write_hit(balls[1].book, {sound, at_second(2.0), 0.9}, 1.0, kParameters.ball);
  }
  const auto first = [&]() {
    return order_of_choice(balls, HintedBall{}, at_second(2.0), kParameters)[0];
  };

  EXPECT_EQ(first(), 0U);
  take_back(balls[0].book, 1, kParameters.ball);
  take_back(balls[0].book, 2, kParameters.ball);
  EXPECT_EQ(first(), 1U);
}

/// A ball that three robots long saw, and hardly see any more.
BallTrack ball_that_was_known() {
  BallTrack ball = ball_at(0.0, 0.0, 0.0, 2.2);
  ball.book.key = 5;
  ball.book.proven = 9.0;
  return ball;
}

/// Another 0.5 m aside, which the three see since a moment before they lost the first.
BallTrack ball_beside_it() {
  BallTrack ball = ball_at(0.5, 0.0, 2.0, 2.6);
  ball.book.key = 6;
  for (const RobotId robot : {RobotId{2}, RobotId{3}}) {
    for (int i = 0; i < 3; ++i) {
      write_hit(ball.book, {robot, at_second(2.6), 0.9}, 1.0, kParameters.ball);
    }
  }
  return ball;
}

TEST(OrderOfChoice, OfTwoThatMayBeTheKnownBallTheOneThatMoreRobotsSeeIsIt) {
  BallList balls;
  balls.push_back(ball_that_was_known());
  balls.push_back(ball_beside_it());
  const auto first = [&]() {
    return order_of_choice(balls, HintedBall{}, at_second(2.6), kParameters)[0];
  };

  EXPECT_EQ(first(), 0U);
  balls[1].branched_from = balls[0].book.key;
  EXPECT_EQ(first(), 1U);
  for (const RobotId robot : {RobotId{2}, RobotId{3}, RobotId{4}}) {
    for (int i = 0; i < 3; ++i) {
      write_hit(balls[0].book, {robot, at_second(2.6), 0.9}, 1.0, kParameters.ball);
    }
  }
  EXPECT_EQ(first(), 0U);
}

TEST(Recognise, WhatProvedTheLostBallProvesTheFoundOneAsFarAsItIsSureToBeIt) {
  const auto found_near = [](double x) {
    BallList balls;
    balls.push_back(ball_that_was_known());
    doubt(balls[0], 0.2);
    BallTrack found = ball_at(x, 0.0, 3.0, 3.2);
    found.book.key = 6;
    balls.push_back(found);
    BallKeys before;
    before.push_back(balls[0].book.key);
    (void)recognise(balls, before, 0, kParameters);
    return balls[0].book;
  };

  const TrackBook there = found_near(0.1);
  const TrackBook kicked = found_near(0.6);

  EXPECT_EQ(there.key, 5U);
  EXPECT_EQ(kicked.key, 5U);
  EXPECT_GT(there.proven, kicked.proven);
  EXPECT_LT(kicked.proven, ball_that_was_known().book.proven);
}

TEST(Recognise, ALostBallIsNotFoundOnceTheTeamHasFoundAnother) {
  const auto key_of_found = [](int robots) {
    BallList balls;
    balls.push_back(ball_that_was_known());
    BallTrack other = ball_at(6.0, 0.0, 2.7, 3.2);
    other.book.key = 8;
    for (RobotId robot = 2; robot <= robots; ++robot) {
      for (int i = 0; i < 5; ++i) {
        write_hit(other.book, {robot, at_second(3.2), 0.9}, 1.0, kParameters.ball);
      }
    }
    BallTrack found = ball_at(0.1, 0.0, 3.0, 3.2);
    found.book.key = 6;
    balls.push_back(other);
    balls.push_back(found);
    BallKeys before;
    before.push_back(balls[0].book.key);
    before.push_back(other.book.key);
    (void)recognise(balls, before, 0, kParameters);
    return balls.size() == 3 ? balls[2].book.key : balls[0].book.key;
  };

  EXPECT_EQ(key_of_found(1), 5U);
  EXPECT_EQ(key_of_found(3), 6U);
}

TEST(Recognise, ABallThatBeginsWhereTheKnownOneMayHaveBeenKickedMayBeIt) {
  const auto branch = [](double x, double chance_of_kick) {
    BallList balls;
    balls.push_back(ball_that_was_known());
    if (chance_of_kick > 0.0) doubt(balls[0], chance_of_kick);
    BallTrack beside = ball_beside_it();
    beside.beliefs[0].state.mean(0) = x;
    beside.beliefs[0].state.mean(3) = 2.0;  // m/s, as after a kick a second ago
    balls.push_back(beside);
    BallKeys before;
    before.push_back(balls[0].book.key);
    (void)recognise(balls, before, 0, kParameters);
    return balls[1].branched_from;
  };

  EXPECT_EQ(branch(2.0, 0.1), 5U);
  EXPECT_EQ(branch(2.0, 0.0), 0U);
  EXPECT_EQ(branch(9.0, 0.1), 0U);
}

TEST(OrderOfChoice, LeavesOutWhatIsNotConfirmed) {
  BallList balls;
  balls.push_back(ball_at(0.0, 0.0, 0.0, 2.0));
  balls[0].book.is_confirmed = false;

  EXPECT_TRUE(order_of_choice(balls, HintedBall{}, at_second(2.0), kParameters).empty());
}

TEST(OrderOfChoice, TheOperatorsWordCountsAsManyRobots) {
  BallList balls;
  balls.push_back(ball_at(0.0, 0.0, 0.0, 2.0));
  balls.push_back(ball_at(4.0, 0.0, 1.0, 2.0));
  balls[1].book.key = 8;
  HintedBall hinted;
  hinted.key = 8;
  hinted.given = at_second(2.0);

  EXPECT_EQ(order_of_choice(balls, HintedBall{}, at_second(2.0), kParameters)[0], 0U);
  EXPECT_EQ(order_of_choice(balls, hinted, at_second(2.0), kParameters)[0], 1U);
}

}  // namespace
}  // namespace teamsight::fusion
