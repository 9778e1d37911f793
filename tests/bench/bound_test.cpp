// tests/bench/bound_test.cpp: the bound falls and grows as it must.
#include "bench/fuse_score/bound.hpp"

#include <gtest/gtest.h>

#include "bench/fuse_score/run.hpp"

namespace teamsight::score {
namespace {

play::PlayLog log_with(int robots, double loss) {
  play::Scenario scenario;
  scenario.play.own = robots;
  scenario.network.loss = loss;
  return play::play_log(scenario, 7, 8.0);
}

double mean_variance(const play::PlayLog& log) {
  MeanTally mean;
  for (const Tick& tick : make_ticks(log)) mean.add(std::min(1.0, tick.bound->var_position));
  return mean.mean();
}

TEST(BoundFilter, KnowsNothingBeforeTheFirstFrame) {
  const play::PlayLog log = log_with(5, 0.0);

  EXPECT_FALSE(BoundFilter(log).at(0.01).is_known);
}

TEST(BoundFilter, GrowsWhereFramesAreLost) {
  EXPECT_LT(mean_variance(log_with(5, 0.0)), mean_variance(log_with(5, 0.7)));
}

TEST(BoundFilter, NeverFallsBelowWhatCalibrationAllows) {
  const play::PlayLog log = log_with(5, 0.0);

  for (const Tick& tick : make_ticks(log)) EXPECT_GT(tick.bound->var_position, 1e-5);
}

}  // namespace
}  // namespace teamsight::score
