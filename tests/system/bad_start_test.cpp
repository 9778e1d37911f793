// tests/system/bad_start_test.cpp: a network, a team or keys that are wrong: every program says the
// same one line with what to do, exits with 2, and nothing has been started.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/system/team.hpp"

namespace teamsight::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Matcher;

class BadStart : public ::testing::Test {
 protected:
  [[nodiscard]] std::string robot_file() const {
    return team_.config().file("robots/robot1.textproto");
  }

  [[nodiscard]] std::string team_file() const {
    return team_.config().file("teams/demo.textproto");
  }

  /// The command lines of those that listen with the robot's or the team's file.
  [[nodiscard]] std::vector<std::vector<std::string>> robots_programs() const {
    const std::string frame = team_.config().file("frame.yuyv");
    std::ofstream(frame) << std::string(std::size_t{640} * 480 * 2, '\0');
    return {{"teamsight-agent", "--robot", robot_file(), "--source", "raw:" + frame},
            {"teamsight-fusion", "--robot", robot_file()},
            {"teamsight", "doctor", "--robot", robot_file()}};
  }

  [[nodiscard]] std::vector<std::vector<std::string>> all_programs() const {
    auto all = robots_programs();
    const fs::path page = team_.config().file("index.html");
    std::ofstream(page) << "<!doctype html><title>page</title>";
    all.push_back(
        {"teamsight-monitor", "--team", team_file(), "--web", page.parent_path(), "--port", "0"});
    all.push_back({"teamsight", "echo", "RobotState", "--team", team_file()});
    return all;
  }

  static void expect_refusal(std::vector<std::vector<std::string>> programs,
                             const Matcher<std::string>& line,
                             const ChildProcess::Environment& environment = {}) {
    for (auto& argv : programs) {
      const std::string name = argv.front();
      argv.front() = program(name).string();
      ChildProcess process(argv, environment);
      EXPECT_EQ(process.wait_exit(30s), 2) << name;
      const std::string words = process.err();
      EXPECT_EQ(std::count(words.begin(), words.end(), '\n'), 1) << name << ": " << words;
      EXPECT_THAT(words, line) << name;
      EXPECT_EQ(process.out(), "") << name;
    }
  }

  /// Keys for robot 1 and the coach, and the team file that names them.
  void secure() {
    ChildProcess keys({program("teamsight").string(),
                       "keys",
                       "--out",
                       keys_folder().string(),
                       "--team",
                       team_file(),
                       "--robots",
                       "1"});
    ASSERT_EQ(keys.wait_exit(30s), 0) << keys.err();
    team_.config().append("teams/demo.textproto", "security: \"../keys\"\n");
  }

  [[nodiscard]] fs::path keys_folder() const { return team_.config().file("keys"); }

  /// A wall clock so far ahead, for what is preloaded.
  [[nodiscard]] ChildProcess::Environment clock_ahead(std::chrono::seconds ahead) const {
    const std::string path = team_.config().file("clock");
    const std::int64_t seconds = ahead.count();
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(&seconds), sizeof seconds);
    return {{"LD_PRELOAD", LOOSE_CLOCK}, {"TEAMSIGHT_LOOSE_CLOCK", path}};
  }

  Team team_{"robot"};
};

TEST_F(BadStart, NamesTheInterfacesThatThereAre) {
  std::ifstream file(source_path("config/dds/loopback.xml"));
  std::string text{std::istreambuf_iterator<char>(file), {}};
  const std::size_t at = text.find("name=\"lo\"");
  ASSERT_NE(at, std::string::npos);
  team_.config().replace("dds/loopback.xml", text.replace(at, 9, "name=\"wlan77\""));

  expect_refusal(all_programs(),
                 AllOf(HasSubstr("loopback.xml: wlan77: does not match an available interface"),
                       HasSubstr("This computer has: "),
                       HasSubstr("lo")));
}

TEST_F(BadStart, NamesTheRobotsThatTheTeamHas) {
  team_.config().append("teams/demo.textproto", "robot: [2, 3]\n");

  expect_refusal(robots_programs(),
                 AllOf(HasSubstr("robot1.textproto"),
                       HasSubstr("key 'id': found 1, expected one of the robots that "),
                       HasSubstr("demo.textproto lists: 2, 3")));
}

TEST_F(BadStart, NamesTheFolderOfKeysThatIsMissing) {
  team_.config().append("teams/demo.textproto", "security: \"../keys\"\n");

  expect_refusal(all_programs(), HasSubstr("key 'security': found no folder "));
}

TEST_F(BadStart, SaysWhereARobotsKeysComeFrom) {
  secure();
  fs::remove_all(keys_folder() / "robot1");

  expect_refusal(robots_programs(),
                 AllOf(HasSubstr("security " + (keys_folder() / "robot1").string()),
                       HasSubstr("make one for this robot with --robots, or copy it")));
}

TEST_F(BadStart, SaysHowToCloseAKeyThatOthersMayRead) {
  secure();
  for (const char* speaker : {"robot1", "coach"}) {
    fs::permissions(
        keys_folder() / speaker / "identity.key", fs::perms::group_read, fs::perm_options::add);
  }

  expect_refusal(all_programs(),
                 HasSubstr("identity.key: others may read it, expected a key of "
                           "this user alone: chmod 600 "));
}

TEST_F(BadStart, SaysHowToRenewKeysThatHaveRunOut) {
  secure();

  expect_refusal(
      all_programs(),
      AllOf(HasSubstr("security " + keys_folder().string()),
            HasSubstr("set it if that is wrong, else make new ones: teamsight keys --renew")),
      clock_ahead(24h * 500));
}

TEST_F(BadStart, SaysThatAClockIsBeforeTheKeysTime) {
  secure();

  expect_refusal(all_programs(),
                 AllOf(HasSubstr("security " + keys_folder().string()),
                       HasSubstr("this computer's clock says "),
                       HasSubstr(": set it\n")),
                 clock_ahead(-24h * 500));
}

}  // namespace
}  // namespace teamsight::test
