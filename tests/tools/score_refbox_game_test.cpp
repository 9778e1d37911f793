// tests/tools/score_refbox_game_test.cpp: `teamsight score refbox-game` over a small made-up game.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/support/process.hpp"

namespace teamsight {
namespace {

using nlohmann::json;
using test::ChildProcess;
using ::testing::HasSubstr;

constexpr std::chrono::milliseconds kBound{30'000};
constexpr std::int64_t kStart = 1'467'554'100'000;

json robot(int id, double x, double y) {
  return {{"id", id}, {"pose", {x, y, 0.0}}, {"targetPose", {x, y, 0.0}}, {"intention", "play"}};
}

json obstacle(double x, double y) {
  return {{"position", {x, y, 0.0}}, {"confidence", 1.0}, {"radius", 0.25}};
}

json record(std::int64_t ms, const json& robots, const json& obstacles) {
  const json state{
      {"type", "worldstate"}, {"robots", robots}, {"obstacles", obstacles}, {"ageMs", 20}};
  return {{"teamName", "made up"}, {"timestamp", ms}, {"worldstate", state}};
}

/// Ten seconds of two robots against two that stand still, in the box's frame: x right, y ahead.
class RefboxGame : public ::testing::Test {
 protected:
  RefboxGame() {
    put("game.msl",
        "New ScoreClient @ 127.0.0.1\n" + std::to_string(kStart + 1000) +
            ",00:00(00:00),1st Half,s,START\n" + std::to_string(kStart + 9000) +
            ",00:08(00:08),1st Half - STOP,S,STOP\n");
    // They look the other way: (3, 2) is (-3, -2) to them.
    for (int i = 0; i < 100; ++i) {
      const std::int64_t ms = kStart + 100 * i;
      seen_.push_back(record(ms,
                             json::array({robot(1, -4.0, 0.0), robot(2, 4.0, 0.0)}),
                             json::array({obstacle(-3.0, 2.0), obstacle(3.2, 2.0)})));
      there_.push_back(
          record(ms + 40, json::array({robot(3, 3.0, -2.0), robot(4, -3.0, -2.0)}), json::array()));
    }
  }

  void put(const std::string& name, const std::string& text) const {
    std::ofstream(directory_.path() / name) << text;
  }

  void write_teams() const {
    put("game.A.msl", seen_.dump());
    put("game.B.msl", there_.dump());
  }

  /// The lines that it prints. Exit code as expected, or the test fails.
  std::vector<json> score(int exit_code = 0) {
    ChildProcess child({test::program("teamsight").string(),
                        "score",
                        "refbox-game",
                        (directory_.path() / "game.msl").string()});
    EXPECT_EQ(child.wait_exit(kBound), exit_code) << child.err();
    errors_ = child.err();
    std::istringstream lines(child.out());
    std::vector<json> said;
    for (std::string line; std::getline(lines, line);) said.push_back(json::parse(line));
    return said;
  }

  test::TempDirectory directory_;
  json seen_ = json::array();
  json there_ = json::array();
  std::string errors_;
};

const json& line_of(const std::vector<json>& lines, const std::string& estimator) {
  static const json kNone;
  for (const json& line : lines) {
    if (line.value("estimator", "") == estimator) return line;
  }
  ADD_FAILURE() << "no line of " << estimator;
  return kNone;
}

TEST_F(RefboxGame, ComparesWithTheOtherTeamTurnedByHalfATurn) {
  write_teams();

  const auto lines = score();

  const json& recorded = line_of(lines, "as-recorded");
  EXPECT_EQ(recorded["count"], 162);  // two in each of the 81 records while in play
  EXPECT_EQ(recorded["within_half_m"], 1.0);
  EXPECT_LE(recorded["median_m"], 0.2);
  const json& fused = line_of(lines, "teamsight");
  EXPECT_EQ(fused["within_half_m"], 1.0);
  EXPECT_NEAR(fused["localisation_m"], 0.141, 0.02);  // one of the two is 0.2 m aside
  EXPECT_EQ(fused["missed"], 0.0);
  EXPECT_EQ(fused["false"], 0.0);
  EXPECT_EQ(line_of(lines, "two-witnesses")["missed"], 2.0);  // the list names no two
}

TEST_F(RefboxGame, CountsWhatItLeavesOutByReason) {
  seen_.push_back(record(kStart + 5000, json::array({robot(1, 0.0, -1.0)}), json::array()));
  seen_.push_back(record(kStart + 9900, json::array({robot(1, 0.0, -1.0)}), json::array()));
  json odd =
      record(kStart + 10000, json::array({robot(1, 0.0, 0.0), robot(2, 7.0, 0.0)}), json::array());
  odd["worldstate"]["robots"][0]["pose"] = {nullptr, 1.0, 0.0};
  odd["worldstate"]["obstacles"].push_back({{"position", {nullptr, nullptr, nullptr}}});
  odd["worldstate"]["obstacles"].push_back(obstacle(3.0, 20.0));
  seen_.push_back(odd);
  seen_.push_back({{"teamName", "made up"}});
  json misspelled = robot(1, 0.0, 0.0);
  misspelled.erase("targetPose");
  misspelled["target pose"] = {0.0, 0.0, 0.0};
  misspelled["intention"] = "Waiting for my turn";
  seen_.push_back(record(kStart + 11'500, json::array({misspelled}), json::array()));
  seen_.push_back(record(5, json::array({robot(1, 0.0, 0.0)}), json::array()));
  write_teams();

  const json first = score().at(0);

  EXPECT_EQ(first["dropped"],
            json({{"obstacle_null", 1},
                  {"obstacle_off_field", 1},
                  {"record_malformed", 1},
                  {"record_without_time", 1},
                  {"robot_off_field", 1},
                  {"robot_waiting", 1},
                  {"robot_without_pose", 1},
                  {"stamp_backwards", 1},
                  {"stamp_repeated", 1},
                  {"target_misspelled", 1}}));
  EXPECT_EQ(first["records"], 106);
  EXPECT_EQ(first["gaps"], 1);
}

TEST_F(RefboxGame, GivesEachRobotItsOwnPlaceInAListWithNulls) {
  // One list, one place for each robot: two robots name the same thing.
  for (json& each : seen_) {
    each["worldstate"]["robots"].push_back(robot(3, 0.0, -3.0));
    each["worldstate"]["obstacles"] = {
        obstacle(-3.0, 2.0), {{"position", {nullptr, nullptr, nullptr}}}, obstacle(-3.0, 2.0)};
  }
  write_teams();

  // Robot 2 is 7.3 m away, further than the rule of two witnesses believes; robot 3 is not.
  EXPECT_EQ(line_of(score(), "two-witnesses")["missed"], 1.0);
}

TEST_F(RefboxGame, RefusesMissingGarbageAndCutOffFilesInOneLine) {
  score(2);
  EXPECT_THAT(errors_, HasSubstr("game.A.msl: cannot be read"));

  write_teams();
  put("game.A.msl",
      "\x7f"
      "ELF garbage");
  score(2);
  EXPECT_THAT(errors_, HasSubstr("game.A.msl: no recorded game, expected a JSON list"));

  put("game.A.msl", seen_.dump().substr(0, 9000));
  score(2);
  EXPECT_THAT(errors_, HasSubstr("game.A.msl: cut off, expected a whole JSON list"));

  put("game.A.msl", "[]");
  score(2);
  EXPECT_THAT(errors_, HasSubstr("game.A.msl: no usable world state"));

  put("game.msl", "nobody ever started it");
  score(2);
  EXPECT_THAT(errors_, HasSubstr("game.msl: no START and STOP, expected a game's events"));
  EXPECT_EQ(std::count(errors_.begin(), errors_.end(), '\n'), 1);
}

}  // namespace
}  // namespace teamsight
