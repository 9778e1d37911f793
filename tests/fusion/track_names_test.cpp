// tests/fusion/track_names_test.cpp: ids outlive the instance that gave them.
#include <gtest/gtest.h>

#include "fusion/fusion.hpp"
#include "tests/fusion/scenario.hpp"

namespace teamsight::fusion {
namespace {

using test::at_second;
using test::Eye;

const Pose<Field, Robot> kStand(-2.0, 0.0, 0.0);

Fusion make_fusion() {
  return Fusion(Parameters{}, test::plain_field());
}

/// A robot sees a ball and two obstacles from `from` to `to`.
void watch(Fusion& fusion, Eye& eye, double from, double to) {
  for (double t = from; t < to; t += 0.033) {
    eye.look(kStand, at_second(t));
    eye.see_ball({1.0, 0.5});
    eye.see_obstacle({0.0, -2.0});
    eye.see_obstacle({0.0, 2.0});
    fusion.insert(eye.frame(), at_second(t));
  }
}

std::vector<std::uint32_t> ids_of(const WorldModel& world) {
  std::vector<std::uint32_t> ids;
  for (const WorldBall& ball : world.balls) ids.push_back(ball.track);
  for (const WorldObstacle& obstacle : world.obstacles) ids.push_back(obstacle.track);
  return ids;
}

TEST(TrackNames, AreTheSameInEveryInstanceThatHeardTheSame) {
  Fusion one = make_fusion();
  Fusion other = make_fusion();
  Eye eye(1, 11);
  Eye twin(1, 11);
  watch(one, eye, 0.0, 0.5);
  watch(other, twin, 0.0, 0.5);

  EXPECT_EQ(ids_of(one.world_at(at_second(0.5))), ids_of(other.world_at(at_second(0.5))));
}

TEST(TrackNames, AStartingInstanceTakesOverTheLeaders) {
  Fusion leader = make_fusion();
  Fusion late = make_fusion();
  Eye eye(1, 11);
  watch(leader, eye, 0.0, 0.5);
  Eye from_now = eye;
  watch(leader, eye, 0.5, 1.0);
  watch(late, from_now, 0.5, 1.0);
  const WorldModel world = leader.world_at(at_second(1.0));
  ASSERT_NE(ids_of(world), ids_of(late.world_at(at_second(1.0))));

  late.adopt_ids(world, at_second(1.0));

  ASSERT_EQ(ids_of(world).size(), 3U);
  EXPECT_EQ(ids_of(world), ids_of(late.world_at(at_second(1.0))));
}

TEST(TrackNames, StayWithTheirTracksAfterwards) {
  Fusion leader = make_fusion();
  Fusion late = make_fusion();
  Eye eye(1, 11);
  watch(leader, eye, 0.0, 0.5);
  watch(late, eye, 0.5, 1.0);
  const WorldModel world = leader.world_at(at_second(0.5));
  late.adopt_ids(world, at_second(0.5));

  watch(late, eye, 1.0, 3.0);

  EXPECT_EQ(ids_of(world), ids_of(late.world_at(at_second(3.0))));
}

TEST(TrackNames, AreNotTakenOverByTracksThatLieElsewhere) {
  Fusion fusion = make_fusion();
  Eye eye(1, 11);
  watch(fusion, eye, 0.0, 0.5);
  WorldModel elsewhere = fusion.world_at(at_second(0.5));
  const auto before = ids_of(elsewhere);
  for (WorldBall& ball : elsewhere.balls) {
    ball.track = 4711;
    ball.p_FB.y += 3.0;
  }

  fusion.adopt_ids(elsewhere, at_second(0.5));

  EXPECT_EQ(ids_of(fusion.world_at(at_second(0.5))), before);
}

TEST(TrackNames, AreNeverGivenTwice) {
  Fusion fusion = make_fusion();
  Eye eye(1, 11);
  watch(fusion, eye, 0.0, 0.5);
  WorldModel world = fusion.world_at(at_second(0.5));
  ASSERT_EQ(world.obstacles.size(), 2U);
  // The leader calls the one what this instance calls the other, and has not heard of the other.
  world.obstacles[0].track = world.obstacles[1].track;
  world.obstacles.pop_back();

  fusion.adopt_ids(world, at_second(0.5));

  const auto obstacles = fusion.world_at(at_second(0.5)).obstacles;
  ASSERT_EQ(obstacles.size(), 2U);
  EXPECT_NE(obstacles[0].track, obstacles[1].track);
}

TEST(TrackNames, SurviveALateObservationThatChangesTheFirstOne) {
  Fusion fusion = make_fusion();
  Eye eye(1, 11);
  Eye late(2, 22);
  late.look(kStand, at_second(-0.02));
  late.see_ball({1.0, 0.5});
  watch(fusion, eye, 0.0, 0.3);
  const WorldModel before = fusion.world_at(at_second(0.3));

  ASSERT_EQ(fusion.insert(late.frame(), at_second(0.3)), Intake::kAccepted);
  ASSERT_NE(fusion.world_at(at_second(0.3)).balls.at(0).track, before.balls.at(0).track);
  fusion.adopt_ids(before, at_second(0.3));

  EXPECT_EQ(fusion.world_at(at_second(0.3)).balls.at(0).track, before.balls.at(0).track);
}

}  // namespace
}  // namespace teamsight::fusion
