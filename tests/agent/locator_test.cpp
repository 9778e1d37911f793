// tests/agent/locator_test.cpp: topics into the localisation, and its search in the background.
#include "agent/locator.hpp"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <poll.h>

#include "bench/locate_score/line_view.hpp"
#include "tests/support/geometry_matchers.hpp"
#include "tests/vision/localisation/fields.hpp"

namespace teamsight::agent {
namespace {

using testing_support::IsNear;

HostTime at(double seconds) {
  return HostTime{from_seconds(seconds)};
}

std::vector<vision::LinePoint> points_at(const Pose<Field, Robot>& X_FR) {
  std::mt19937 random(4);
  return locate_score::look_at_lines(vision::league_field(), X_FR, {}, {}, random);
}

Locator make_locator(vision::StartSide side = vision::StartSide::kOwnHalf) {
  vision::LocalisationParameters parameters;
  parameters.start_side = side;
  return {vision::league_field(), parameters};
}

// A search takes some 20 ms on a machine with nothing else to do.
void wait_for_answer(Locator& locator) {
  pollfd waiting{locator.search_fd(), POLLIN, 0};
  ASSERT_EQ(::poll(&waiting, 1, 20000), 1);
  locator.take_answer();
}

// Found and sure of itself at this place.
Locator settled_at(const Pose<Field, Robot>& X_FR) {
  Locator locator = make_locator();
  locator.place(X_FR, 0.01 * Eigen::Matrix3d::Identity(), at(10.0));
  for (int i = 1; i < 5; ++i) {
    EXPECT_EQ(locator.see({points_at(X_FR), {}}, at(10.0 + 0.03 * i)).estimate.status,
              PostureStatus::kOk);
  }
  return locator;
}

WorldModel world_of(double team_log_odds, std::uint32_t frame) {
  WorldModel world;
  WorldTeammate self;
  self.robot = 3;
  self.frame = frame;
  self.half_log_odds_team = team_log_odds;
  world.teammates.push_back(self);
  return world;
}

TEST(Locator, FindsItselfByASearchInTheBackground) {
  Locator locator = make_locator();
  const Pose<Field, Robot> truth(-4.0, 2.0, 0.7);

  const PostureEstimate first = locator.see({points_at(truth), {}}, at(10.0)).estimate;
  wait_for_answer(locator);
  const PostureEstimate second = locator.see({points_at(truth), {}}, at(10.03)).estimate;

  EXPECT_EQ(first.status, PostureStatus::kLost);
  EXPECT_EQ(second.status, PostureStatus::kOk);
  EXPECT_THAT(second.X_FR.origin(), IsNear(truth.origin(), 0.03));
}

TEST(Locator, GivesTheVelocityOfTheWheels) {
  Locator locator = settled_at({1.0, 1.0, 0.0});
  bus::Odometry odometry;
  odometry.id = {3, 1, 1};
  odometry.stamp = stamp_of(at(10.2));
  odometry.v_R = {1.25, -0.5};
  odometry.omega = 0.75;
  locator.roll(odometry);

  EXPECT_THAT(locator.velocity(at(10.25)), IsNear(Velocity<Robot>{1.25, -0.5}, 1e-12));
  EXPECT_DOUBLE_EQ(locator.omega(at(10.25)), 0.75);
  EXPECT_THAT(locator.velocity(at(13.0)), IsNear(Velocity<Robot>{}, 1e-12));
}

TEST(Locator, TurnsOverWhenTheTeamIsSureAndKeepsItsOwnOddsApart) {
  const Pose<Field, Robot> truth(3.0, 2.0, 0.5);
  Locator locator = settled_at(truth);

  locator.hear(world_of(-9.0, 5), 3, 5);
  PostureEstimate posture;
  for (int i = 0; i < 6; ++i) {
    posture = locator.see({points_at(truth), {}}, at(10.2 + 0.03 * i)).estimate;
  }

  EXPECT_THAT(posture.X_FR.origin(), IsNear(mirrored(truth).origin(), 0.05));
  EXPECT_LT(posture.half_log_odds, -2.0);
  EXPECT_NEAR(locator.team_log_odds(), 9.0, 1e-9);
}

TEST(Locator, DoesNotHearEvidenceAboutThePostureBeforeItTurnedOver) {
  const Pose<Field, Robot> truth(3.0, 2.0, 0.5);
  Locator locator = settled_at(truth);
  locator.hear(world_of(-9.0, 5), 3, 5);
  for (int i = 0; i < 6; ++i) (void)locator.see({points_at(truth), {}}, at(10.2 + 0.03 * i));

  locator.hear(world_of(-9.0, 11), 3, 11);
  EXPECT_NEAR(locator.team_log_odds(), 9.0, 1e-9);
  locator.hear(world_of(8.0, 12), 3, 12);
  EXPECT_NEAR(locator.team_log_odds(), 8.0, 1e-9);
}

TEST(Locator, DropsOdometryThatRunsBackwards) {
  Locator locator = settled_at({1.0, 1.0, 0.0});
  bus::Odometry odometry;
  odometry.stamp = stamp_of(at(10.2));
  locator.roll(odometry);
  odometry.stamp = stamp_of(at(10.1));
  locator.roll(odometry);

  EXPECT_EQ(locator.counts().inputs_backwards, 1U);
}

}  // namespace
}  // namespace teamsight::agent
