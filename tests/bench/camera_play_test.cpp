// tests/bench/camera_play_test.cpp: the whole way from rendered frames to one world, for a few
// seconds; fails where any part of it breaks.
#include <gtest/gtest.h>

#include "bench/camera_play/camera_eyes.hpp"
#include "bench/fuse_score/claims.hpp"
#include "bench/fuse_score/run.hpp"
#include "settings/load.hpp"
#include "tests/support/process.hpp"

namespace teamsight::camera_play {
namespace {

constexpr double kSeconds = 4.0;
constexpr double kRate = 5.0;  // Hz

CameraSetup setup_of(const std::string& camera) {
  return {settings::load_camera(test::source_path("config/cameras/" + camera)),
          settings::load_field(test::source_path("config/fields/msl-2024.textproto")),
          {}};
}

play::PlayLog log_of(const std::string& name) {
  for (play::Scenario& scenario : play::all_scenarios()) {
    if (scenario.name != name) continue;
    scenario.perception.rate = kRate;
    CameraEyes eyes(setup_of("sim-640.textproto"), scenario, 1);
    return play::play_log(scenario, 1, kSeconds, eyes);
  }
  ADD_FAILURE() << "no scenario " << name;
  return {};
}

TEST(CameraPlay, FiveRobotsKnowWhereTheyAreAndWhatIsAroundThem) {
  const play::PlayLog log = log_of("normal");
  const score::ClaimTally claims = score::count_claims(log);
  const auto ticks = score::make_ticks(log);
  const score::Tally fused = score::run_fusion(log, ticks, false);

  EXPECT_EQ(claims.posture.count(), static_cast<int>(log.frames.size()));  // nobody is ever lost
  EXPECT_LT(claims.posture.quantile(0.95), 0.05);
  EXPECT_GT(claims.balls_shown[0].mean(), 0.6);
  EXPECT_GT(claims.players_shown[0].mean(), 0.6);
  EXPECT_LT(claims.false_balls.mean(), 0.05);
  EXPECT_LT(claims.false_obstacles.mean(), 0.1);
  EXPECT_GT(fused.ball.position.count(), 60);
  EXPECT_EQ(fused.ball.position.count(), fused.ball.needed);
  EXPECT_LT(fused.ball.position.quantile(0.5), 0.05);
  EXPECT_LT(fused.obstacles.gospa.mean(), 0.8 * 0.8);
  EXPECT_EQ(fused.trust.false_alarms, 0);
  EXPECT_FALSE(ticks.back().bound.has_value());  // nobody knows the errors of rendered frames
}

TEST(CameraPlay, WhoWasToldTheMirrorImageStaysThereAndIsFound) {
  const play::PlayLog log = log_of("one-mirrored");

  for (const play::Frame& frame : log.frames) {
    if (frame.observation.id.robot != 3) continue;
    const Pose<Field, Robot> truth = log.at(frame.exposure).players[2].X_FR;
    const Pose<Field, Robot> said = frame.observation.posture.X_FR;
    EXPECT_LT((said.origin().vector() - mirrored(truth).origin().vector()).norm(), 0.3);
  }
  const score::TrustTally trust = score::run_fusion(log, score::make_ticks(log), false).trust;
  EXPECT_EQ(trust.found_after.size(), 1U);
  EXPECT_EQ(trust.wrong_reason, 0);
  EXPECT_EQ(trust.false_alarms, 0);
}

TEST(CameraPlay, AMirrorThatIsATableCannotBeBumped) {
  EXPECT_FALSE(can_have(play::Fault::kBiased, setup_of("sim-640.textproto").camera));
  EXPECT_TRUE(can_have(play::Fault::kBiased, setup_of("sim-isometric.textproto").camera));
}

}  // namespace
}  // namespace teamsight::camera_play
