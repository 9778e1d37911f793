// tests/tools/echo_command_test.cpp: `teamsight echo` beside a real writer.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
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

constexpr std::chrono::milliseconds kBound{20'000};

ChildProcess echo(const std::vector<std::string>& arguments) {
  std::vector<std::string> argv{test::program("teamsight"), "echo"};
  argv.insert(argv.end(), arguments.begin(), arguments.end());
  return ChildProcess(argv);
}

/// The arguments that lead to this test's own domain.
std::vector<std::string> with_domain(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(),
                   {"--team",
                    test::source_path("config/teams/demo.textproto"),
                    "--team-domain",
                    std::to_string(test::unique_domain())});
  return arguments;
}

ChildProcess fake(const std::string& role) {
  return ChildProcess({TEAMSIGHT_FAKE_TEAM,
                       role,
                       "3",
                       std::to_string(test::unique_domain()),
                       test::source_path("config/dds/loopback.xml"),
                       "demo"});
}

std::vector<nlohmann::json> lines_of(const std::string& text) {
  std::vector<nlohmann::json> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(nlohmann::json::parse(line));
  return lines;
}

TEST(EchoCommand, WritesOneJsonLinePerSampleAndStopsAtTheCount) {
  const ChildProcess robot = fake("robot");

  ChildProcess command = echo(with_domain({"RobotState", "--count", "3"}));
  const auto exit_code = command.wait_exit(kBound);
  const auto lines = lines_of(command.out());

  EXPECT_EQ(exit_code, 0) << command.err();
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[2]["topic"], "RobotState");
  EXPECT_EQ(lines[2]["presence"], "alive");
  EXPECT_EQ(lines[2]["message"]["sample"]["robot_id"], 3);
  EXPECT_EQ(lines[2]["message"]["posture"]["status"], "POSTURE_OK");
  EXPECT_EQ(lines[2]["message"]["posture"]["posture"]["cov"].size(), 6U);
  EXPECT_EQ(lines[2]["message"]["camera_lost"], false);
}

TEST(EchoCommand, TellsThatAWriterFellSilent) {
  ChildProcess fusion = fake("fusion");
  ChildProcess command = echo(with_domain({"WorldModel"}));
  ASSERT_TRUE(test::wait_until([&]() { return !command.out().empty(); }, kBound)) << command.err();

  fusion.kill(SIGKILL);

  EXPECT_TRUE(test::wait_until(
      [&]() { return command.out().find("\"presence\":\"silent\"") != std::string::npos; },
      kBound));
  command.kill(SIGINT);
  EXPECT_EQ(command.wait_exit(kBound), 0);
  const std::string out = command.out();
  const auto lines = lines_of(out);
  const auto silent = std::find_if(lines.begin(), lines.end(), [](const nlohmann::json& line) {
    return line["presence"] == "silent";
  });
  ASSERT_NE(silent, lines.end());
  EXPECT_TRUE((*silent)["message"].is_null());
}

TEST(EchoCommand, SaysWhyNothingWasHeard) {
  ChildProcess command = echo(with_domain({"GameState", "--seconds", "0.2"}));

  EXPECT_EQ(command.wait_exit(kBound), 1);
  EXPECT_EQ(command.out(), "");
  EXPECT_THAT(command.err(), HasSubstr("no GameState on domain"));
  EXPECT_THAT(command.err(), HasSubstr("nobody writes it there"));
}

TEST(EchoCommand, ListsTheTopicsWhenThereIsNoneOfThatName) {
  ChildProcess command = echo(with_domain({"Ball"}));

  EXPECT_EQ(command.wait_exit(kBound), 2);
  const std::string said = command.err();
  EXPECT_THAT(said, HasSubstr("there is no topic \"Ball\""));
  EXPECT_THAT(said, HasSubstr("RobotState, Sightings"));
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
}

TEST(EchoCommand, AsksWhichComputerATopicInsideOneIsMeantFor) {
  ChildProcess command = echo(with_domain({"Odometry"}));

  EXPECT_EQ(command.wait_exit(kBound), 2);
  EXPECT_THAT(command.err(), HasSubstr("expected --robot or --host-tag"));
}

}  // namespace
}  // namespace teamsight
