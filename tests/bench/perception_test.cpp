// tests/bench/perception_test.cpp: what the made-up games' eyes report is what a camera would see.
#include "bench/play/perception.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "bench/play/play_log.hpp"

namespace teamsight::play {
namespace {

/// Sum over the rays to the true ball, at most `farthest` m along the floor.
struct Radii {
  double count{0.0};
  double ratio{0.0};
};

Radii radii_within(const PlayLog& log, double farthest) {
  Radii sum;
  for (const Frame& frame : log.frames) {
    if ((frame.seen_balls & 1U) == 0) continue;
    const Moment& moment = log.at(frame.exposure);
    const auto robot = static_cast<std::size_t>(frame.observation.id.robot) - 1;
    const double range =
        (moment.balls[0].p_F.head<2>() - moment.players[robot].X_FR.origin().vector()).norm();
    if (range > farthest) continue;
    const double drop = kMirrorHeight - moment.balls[0].p_F.z();
    const double angular = std::asin(log.scenario.play.ball_radius / std::hypot(range, drop));
    sum.count += 1.0;
    sum.ratio += frame.observation.balls[0].angular_radius / angular;
  }
  return sum;
}

TEST(Perception, SeesABallAsLargeAsItLooksFromTheMirrorAlsoBesideTheRobot) {
  const PlayLog log = play_log(Scenario{}, 7, 20.0);

  const Radii near = radii_within(log, 1.0);

  ASSERT_GT(near.count, 50.0);
  EXPECT_NEAR(near.ratio / near.count, 1.0, 4.0 * 0.1 / std::sqrt(near.count));
}

}  // namespace
}  // namespace teamsight::play
