// tests/realdata/league_game_test.cpp: a real game as the league kept it: what becomes of the
// obstacles that each team reports, beside where the other team's robots say they stand.
#include <string>

#include <gtest/gtest.h>

#include "bench/fuse_score/league.hpp"
#include "tests/realdata/folders.hpp"
#include "tests/realdata/zip_file.hpp"
#include "tests/support/process.hpp"
#include "tools/league_team.hpp"

namespace teamsight::score {
namespace {

const LeagueScore& score_of(const LeagueResult& result, const std::string& estimator) {
  static const LeagueScore none;
  for (const LeagueScore& score : result.scores) {
    if (score.estimator == estimator) return score;
  }
  ADD_FAILURE() << "no score of " << estimator;
  return none;
}

void expect_better(const LeagueResult& result, const std::string& ours, const std::string& theirs) {
  EXPECT_LT(score_of(result, ours).obstacles.gospa.mean(),
            score_of(result, theirs).obstacles.gospa.mean())
      << theirs;
}

// One test, for the two teams' world states are 130 MB of text. The raw figures were found by hand
// in the same file: median 0.20 m, 82 % within 0.5 m.
TEST(RealGame, IsReadInTheRightFrameAndFusedBetterThanByOtherTeamsRules) {
  const std::filesystem::path part = std::filesystem::path("refbox2016") / "test_log.zip";
  if (!test::has_data(part)) GTEST_SKIP() << "no real data in " << test::data_dir();
  const test::TempDirectory folder;
  test::unzip(test::data_dir() / part, folder.path());
  const auto spans = tools::read_league_spans(folder.path() / "20160703_155014.msl");
  const LeagueTeam tech = tools::read_league_team(folder.path() / "20160703_155014.A.msl");
  const LeagueTeam water = tools::read_league_team(folder.path() / "20160703_155014.B.msl");

  const LeagueResult by_tech = run_league(tech, water, spans);
  const LeagueResult by_water = run_league(water, tech, spans);

  const ErrorTally& raw = score_of(by_tech, "as-recorded").nearest;
  EXPECT_NEAR(raw.count(), 8021, 80);
  EXPECT_NEAR(raw.quantile(0.5), 0.20, 0.01);
  EXPECT_NEAR(raw.share_within(0.5), 0.82, 0.02);
  for (const char* rule : {"information-filter", "two-witnesses"}) {
    expect_better(by_tech, "teamsight", rule);
    expect_better(by_tech, "teamsight-silence-says-nothing", rule);
    expect_better(by_water, "teamsight", rule);
  }
  expect_better(by_water, "teamsight", "newest-list");
}

}  // namespace
}  // namespace teamsight::score
