// tests/deploy/demo_test.cpp: deploy/demo starts a team, and nothing of it is left when it ends.
#include <chrono>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include "tests/support/process.hpp"

namespace teamsight::test {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr auto kStart = 60s;  // with other tests beside it
constexpr auto kEnd = 20s;

// As far as it can be read: that of a process that ends goes away meanwhile.
std::string file_text(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// The programs whose command line names a folder; ended ones have none.
std::vector<pid_t> processes_using(const fs::path& folder) {
  std::vector<pid_t> found;
  for (const fs::directory_entry& entry : fs::directory_iterator("/proc")) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") == std::string::npos &&
        file_text(entry.path() / "cmdline").find(folder.string()) != std::string::npos) {
      found.push_back(std::stoi(name));
    }
  }
  return found;
}

// One demo with two robots, on programs that are built already.
class Demo {
 public:
  // @param more  arguments
  // @param rate  of the cameras; empty: the demo's own choice
  explicit Demo(const std::vector<std::string>& more = {}, const std::string& rate = "5")
      : process_(command(more, rate)) {}

  // Waits until it says that the team is playing.
  [[nodiscard]] bool plays() {
    return wait_until([&] { return said("Open +(http://[^ \n]+)") || !process_.is_running(); },
                      kStart) &&
           process_.is_running();
  }

  [[nodiscard]] std::string address() const { return matched("Open +(http://[^ \n]+)"); }

  [[nodiscard]] fs::path folder() const { return matched("Logs: ([^ \n]+)/[*].log"); }

  // Whether its output has this; a regular expression.
  [[nodiscard]] bool said(const std::string& pattern) const {
    return std::regex_search(process_.out(), std::regex(pattern));
  }

  [[nodiscard]] ChildProcess& process() { return process_; }

  [[nodiscard]] std::string all_said() const { return process_.out() + process_.err(); }

 private:
  static std::vector<std::string> command(const std::vector<std::string>& more,
                                          const std::string& rate) {
    std::vector<std::string> argv{source_path("deploy/demo").string(),
                                  "--robots",
                                  "2",
                                  "--bin",
                                  program("teamsight-agent").parent_path().string()};
    if (!rate.empty()) {
      argv.insert(argv.end(), {"--rate", rate});
    }
    argv.insert(argv.end(), more.begin(), more.end());
    return argv;
  }

  [[nodiscard]] std::string matched(const std::string& pattern) const {
    const std::string text = process_.out();
    std::smatch match;
    if (!std::regex_search(text, match, std::regex(pattern))) {
      throw std::runtime_error("the demo did not say " + pattern + ":\n" + all_said());
    }
    return match[1];
  }

  ChildProcess process_;
};

TEST(Demo, EndsEveryProcessOnCtrlC) {
  Demo demo;
  ASSERT_TRUE(demo.plays()) << demo.all_said();
  const fs::path folder = demo.folder();
  // Simulator, coach station, two of each robot; some have processes of their own.
  ASSERT_GE(processes_using(folder).size(), 6U);

  demo.process().kill(SIGINT);

  EXPECT_EQ(demo.process().wait_exit(kEnd), 0) << demo.all_said();
  EXPECT_THAT(processes_using(folder), testing::IsEmpty());
  EXPECT_FALSE(fs::exists(folder));
  EXPECT_THAT(demo.all_said(), testing::Not(testing::HasSubstr("was killed")));
}

TEST(Demo, PlaysBeforeARefereeBoxThatHearsOfItsWorld) {
  Demo demo({"--referee"});
  ASSERT_TRUE(demo.plays()) << demo.all_said();
  const fs::path log = demo.folder() / "box.log";

  EXPECT_TRUE(wait_until([&] { return file_text(log).find("\"worldstate\"") != std::string::npos; },
                         kStart))
      << file_text(log);

  demo.process().kill(SIGINT);
  EXPECT_EQ(demo.process().wait_exit(kEnd), 0) << demo.all_said();
}

TEST(Demo, DrawsAtTheRateThatItIsAskedForAndSaysWhetherItHolds) {
  Demo demo;
  ASSERT_TRUE(demo.plays()) << demo.all_said();
  EXPECT_TRUE(demo.said("cameras: 2 of 640x480 at 5 Hz: as asked")) << demo.all_said();

  EXPECT_TRUE(wait_until(
      [&] { return demo.said("cameras: (hold|do not hold their rate:) [0-9.]+ of 5 Hz"); }, kStart))
      << demo.all_said();
}

TEST(Demo, ChoosesARateForThisComputer) {
  Demo demo({}, "");
  ASSERT_TRUE(demo.plays()) << demo.all_said();

  EXPECT_TRUE(demo.said("cameras: 2 of 640x480 at [0-9]+ Hz: this computer has [0-9]+ core"))
      << demo.all_said();
}

TEST(Demo, SaysWhichProcessEndedAndEndsTheOthers) {
  Demo demo;
  ASSERT_TRUE(demo.plays()) << demo.all_said();
  const fs::path folder = demo.folder();
  const std::vector<pid_t> agents = processes_using(folder / "streams" / "robot2.stream");
  ASSERT_EQ(agents.size(), 1U);

  ::kill(agents.front(), SIGKILL);

  EXPECT_EQ(demo.process().wait_exit(kEnd), 1) << demo.all_said();
  EXPECT_THAT(demo.process().out(), testing::HasSubstr("agent-2 ended by itself, exit code 137"));
  EXPECT_THAT(processes_using(folder), testing::IsEmpty());
}

TEST(Demo, LeavesNoProcessEvenIfItIsKilled) {
  Demo demo;
  ASSERT_TRUE(demo.plays()) << demo.all_said();
  const fs::path folder = demo.folder();

  ::kill(demo.process().pid(), SIGKILL);

  EXPECT_TRUE(wait_until([&] { return processes_using(folder).empty(); }, kEnd));
  fs::remove_all(folder);  // which a killed script cannot do
}

TEST(Demo, RunsBesideAnother) {
  Demo one;
  Demo other;

  ASSERT_TRUE(one.plays()) << one.all_said();
  ASSERT_TRUE(other.plays()) << other.all_said();

  EXPECT_NE(one.address(), other.address());
  const std::string team = "config/teams/demo.textproto";
  EXPECT_NE(file_text(one.folder() / team), file_text(other.folder() / team));
}

}  // namespace
}  // namespace teamsight::test
