// tests/bench/fuse_score_test.cpp: fusion over a few made-up games, beside the peers' rules.
#include <algorithm>

#include <gtest/gtest.h>

#include "bench/fuse_score/run.hpp"
#include "bench/fuse_score/shared_evidence.hpp"

namespace teamsight::score {
namespace {

constexpr double kSeconds = 12.0;

play::Scenario scenario_named(const std::string& name) {
  for (const play::Scenario& scenario : play::all_scenarios()) {
    if (scenario.name == name) return scenario;
  }
  ADD_FAILURE() << "no scenario " << name;
  return {};
}

struct Result {
  Tally fused;
  std::vector<Scored> balls;
  std::vector<Scored> obstacles;
};

void merge(std::vector<Scored>& into, const std::vector<Scored>& from) {
  if (into.empty()) into.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) into[i].tally.merge(from[i].tally);
}

Result score(const std::string& name, std::uint64_t seeds) {
  Result result;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const play::PlayLog log = play::play_log(scenario_named(name), seed, kSeconds);
    const auto ticks = make_ticks(log);
    result.fused.merge(run_fusion(log, ticks, false));
    merge(result.balls, run_ball_rules(log, ticks));
    merge(result.obstacles, run_obstacle_rules(log, ticks));
  }
  return result;
}

TEST(FuseScore, IsBetterThanEveryPeersRuleInNormalPlay) {
  const Result result = score("normal", 3);

  EXPECT_GT(result.fused.ball.position.count(), 300);
  for (const Scored& rule : result.balls) {
    EXPECT_LT(result.fused.ball.position.rms(), rule.tally.ball.position.rms());
  }
  for (const Scored& rule : result.obstacles) {
    EXPECT_LT(result.fused.obstacles.gospa.mean(), rule.tally.obstacles.gospa.mean());
  }
}

TEST(SharedEvidence, CountsWhileTwoRobotsShowOneThing) {
  play::PlayLog log;
  const auto add = [&log](double exposure, RobotId robot, std::uint64_t players) {
    play::Frame frame;
    frame.exposure = exposure;
    frame.observation.id.robot = robot;
    frame.seen_players = players;
    log.frames.push_back(frame);
    log.deliveries.push_back({exposure + 0.02, log.frames.size() - 1, {}, Duration{0}});
  };
  const play::FaultPlan mirrored{3, play::Fault::kMirrored, 1.0};
  add(0.9, 3, 0b1000'0000);  // before the fault
  add(1.0, 1, 0b1000'0000);
  add(1.1, 2, 0b1000'0000);   // two others
  add(1.45, 3, 0b1100'0000);  // too late after them
  EXPECT_EQ(shared_evidence_until(log, mirrored, 9.0), 0.0);
  add(1.5, 2, 0b0100'0000);
  add(1.6, 1, 0b0000'0100);
  add(3.0, 3, 0b0000'0001);  // shows robot 1, of which there is no frame near

  EXPECT_EQ(shared_evidence_until(log, mirrored, 1.5), 0.0);
  EXPECT_NEAR(shared_evidence_until(log, mirrored, 1.6), 0.08, 1e-9);
  EXPECT_NEAR(shared_evidence_until(log, mirrored, 9.0), 0.4, 1e-9);
}

TEST(FuseScore, FindsARobotInTheWrongHalfAndBlamesNobodyElse) {
  const TrustTally trust = score("one-mirrored", 3).fused.trust;

  EXPECT_EQ(trust.not_found, 0);
  EXPECT_EQ(trust.wrong_reason, 0);
  EXPECT_EQ(trust.false_alarms, 0);
  EXPECT_LT(*std::max_element(trust.found_after.begin(), trust.found_after.end()), 3.0);
}

TEST(FuseScore, TheSameSeedGivesTheSameWorldTwice) {
  const play::PlayLog log = play::play_log(scenario_named("delays"), 5, 7.0);
  const auto ticks = make_ticks(log);

  const Tally once = run_fusion(log, ticks, false);
  const Tally again = run_fusion(log, ticks, false);

  EXPECT_EQ(once.ball.position.rms(), again.ball.position.rms());
  EXPECT_EQ(once.obstacles.gospa.mean(), again.obstacles.gospa.mean());
}

}  // namespace
}  // namespace teamsight::score
