// tests/monitor/referee_system_test.cpp: the station between a referee box and the bus.
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "bus/clock.hpp"
#include "bus/participant.hpp"
#include "bus/reader.hpp"
#include "tests/support/process.hpp"

namespace teamsight {
namespace {

using std::chrono::milliseconds;
using test::ChildProcess;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr milliseconds kBound{30'000};

class RefereeSystem : public ::testing::Test {
 protected:
  void start_box(const std::string& script) {
    std::vector<std::string> argv{"/usr/bin/env",
                                  "node",
                                  test::source_path("tests/monitor/fake_referee_box.mjs"),
                                  "0",
                                  folder_.write("script", script)};
    const char* data = std::getenv("TEAMSIGHT_DATA");
    const auto schema =
        std::filesystem::path(data == nullptr ? "" : data) / "refbox2016/MSLWMD-schema.json";
    if (std::filesystem::exists(schema)) argv.push_back(schema);
    box_.emplace(argv);
    ASSERT_TRUE(test::wait_until([&]() { return says(*box_, "port"); }, kBound)) << box_->err();
    const std::string out = box_->out();
    const auto begin = out.find(':') + 1;
    port_ = out.substr(begin, out.find('}') - begin);
  }

  [[nodiscard]] static std::vector<std::string> station_alone() {
    return {test::program("teamsight-monitor"),
            "--team",
            test::source_path("config/teams/demo.textproto"),
            "--team-domain",
            std::to_string(test::unique_domain()),
            "--port",
            "0"};
  }

  void start_station() {
    std::vector<std::string> argv = station_alone();
    argv.insert(argv.end(), {"--box", "127.0.0.1:" + port_});
    station_.emplace(argv);
    fusion_.emplace(std::vector<std::string>{TEAMSIGHT_FAKE_TEAM,
                                             "fusion",
                                             "3",
                                             std::to_string(test::unique_domain()),
                                             test::source_path("config/dds/loopback.xml"),
                                             "demo"});
  }

  static bool says(const ChildProcess& process, const std::string& word) {
    return process.out().find(word) != std::string::npos;
  }

  /// The game as a robot hears it; keeps the newest.
  bool hear(const std::function<bool(const bus::GameState&)>& is_wanted) {
    if (!reader_) {
      participant_.emplace(bus::Participant::join(
          {test::unique_domain(), test::source_path("config/dds/loopback.xml"), "demo"}));
      reader_.emplace(*participant_);
    }
    return test::wait_until(
        [&]() {
          bool found = false;
          reader_->take(bus::host_now(), [&](const bus::Sample<bus::GameState>& sample) {
            if (sample.message) found = found || is_wanted(*sample.message);
          });
          return found;
        },
        kBound);
  }

  test::TempDirectory folder_;
  std::string port_;
  std::optional<ChildProcess> box_;
  std::optional<ChildProcess> station_;
  std::optional<ChildProcess> fusion_;
  std::optional<bus::Participant> participant_;
  std::optional<bus::Reader<bus::GameState>> reader_;
};

TEST_F(RefereeSystem, TellsTheRobotsTheGameAndTheBoxOurWorldTenTimesASecond) {
  start_box("0.2 FIRST_HALF\n0.3 GOAL theirs\n0.4 KICKOFF ours\n1.5 raw {\"command\":\n4 START\n");
  start_station();

  EXPECT_TRUE(hear([](const bus::GameState& game) {
    return game.piece == bus::SetPiece::kKickoff && game.piece_is_ours && game.box_connected &&
           game.goals_opponent == 1 && game.phase == bus::GamePhase::kFirstHalf;
  }));
  EXPECT_TRUE(hear([](const bus::GameState& game) { return game.running; }))
      << "a message that is none must not end the conversation";
  ASSERT_TRUE(test::wait_until([&]() { return says(*box_, "\"worldstate\""); }, kBound));
  const auto fast = [&]() {
    for (int hz = 10; hz <= 25; ++hz) {
      if (says(*box_, "\"rate_hz\":" + std::to_string(hz))) return true;
    }
    return false;
  };
  EXPECT_TRUE(test::wait_until(fast, kBound)) << box_->out();
  EXPECT_THAT(box_->out(), HasSubstr("\"fault\":null"));
  EXPECT_THAT(box_->out(), Not(HasSubstr("\"fault\":\"")));
}

TEST_F(RefereeSystem, ComesBackToABoxThatClosedAndBearsOneThatDoesNotRead) {
  start_box("0.5 deaf\n2 drop\n");
  start_station();

  ASSERT_TRUE(test::wait_until([&]() { return says(*box_, "\"connected\":false"); }, kBound));
  const auto again = [&]() {
    const std::string out = box_->out();
    return out.find("\"connected\":true", out.find("\"connected\":false")) != std::string::npos;
  };
  EXPECT_TRUE(test::wait_until(again, kBound));
  EXPECT_TRUE(hear([](const bus::GameState& game) { return game.box_connected; }));
}

TEST_F(RefereeSystem, ASecondStationDoesNotStopTheGame) {
  start_box("0.1 FIRST_HALF\n0.2 START\n");
  start_station();
  ASSERT_TRUE(hear([](const bus::GameState& game) { return game.running; }));

  const ChildProcess second(station_alone());
  ASSERT_TRUE(test::wait_until([&]() { return says(second, "url"); }, kBound)) << second.err();
  int told = 0;
  int stopped = 0;
  const bool is_told = hear([&](const bus::GameState& game) {
    ++told;
    stopped += game.running ? 0 : 1;
    return told >= 4;  // one a second: the second one's turn came as well
  });

  EXPECT_TRUE(is_told);
  EXPECT_EQ(stopped, 0);
}

}  // namespace
}  // namespace teamsight
