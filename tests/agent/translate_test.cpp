// tests/agent/translate_test.cpp: from one frame's observation to the topics.
#include "agent/translate.hpp"

#include <gtest/gtest.h>

namespace teamsight::agent {
namespace {

const Stamps kStamps{{2, 9, 4}, HostTime{Duration{1000}}, HostTime{Duration{3000}}};

TEST(SightingsOf, KeepsNoMoreThanTheTopicHolds) {
  vision::FrameObservation seen;
  seen.balls.resize(kMaxBallRays + 3);
  seen.obstacles.resize(kMaxObstacleSightings + 1);
  seen.light = vision::Light::kGlare;

  const bus::Sightings message = sightings_of(seen, kStamps);

  EXPECT_EQ(message.balls.size(), kMaxBallRays);
  EXPECT_EQ(message.obstacles.size(), kMaxObstacleSightings);
  EXPECT_EQ(message.light, bus::Light::kGlare);
  EXPECT_EQ(message.id, kStamps.id);
  EXPECT_EQ(message.exposure, PeerTime{Duration{1000}});
  EXPECT_EQ(message.published, PeerTime{Duration{3000}});
}

TEST(LinePointsOf, ThinsOutWithoutLosingTheInliers) {
  vision::FrameObservation seen;
  for (int i = 0; i < 450; ++i) {
    vision::LinePoint point;
    point.p_R = {0.01 * i, 0.0};
    seen.line_points.push_back(point);
    seen.line_fits.push_back(i < 225);
  }

  const bus::LinePoints message = line_points_of(seen, kStamps);

  ASSERT_EQ(message.points.size(), 150U);  // every third
  EXPECT_TRUE(message.points.front().inlier);
  EXPECT_FALSE(message.points.back().inlier);
  EXPECT_DOUBLE_EQ(message.points[1].p_R.x, 0.03);
}

TEST(LinePointsOf, LeavesOutWhatTheTopicCannotSay) {
  vision::FrameObservation seen;
  seen.line_points.resize(2);
  seen.line_points[0].p_R = {40.0, 0.0};

  EXPECT_EQ(line_points_of(seen, kStamps).points.size(), 1U);
  EXPECT_TRUE(line_points_of({}, kStamps).points.empty());
}

TEST(SeesBall, NeedsOneThatIsMoreProbablyABallThanNot) {
  vision::FrameObservation seen;
  seen.balls.resize(1);
  seen.balls[0].confidence = 0.4;
  EXPECT_FALSE(sees_ball(seen));

  seen.balls[0].confidence = 0.6;
  EXPECT_TRUE(sees_ball(seen));
}

}  // namespace
}  // namespace teamsight::agent
