// tests/recording/log_command_test.cpp: `teamsight log` with real processes, read back by npm's
// @mcap/core.
#include <chrono>
#include <csignal>
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

using test::ChildProcess;
using ::testing::HasSubstr;

constexpr std::chrono::milliseconds kBound{30'000};
const std::string kTeam = "config/teams/demo.textproto";

ChildProcess log(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {test::program("teamsight"), "log"});
  return ChildProcess(arguments);
}

std::vector<std::string> on_domain(std::vector<std::string> arguments) {
  arguments.insert(
      arguments.end(),
      {"--team", test::source_path(kTeam), "--team-domain", std::to_string(test::unique_domain())});
  return arguments;
}

ChildProcess fake(const std::string& role, const std::string& robot) {
  return ChildProcess({TEAMSIGHT_FAKE_TEAM,
                       role,
                       robot,
                       std::to_string(test::unique_domain()),
                       test::source_path("config/dds/loopback.xml"),
                       "demo"});
}

nlohmann::json last_line(const std::string& text) {
  std::istringstream stream(text);
  std::string last;
  for (std::string line; std::getline(stream, line);) last = line;
  return nlohmann::json::parse(last);
}

/// What npm's reader finds in a file.
nlohmann::json read_by_others(const std::filesystem::path& file,
                              const std::vector<std::string>& window = {}) {
  std::vector<std::string> argv{
      "/usr/bin/env", "node", test::source_path("tests/recording/read_mcap.mjs"), file};
  argv.insert(argv.end(), window.begin(), window.end());
  ChildProcess reader(argv, {{"PAGE_DIR", TEAMSIGHT_PAGE_DIR}});
  EXPECT_EQ(reader.wait_exit(kBound), 0) << reader.err();
  return last_line(reader.out());
}

class LogCommand : public ::testing::Test {
 protected:
  /// Records a robot and a fusion until `seconds` are over.
  std::filesystem::path record(const std::string& seconds) {
    const ChildProcess robot = fake("robot", "2");
    const ChildProcess fusion = fake("fusion", "3");
    ChildProcess recorder =
        log(on_domain({"record", "--out", folder_.path(), "--seconds", seconds}));
    EXPECT_EQ(recorder.wait_exit(kBound), 0) << recorder.err();
    return nlohmann::json::parse(recorder.out().substr(0, recorder.out().find('\n')))["file"]
        .get<std::string>();
  }

  test::TempDirectory folder_;
};

TEST_F(LogCommand, RecordsWhatOthersCanReadByIndexAndWithEveryCrc) {
  const std::filesystem::path file = record("3");

  const nlohmann::json all = read_by_others(file);
  const nlohmann::json window = read_by_others(file, {"1", "2"});
  ChildProcess info = log({"info", file});
  EXPECT_EQ(info.wait_exit(kBound), 0) << info.err();

  EXPECT_GT(all["topics"]["teamsight/v1/RobotState"], 30);
  EXPECT_GT(all["topics"]["teamsight/v1/Sightings"], 30);
  EXPECT_GT(all["topics"]["teamsight/v1/WorldModel"], 30);
  EXPECT_GE(all["topics"]["teamsight/v1/Diagnostics"], 2);
  EXPECT_TRUE(all["done"]);
  EXPECT_TRUE(all["ordered"]);
  EXPECT_EQ(all["indexed"], all["statistics"]);
  EXPECT_EQ(all["metadata"]["teamsight.recording"]["team"], "demo");
  EXPECT_LT(window["indexed"], all["indexed"]);
  EXPECT_GT(window["indexed"], 0);
  const nlohmann::json facts = last_line(info.out());
  EXPECT_EQ(facts["messages"], all["statistics"]);
  EXPECT_TRUE(facts["damage"].is_null());
}

TEST_F(LogCommand, LosesAtMostTheOpenChunkToAKillAndCutMendsTheFile) {
  const ChildProcess robot = fake("robot", "2");
  ChildProcess recorder = log(on_domain({"record", "--out", folder_.path()}));
  ASSERT_TRUE(test::wait_until([&]() { return !recorder.out().empty(); }, kBound));
  const auto file = last_line(recorder.out())["file"].get<std::string>();
  ASSERT_TRUE(test::wait_until([&]() { return std::filesystem::file_size(file) > 9'000; }, kBound));
  recorder.kill(SIGKILL);
  EXPECT_NE(recorder.wait_exit(kBound), 0);

  ChildProcess info = log({"info", file});
  EXPECT_EQ(info.wait_exit(kBound), 1);
  EXPECT_THAT(info.err(), HasSubstr("the file ends"));
  const nlohmann::json facts = last_line(info.out());
  EXPECT_GT(facts["messages"], 20);
  const std::string mended = folder_.path() / "mended.mcap";
  ChildProcess cut = log({"cut", "--in", file, "--out", mended});
  EXPECT_EQ(cut.wait_exit(kBound), 0) << cut.err();

  EXPECT_EQ(read_by_others(mended)["statistics"], facts["messages"]);
}

TEST_F(LogCommand, CutsAWindowOfSomeTopicsAndConvertsIt) {
  const std::filesystem::path file = record("3");
  const std::string part = folder_.path() / "part.mcap";
  ChildProcess cut = log({"cut",
                          "--in",
                          file,
                          "--out",
                          part,
                          "--from",
                          "1",
                          "--until",
                          "2",
                          "--topics",
                          "RobotState"});
  ASSERT_EQ(cut.wait_exit(kBound), 0) << cut.err();
  const nlohmann::json facts = read_by_others(part);
  const int count = facts["topics"]["teamsight/v1/RobotState"];

  ChildProcess lines = log({"convert", "--in", part, "--format", "jsonl"});
  ASSERT_EQ(lines.wait_exit(kBound), 0) << lines.err();
  ChildProcess tables = log({"convert", "--in", part, "--format", "csv", "--out", folder_.path()});
  ASSERT_EQ(tables.wait_exit(kBound), 0) << tables.err();

  EXPECT_EQ(facts["topics"].size(), 1U);
  EXPECT_EQ(std::ranges::count(lines.out(), '\n'), count);
  EXPECT_EQ(last_line(lines.out())["message"]["sample"]["robot_id"], 2);
  std::ifstream table(folder_.path() / "RobotState.csv");
  std::string head;
  std::getline(table, head);
  EXPECT_THAT(head, HasSubstr("posture.posture.cov.0"));
  EXPECT_EQ(std::count(std::istreambuf_iterator<char>(table), {}, '\n'), count);
}

TEST_F(LogCommand, PutsARecordingBackOnTheBusInThePresent) {
  const std::filesystem::path file = record("2");
  ChildProcess echo({test::program("teamsight"),
                     "echo",
                     "Sightings",
                     "--count",
                     "20",
                     "--team",
                     test::source_path(kTeam),
                     "--team-domain",
                     std::to_string(test::unique_domain())});
  ChildProcess replay = log(on_domain({"replay", "--in", file, "--speed", "2"}));

  ASSERT_EQ(echo.wait_exit(kBound), 0) << echo.err();
  const nlohmann::json heard = last_line(echo.out());
  const std::int64_t age_ns = std::int64_t{heard["received_ns"]} -
                              std::stoll(heard["message"]["publish_ns"].get<std::string>());

  EXPECT_EQ(heard["message"]["sample"]["robot_id"], 2);
  EXPECT_GT(age_ns, -1'000'000'000);
  EXPECT_LT(age_ns, 3'000'000'000);
  EXPECT_EQ(replay.wait_exit(kBound), 0) << replay.err();
  EXPECT_GT(last_line(replay.out())["written"], 60);
}

TEST_F(LogCommand, ImportsAGameOfTheLeaguesBoxWithItsDirtIntoF) {
  // As the box wrote them: one record in two lines, nulls, a stamp that runs back, an open end.
  const std::filesystem::path worlds = folder_.write("game.A.msl", R"([
{"teamName": "Us","timestamp": 1467553851531,"gametimeMs": 1,"worldstate": {"type": "worldstate",
 "teamName": "US", "robots": [{"id": 2, "pose": [1.0, 4.0, 0.5], "velocity": [0.5, 1.0, 0.0]},
 {"id": 3, "pose": [null, null, null]}], "balls": [{"position": [2, 3, 0.1], "confidence": -100}],
 "obstacles": [{"position": [1, 1], "radius": 0.3}]}},
{"teamName": "Us","timestamp": 1467553851431,"worldstate": {"robots": [], "balls": []}},
{"teamName": "Us","worldstate": 7},
)");
  const std::filesystem::path events =
      folder_.write("game.msl",
                    "New BaseStation @ 172.16.63.114\n"
                    "1467553851500,00:40(00:00),1st,K,CYAN Kickoff\n"
                    "1467553851600,00:40(00:00),1st,s,START\r\n");
  const std::string out = folder_.path() / "game.mcap";

  ChildProcess import = log({"import", "--worlds", worlds, "--events", events, "--out", out});
  ASSERT_EQ(import.wait_exit(kBound), 0) << import.err();
  ChildProcess lines = log({"convert", "--in", out, "--format", "jsonl"});
  ASSERT_EQ(lines.wait_exit(kBound), 0) << lines.err();

  std::vector<nlohmann::json> found;
  std::istringstream stream(lines.out());
  for (std::string line; std::getline(stream, line);) found.push_back(nlohmann::json::parse(line));
  ASSERT_EQ(found.size(), 4U) << lines.out();
  const nlohmann::json& world = found[2]["message"];
  EXPECT_EQ(found[2]["log_ns"], 1467553851531000000);
  EXPECT_EQ(world["sample"]["robot_id"], 0) << "no fusion made it";
  EXPECT_EQ(world["teammates"].size(), 1U);
  EXPECT_EQ(world["teammates"][0]["posture"]["x_m"], 4.0);
  EXPECT_EQ(world["teammates"][0]["posture"]["y_m"], -1.0);
  EXPECT_EQ(world["teammates"][0]["vy_mps"], -0.5);
  EXPECT_EQ(world["balls"].size(), 0U) << "a confidence of -100 is none";
  EXPECT_EQ(world["obstacles"][0]["x_m"], 1.0);
  EXPECT_EQ(found[1]["message"]["piece_is_ours"], true);
  EXPECT_EQ(found[3]["message"]["running"], true);
}

TEST_F(LogCommand, RefusesWhatIsNoRecordingInOneLine) {
  const std::filesystem::path file = folder_.write("no.mcap", "this is text, not a recording");

  ChildProcess info = log({"info", file});

  EXPECT_EQ(info.wait_exit(kBound), 2);
  EXPECT_THAT(info.err(), HasSubstr("no.mcap: no MCAP file"));
  EXPECT_EQ(std::ranges::count(info.err(), '\n'), 1);
}

}  // namespace
}  // namespace teamsight
