// tests/client/team_world_test.cpp: what a behaviour program is told of the game.
#include "client/team_world.hpp"

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "bus/clock.hpp"
#include "bus/participant.hpp"
#include "bus/writer.hpp"
#include "process/domains.hpp"
#include "settings/load.hpp"
#include "tests/support/process.hpp"

namespace teamsight {
namespace {

using std::chrono::seconds;

class TeamWorldGame : public ::testing::Test {
 protected:
  TeamWorldGame() {
    options_.team_domain = test::unique_domain();
    team_.emplace(file_, options_);
  }

  /// What a station says, from now on once more.
  void tell(bool running) {
    if (!station_) {
      const auto robot = settings::load_robot(file_);
      station_.emplace(
          bus::Participant::join(process::team_domain(robot.team, {options_.team_domain, {}})));
      games_.emplace(*station_);
    }
    bus::GameState game;
    game.id = {kNobody, 7, ++sequence_};
    game.stamp = stamp_of(bus::host_now());
    game.running = running;
    games_->write(game);
  }

  bool is_told(bool running) {
    return test::wait_until(
        [&] {
          const auto game = team_->game();
          return game && game->running == running;
        },
        seconds(10));
  }

  const std::string file_ = test::source_path("config/robots/robot1.textproto").string();
  TeamWorldOptions options_;
  std::optional<TeamWorld> team_;
  std::optional<bus::Participant> station_;
  std::optional<bus::Writer<bus::GameState>> games_;
  std::uint32_t sequence_{0};
};

TEST_F(TeamWorldGame, IsUnknownBeforeAStationTellsIt) {
  EXPECT_FALSE(team_->game());
}

TEST_F(TeamWorldGame, IsWhatTheStationLastSaid) {
  tell(true);
  EXPECT_TRUE(is_told(true));

  tell(false);
  EXPECT_TRUE(is_told(false));
}

TEST_F(TeamWorldGame, IsUnknownAgainWhenTheStationFallsSilent) {
  tell(true);
  ASSERT_TRUE(is_told(true));

  EXPECT_FALSE(test::wait_until([&] { return !team_->game(); }, seconds(2)))
      << "told once a second, one may be late";
  EXPECT_TRUE(test::wait_until([&] { return !team_->game(); }, seconds(5)));
}

}  // namespace
}  // namespace teamsight
