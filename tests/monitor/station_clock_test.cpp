// tests/monitor/station_clock_test.cpp: how old what robots say is, whatever their clocks show.
#include <gtest/gtest.h>

#include "tests/monitor/station_samples.hpp"

namespace teamsight::monitor {
namespace {

// Robot 4's computer was switched on three days before the station's.
constexpr Duration kAhead = std::chrono::hours(72);

PeerTime there(HostTime here) {
  return stamp_of(here + kAhead);
}

// The station asks, the robot answers 1 ms later after a way of `way` each.
void ask(Station& station, HostTime at, Duration way = milliseconds(2)) {
  const bus::ClockProbe probe = station.next_probe(at);
  bus::ClockEcho echo;
  echo.id = {4, 9, probe.id.sequence};
  echo.sent = there(at + way + milliseconds(1));
  echo.replies.push_back({probe.id, there(at + way)});
  station.hear(sample_of(echo, at + 2 * way + milliseconds(1), 4));
}

void hear_frame_there(Station& station, std::uint32_t sequence, HostTime at) {
  bus::RobotState state;
  state.id = {4, 1, sequence};
  state.exposure = there(at - milliseconds(30));
  state.published = there(at - milliseconds(10));
  station.hear(sample_of(state, at, 4));
  bus::Sightings sightings;
  sightings.id = state.id;
  sightings.exposure = state.exposure;
  sightings.published = state.published;
  station.hear(sample_of(sightings, at, 4));
}

TEST(StationClocks, LetAnotherComputersLatencyBeTold) {
  Station station({});
  ask(station, kStart);
  hear_frame_there(station, 1, kStart + milliseconds(50));

  const Update update = station.update(kStart + milliseconds(60));

  const auto latency = update.robots.at(0).link.latency_p50;
  ASSERT_TRUE(latency.has_value());
  EXPECT_NEAR(to_seconds(*latency), 0.030, 1e-5);  // and a drift of 50 ms
}

TEST(StationClocks, SayNoLatencyOfAClockThatNobodyMeasured) {
  Station station({});
  hear_frame_there(station, 1, kStart);

  EXPECT_FALSE(station.update(kStart).robots.at(0).link.latency_p50.has_value());
}

TEST(StationClocks, TakeAClockThatCanBeThisComputersToBeSo) {
  Station station({});
  hear_frame(station, 2, 1, kStart);

  EXPECT_EQ(station.update(kStart).robots.at(0).link.latency_p50, milliseconds(30));
}

TEST(StationClocks, SayNoLatencyOfAStampThatTheMeasuredClockContradicts) {
  Station station({});
  ask(station, kStart);
  bus::Sightings sightings;
  sightings.id = {4, 1, 1};
  sightings.exposure = there(kStart + seconds(1));
  sightings.published = sightings.exposure;
  hear_frame_there(station, 1, kStart);
  sightings.id.sequence = 2;
  station.hear(sample_of(sightings, kStart + milliseconds(40), 4));

  EXPECT_FALSE(station.update(kStart + milliseconds(50)).robots.at(0).link.latency_p50.has_value());
}

TEST(StationClocks, GiveTheWorldItsTrueAge) {
  Station station({});
  ask(station, kStart);
  WorldModel world;
  world.id = {4, 9, 1};
  world.stamp = there(kStart + milliseconds(10));
  station.hear(sample_of(world, kStart + milliseconds(15), 1));

  const Duration age = station.world_information_age(kStart + milliseconds(40));

  EXPECT_NEAR(to_seconds(age), 0.030, 1e-5);
}

TEST(StationClocks, LeaveAnswersToAnotherStationAlone) {
  StationParameters parameters;
  parameters.boot = 5;
  Station station(parameters);
  static_cast<void>(station.next_probe(kStart));
  bus::ClockEcho echo;
  echo.id = {4, 9, 1};
  echo.sent = there(kStart);
  echo.replies.push_back({{kNobody, 6, 1}, there(kStart)});
  station.hear(sample_of(echo, kStart + milliseconds(1), 4));
  hear_frame_there(station, 1, kStart + milliseconds(50));

  EXPECT_FALSE(station.update(kStart + milliseconds(60)).robots.at(0).link.latency_p50.has_value());
}

}  // namespace
}  // namespace teamsight::monitor
