// tests/browser/page_test.cpp: the real page in a real browser, before real processes. See
// page.mjs.
#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "tests/support/process.hpp"

namespace teamsight {
namespace {

using std::chrono::milliseconds;
using test::ChildProcess;
using ::testing::HasSubstr;

constexpr milliseconds kBound{40'000};

std::int64_t wall_clock_ms() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<milliseconds>(now).count();
}

/// A station with the built page, and as many of the fake team as a test wants.
class Page : public ::testing::Test {
 protected:
  void SetUp() override {
    start_station("0");
    const std::string line = station_->out();
    const auto begin = line.find("http://");
    url_ = line.substr(begin, line.find('"', begin) - begin);
    std::filesystem::create_directories(TEAMSIGHT_ARTEFACTS);
  }

  void start_station(const std::string& port) {
    station_.emplace(std::vector<std::string>{test::program("teamsight-monitor"),
                                              "--team",
                                              test::source_path("config/teams/demo.textproto"),
                                              "--team-domain",
                                              std::to_string(test::unique_domain()),
                                              "--port",
                                              port});
    ASSERT_TRUE(test::wait_until([&]() { return !station_->out().empty(); }, kBound))
        << station_->err();
  }

  [[nodiscard]] std::string port() const {
    const auto colon = url_.rfind(':');
    return url_.substr(colon + 1, url_.size() - colon - 2);
  }

  void start_fake(const std::string& role, const std::string& robot) {
    fakes_.emplace_back(std::vector<std::string>{TEAMSIGHT_FAKE_TEAM,
                                                 role,
                                                 robot,
                                                 std::to_string(test::unique_domain()),
                                                 test::source_path("config/dds/loopback.xml"),
                                                 "demo"});
  }

  void start_team() {
    for (const char* robot : {"1", "2", "3", "4", "5"}) start_fake("robot", robot);
    start_fake("fusion", "3");
  }

  [[nodiscard]] ChildProcess open(const std::string& scenario) const {
    return ChildProcess({"/usr/bin/env",
                         "node",
                         test::source_path("tests/browser/page.mjs"),
                         scenario,
                         url_,
                         TEAMSIGHT_ARTEFACTS},
                        {{"PAGE_DIR", TEAMSIGHT_PAGE_DIR}});
  }

  static bool says(const ChildProcess& browser, const std::string& word) {
    return test::wait_until([&]() { return browser.out().find(word) != std::string::npos; },
                            kBound);
  }

  std::optional<ChildProcess> station_;
  std::vector<ChildProcess> fakes_;
  std::string url_;
};

TEST_F(Page, ShowsTheTeamMovingOnOneScreen) {
  start_team();

  ChildProcess browser = open("shows");

  EXPECT_EQ(browser.wait_exit(kBound), 0) << browser.err();
  EXPECT_THAT(browser.out(), HasSubstr("moved_from"));
  for (const char* name : {"page-1280x800.png", "page-1920x1080.png"}) {
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(TEAMSIGHT_ARTEFACTS) / name));
  }
}

TEST_F(Page, FlipsTheFieldByKeyAndButton) {
  start_team();

  ChildProcess browser = open("flips");

  EXPECT_EQ(browser.wait_exit(kBound), 0) << browser.err();
}

TEST_F(Page, GreysOutARobotThatFellSilentWithinASecond) {
  start_team();
  ChildProcess browser = open("greys");
  ASSERT_TRUE(says(browser, "ready")) << browser.err();

  const std::int64_t killed_at_ms = wall_clock_ms();
  fakes_.at(1).kill(SIGKILL);
  const auto exit_code = browser.wait_exit(kBound);

  ASSERT_EQ(exit_code, 0) << browser.err();
  const std::string key = "\"lost_at_ms\":";
  const std::string out = browser.out();
  const std::int64_t lost_at_ms = std::stoll(out.substr(out.find(key) + key.size()));
  EXPECT_LT(lost_at_ms - killed_at_ms, 1000);
  EXPECT_GT(lost_at_ms - killed_at_ms, 0);
}

TEST_F(Page, ComesBackAfterTheStationWasStartedAgain) {
  start_team();
  ChildProcess browser = open("reconnects");
  ASSERT_TRUE(says(browser, "live")) << browser.err();

  station_->end();
  ASSERT_TRUE(says(browser, "gone")) << browser.err();
  start_station(port());

  EXPECT_EQ(browser.wait_exit(kBound), 0) << browser.err();
}

TEST_F(Page, SaysWhyNothingShows) {
  ChildProcess browser = open("explains");

  EXPECT_EQ(browser.wait_exit(kBound), 0) << browser.err();
}

}  // namespace
}  // namespace teamsight
