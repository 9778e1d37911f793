// tests/browser/page_test.cpp: the real page in a real browser, before real processes. See
// page.mjs.
#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
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
    read_addresses();
    std::filesystem::create_directories(TEAMSIGHT_ARTEFACTS);
  }

  void read_addresses() {
    const std::string line = station_->out();
    url_ = url_in(line);
    const auto token = line.find("#token=") + 7;
    token_ = line.substr(token, line.find('"', token) - token);
  }

  void start_station(const std::string& port, const std::vector<std::string>& more = {}) {
    std::vector<std::string> argv{test::program("teamsight-monitor"),
                                  "--team",
                                  test::source_path("config/teams/demo.textproto"),
                                  "--team-domain",
                                  std::to_string(test::unique_domain()),
                                  "--port",
                                  port};
    argv.insert(argv.end(), more.begin(), more.end());
    station_.emplace(argv);
    ASSERT_TRUE(test::wait_until([&]() { return !station_->out().empty(); }, kBound))
        << station_->err();
  }

  /// The address in what a station says first.
  static std::string url_in(const std::string& line) {
    const auto begin = line.find("http://");
    return line.substr(begin, line.find('"', begin) - begin);
  }

  static std::string port_in(const std::string& url) {
    const auto colon = url.rfind(':');
    return url.substr(colon + 1, url.size() - colon - 2);
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

  /// @param fragment     of the address, e.g. "#token=..."
  /// @param environment  more of it
  [[nodiscard]] ChildProcess open(const std::string& scenario,
                                  const std::string& fragment = {},
                                  ChildProcess::Environment environment = {}) const {
    environment.emplace_back("PAGE_DIR", TEAMSIGHT_PAGE_DIR);
    environment.emplace_back("TOKEN", token_);
    return ChildProcess({"/usr/bin/env",
                         "node",
                         test::source_path("tests/browser/page.mjs"),
                         scenario,
                         url_ + fragment,
                         TEAMSIGHT_ARTEFACTS},
                        environment);
  }

  static bool says(const ChildProcess& browser, const std::string& word) {
    return test::wait_until([&]() { return browser.out().find(word) != std::string::npos; },
                            kBound);
  }

  std::optional<ChildProcess> station_;
  std::vector<ChildProcess> fakes_;
  std::string url_;
  std::string token_;
};

TEST_F(Page, ShowsTheTeamMovingOnOneScreen) {
  start_team();

  ChildProcess browser = open("shows");

  EXPECT_EQ(browser.wait_exit(kBound), 0) << browser.err();
  EXPECT_THAT(browser.out(), HasSubstr("moved_from"));
  EXPECT_THAT(browser.out(), HasSubstr("letters_px"));
  for (const char* name : {"page-1280x800.png", "page-1920x1080.png"}) {
    EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(TEAMSIGHT_ARTEFACTS) / name));
  }
}

TEST_F(Page, ExplainsEverythingByKeyboardAlone) {
  start_team();

  ChildProcess browser = open("types");

  EXPECT_EQ(browser.wait_exit(kBound), 0) << browser.err();
  EXPECT_THAT(browser.out(), HasSubstr("reached"));
}

TEST_F(Page, SaysThatAnotherStationIsThereAndWhoseGameItIs) {
  start_team();
  const std::optional<ChildProcess> first = std::exchange(station_, std::nullopt);
  start_station("0");
  const std::string other = url_in(station_->out());
  station_->end();
  ChildProcess browser = open("shares", "#token=" + token_, {{"OTHER", other}});
  ASSERT_TRUE(says(browser, "alone")) << browser.err();

  start_station(port_in(other));
  ASSERT_TRUE(says(browser, "two")) << browser.err();
  station_->end();

  EXPECT_EQ(browser.wait_exit(kBound), 0) << browser.err();
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
  start_station(port_in(url_));

  EXPECT_EQ(browser.wait_exit(kBound), 0) << browser.err();
}

TEST_F(Page, RelocatesARobotByDragAndSaysWhatTheRobotsAnswer) {
  start_team();

  ChildProcess browser = open("relocates", "#token=" + token_);

  EXPECT_EQ(browser.wait_exit(kBound), 0) << browser.err();
  EXPECT_THAT(browser.out(), HasSubstr("relocate robot 2"));
  EXPECT_THAT(browser.out(), HasSubstr("mute robot 5"));
  // Dragged upwards on the screen: it looks to the left, along y.
  EXPECT_THAT(fakes_.at(1).out(), HasSubstr("\"command\": 1, "));
  EXPECT_THAT(fakes_.at(1).out(), HasSubstr("\"theta_rad\": 1.571"));
  // By keys: from the centre mark a metre to the right, then turned to the left.
  EXPECT_THAT(fakes_.at(2).out(),
              HasSubstr("\"command\": 1, \"x_m\": 1.000, \"y_m\": 0.000, \"theta_rad\": 1.571"));
}

TEST_F(Page, HintsAtTheBallByAClickWhichTheLeadingFusionAnswers) {
  start_team();
  ChildProcess browser = open("hints", "#token=" + token_);
  ASSERT_TRUE(says(browser, "ready")) << browser.err();

  fakes_.back().kill(SIGKILL);  // the fusion: nobody is left to answer

  EXPECT_EQ(browser.wait_exit(kBound), 0) << browser.err();
  EXPECT_THAT(browser.out(), HasSubstr("ball hint"));
}

TEST_F(Page, ScrubsBackThroughThePastWhileLive) {
  start_team();

  ChildProcess browser = open("scrubs", "#token=" + token_);

  EXPECT_EQ(browser.wait_exit(kBound), 0) << browser.err();
}

TEST_F(Page, AsksForTheTokenWhenOthersCanReachIt) {
  station_->end();
  start_station("0", {"--bind", "0.0.0.0"});
  read_addresses();
  url_ = "http://127.0.0.1:" + port_in(url_) + "/";
  start_team();

  ChildProcess browser = open("asks");

  EXPECT_EQ(browser.wait_exit(kBound), 0) << browser.err();
}

TEST_F(Page, ReplaysARecording) {
  const test::TempDirectory folder;
  station_->end();
  start_team();
  start_station("0", {"--record", folder.path()});
  ASSERT_TRUE(test::wait_until(
      [&]() {
        const auto file = std::filesystem::directory_iterator(folder.path());
        return file != std::filesystem::directory_iterator() && file->file_size() > 150'000;
      },
      kBound));
  station_->end();
  fakes_.clear();
  const auto file = std::filesystem::directory_iterator(folder.path())->path();
  start_station("0", {"--replay", file});
  read_addresses();

  ChildProcess browser = open("replays");

  EXPECT_EQ(browser.wait_exit(kBound), 0) << browser.err();
}

/// Six seconds of one robot, an opponent and a kick-off, as the league's box records them.
std::string worlds_of_a_game() {
  std::string text = "[\n";
  for (int i = 0; i < 60; ++i) {
    text +=
        "{\"timestamp\": " + std::to_string(1467553851000 + 100 * i) +
        ", \"worldstate\": {\"teamName\": \"Us\", \"robots\": [{\"id\": 2, \"pose\": [1.0, " +
        std::to_string(4.0 - 0.01 * i) +
        ", 0.5]}], \"balls\": [], \"obstacles\": [{\"position\": [1, 1], \"radius\": 0.3}]}},\n";
  }
  return text;
}

TEST_F(Page, ShowsAnImportedGameForWhatItIs) {
  const test::TempDirectory folder;
  const std::string out = folder.path() / "game.mcap";
  ChildProcess import({test::program("teamsight"),
                       "log",
                       "import",
                       "--worlds",
                       folder.write("game.A.msl", worlds_of_a_game()),
                       "--events",
                       folder.write("game.msl",
                                    "1467553851500,00:40(00:00),1st,K,CYAN Kickoff\n"
                                    "1467553852000,00:40(00:01),1st,s,START\n"
                                    "1467553852500,00:40(00:01),1st,S,STOP\n"
                                    "1467553856000,00:40(00:02),1st,s,START\n"),
                       "--out",
                       out});
  ASSERT_EQ(import.wait_exit(kBound), 0) << import.err();
  station_->end();
  start_station("0", {"--replay", out});
  read_addresses();

  ChildProcess browser = open("imports");

  EXPECT_EQ(browser.wait_exit(kBound), 0) << browser.err();
}

TEST_F(Page, LooksCloserAndTakesRefereeCommandsByHand) {
  start_team();

  ChildProcess browser = open("looks", "#token=" + token_);

  EXPECT_EQ(browser.wait_exit(kBound), 0) << browser.err();
}

TEST_F(Page, SaysWhyNothingShows) {
  ChildProcess browser = open("explains");
  ASSERT_TRUE(says(browser, "nothing_heard")) << browser.err();

  fakes_.emplace_back(std::vector<std::string>{BUS_TEST_CHILD,
                                               "other version",
                                               test::source_path("config/dds/loopback.xml"),
                                               std::to_string(test::unique_domain()),
                                               "demo"});

  EXPECT_EQ(browser.wait_exit(kBound), 0) << browser.err();
}

}  // namespace
}  // namespace teamsight
