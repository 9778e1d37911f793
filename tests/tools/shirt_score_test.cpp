// tests/tools/shirt_score_test.cpp: team mates are told as surely as they are right.
#include "tools/shirt_score.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "settings/load.hpp"
#include "tests/support/process.hpp"

namespace teamsight::tools {
namespace {

TEST(ShirtVotes, SayNothingWithoutVotesAndTheSameOfBothTeams) {
  EXPECT_DOUBLE_EQ(vision::teammate_likelihood({0, 0}), 0.5);
  EXPECT_DOUBLE_EQ(vision::teammate_likelihood({4, 4}), 0.5);
  EXPECT_NEAR(
      vision::teammate_likelihood({7, 2}), 1.0 - vision::teammate_likelihood({2, 7}), 1e-12);
}

TEST(ShirtVotes, LearnMostFromTheFirstLine) {
  const vision::VoteModel model{.wrong = 0.05, .correlation = 0.6};

  EXPECT_NEAR(vision::teammate_likelihood({1, 0}, model), 0.95, 1e-9);
  EXPECT_GT(vision::teammate_likelihood({20, 0}, model), 0.95);
  EXPECT_LT(vision::teammate_likelihood({20, 0}, model), 0.995);
}

TEST(ShirtVotes, OfLinesThatAreLooksOfTheirOwnMultiplyTheirOdds) {
  const vision::VoteModel model{.wrong = 0.2, .correlation = 1e-9};

  EXPECT_NEAR(vision::teammate_likelihood({3, 1}, model), 16.0 / 17.0, 1e-6);
}

TEST(ShirtCalibration, ComparesWhatIsSaidWithWhatIsTrue) {
  const vision::VoteModel model{.wrong = 0.1, .correlation = 0.5};
  const std::vector<ShirtSample> samples{
      {{1, 0}, 1.0, true}, {{1, 0}, 1.0, true}, {{0, 1}, 1.0, true}, {{0, 0}, 1.0, false}};

  const Calibration calibration = calibration_of(samples, model);
  const auto bins = reliability_of(samples, model);

  EXPECT_EQ(calibration.count, 4U);
  EXPECT_EQ(calibration.told, 3U);
  EXPECT_NEAR(calibration.right, 2.0 / 3.0, 1e-12);
  EXPECT_NEAR(calibration.claimed, 0.9, 1e-9);
  EXPECT_NEAR(calibration.log_loss, -(2.0 * std::log(0.9) + std::log(0.1)) / 3.0, 1e-9);
  EXPECT_NEAR(calibration.brier, (0.01 + 0.01 + 0.81) / 3.0, 1e-9);
  ASSERT_EQ(bins.size(), 2U);
  EXPECT_NEAR(bins[0].claimed, 0.1, 1e-9);
  EXPECT_DOUBLE_EQ(bins[0].own, 1.0);
  EXPECT_EQ(bins[1].count, 2U);
}

// Sixty lights that the model was not fitted to. One that turns a shirt's colour into the other
// team's does so to all robots in it: three standard errors of the share that is right are 0.04.
TEST(PerceivedShirts, AreTrustedAsFarAsTheyAreRight) {
  ShirtField where;
  where.camera = settings::load_camera(test::source_path("config/cameras/sim-640.textproto"));
  where.field = settings::load_field(test::source_path("config/fields/msl-2024.textproto"));
  where.lights = 10;
  where.frames = 5;
  where.seed = 31;
  std::vector<ShirtSample> samples;
  for (const ShirtPair& pair : shirt_pairs()) {
    const auto more = look_at_shirts(where, pair);
    samples.insert(samples.end(), more.begin(), more.end());
  }

  const Calibration calibration = calibration_of(samples, {});

  RecordProperty("claimed", std::to_string(calibration.claimed));
  RecordProperty("right", std::to_string(calibration.right));
  EXPECT_GT(calibration.told, 200U);
  EXPECT_NEAR(calibration.claimed, calibration.right, 0.04);
  // Each line taken for a look of its own.
  EXPECT_LT(calibration.log_loss,
            0.5 * calibration_of(samples, {.wrong = 0.05, .correlation = 1e-6}).log_loss);
}

}  // namespace
}  // namespace teamsight::tools
