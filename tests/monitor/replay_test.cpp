// tests/monitor/replay_test.cpp: a recording as the page gets it.
#include "monitor/replay.hpp"

#include <chrono>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "monitor.pb.h"
#include "recording/mcap_writer.hpp"
#include "recording/topic_channel.hpp"
#include "tests/bus/samples.hpp"
#include "tests/support/process.hpp"

namespace teamsight::monitor {
namespace {

using ::testing::ElementsAre;

constexpr std::int64_t kDate = 1'467'553'851'000'000'000;  // ns; what makes a date of host time
constexpr std::int64_t kSecond = 1'000'000'000;

/// The updates of a replay's body.
std::vector<v1::MonitorUpdate> updates_in(const std::string& body) {
  std::vector<v1::MonitorUpdate> updates;
  for (std::size_t at = 0; at < body.size();) {
    std::size_t size = 0;
    for (unsigned i = 0; i < 4; ++i)
      size |= std::size_t{static_cast<std::uint8_t>(body[at + i])} << 8 * i;
    EXPECT_TRUE(updates.emplace_back().ParseFromString(body.substr(at + 4, size)));
    at += 4 + size;
  }
  return updates;
}

/// A file of game states, a second apart.
std::filesystem::path record(const test::TempDirectory& folder,
                             const std::vector<bus::GameState>& games) {
  const std::filesystem::path path = folder.path() / "game.mcap";
  std::ofstream file(path, std::ios::binary);
  recording::McapWriter writer([&](std::string_view bytes) { return bool(file << bytes); }, "test");
  const auto channel = writer.add_channel(recording::channel_of<bus::GameState>());
  std::int64_t at = kDate + kSecond;
  for (bus::GameState game : games) {
    const bus::GameState full = bus::testing::full<bus::GameState>();
    game.id = full.id;
    game.stamp = full.stamp;
    writer.write(channel, {at, at, 0}, recording::payload_of(game));
    at += kSecond;
  }
  writer.add_metadata("teamsight.recording",
                      {{"team", "Us"}, {"log_minus_host_ns", std::to_string(kDate)}});
  writer.finish();
  return path;
}

TEST(Replay, TellsTheGameFromItsStatesWhereTheStationsOwnEventsAreMissing) {
  const test::TempDirectory folder;
  bus::GameState game;
  game.phase = bus::GamePhase::kFirstHalf;
  std::vector<bus::GameState> games{game};
  game.piece = bus::SetPiece::kThrowin;
  game.piece_is_ours = true;
  games.push_back(game);
  game.piece = bus::SetPiece::kNone;
  game.running = true;
  games.push_back(game);
  games.push_back(game);
  game.goals_opponent = 1;
  games.push_back(game);

  const Replay replay = load_replay(record(folder, games), {});

  std::vector<std::string> events;
  for (const v1::MonitorUpdate& update : updates_in(replay.body)) {
    for (const v1::MonitorEvent& event : update.events()) events.push_back(event.text());
  }
  EXPECT_THAT(events,
              ElementsAre("Referee: first half",
                          "Referee: our throw-in",
                          "Referee: START",
                          "Referee: goal for them"));
  const v1::MonitorUpdate last = updates_in(replay.body).back();
  EXPECT_EQ(last.referee().last_command(), "goal for them");
  EXPECT_EQ(replay.team, "Us");
  EXPECT_EQ(replay.date_minus_stamp.count(), kDate);
  EXPECT_EQ(replay.skipped, 0U);
}

TEST(Replay, GoesInStepsOfTheRecordingsOwnTime) {
  const test::TempDirectory folder;

  const Replay replay = load_replay(record(folder, std::vector<bus::GameState>(4)), {});

  const std::vector<v1::MonitorUpdate> updates = updates_in(replay.body);
  EXPECT_EQ(updates.size(), replay.updates);
  EXPECT_NEAR(static_cast<double>(updates.size()), 3.0 / to_seconds(kReplayStep), 2.0);
  EXPECT_EQ(updates[1].stamp_ns() - updates[0].stamp_ns(), kReplayStep.count());
}

}  // namespace
}  // namespace teamsight::monitor
