// tests/monitor/station_test.cpp: what the operator is told, from samples and times alone.
#include <algorithm>

#include <gmock/gmock.h>

#include "tests/monitor/station_samples.hpp"

namespace teamsight::monitor {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

auto event_with(const std::string& text) {
  return Contains(Field("text", &Event::text, HasSubstr(text)));
}

void hear_hint(Station& station, const bus::ExplainedHint& hint, HostTime at) {
  bus::Explanation explanation;
  explanation.id = {3, 1, 1};
  explanation.hint = hint;
  station.hear(sample_of(explanation, at, 1));
}

TEST(Station, ShowsVirtualSensorsWhileTheyCome) {
  Station station({});
  hear_frame(station, 2, 1, kStart);
  bus::VirtualSensors sensors;
  sensors.id = {2, 1, 1};
  sensors.readings = {{"ball held", 0.8, true}};
  station.hear(sample_of(sensors, kStart, 2));

  EXPECT_EQ(station.update(kStart + seconds(1)).robots.at(0).sensors, sensors);
  EXPECT_FALSE(station.update(kStart + seconds(3)).robots.at(0).sensors.has_value());
}

TEST(Station, NamesARobotThatRunsAnotherVersionOnce) {
  StationParameters parameters;
  parameters.version = "0.1.0";
  Station station(parameters);
  bus::RobotState state;
  state.id = {2, 1, 1};
  state.software_version = "0.0.9";
  station.hear(sample_of(state, kStart, 2));
  state.id.sequence = 2;
  station.hear(sample_of(state, kStart + milliseconds(40), 2));

  const Update update = station.update(kStart + milliseconds(50));

  EXPECT_TRUE(update.robots.at(0).other_version);
  EXPECT_EQ(std::ranges::count_if(update.events,
                                  [](const Event& event) {
                                    return event.text.starts_with(
                                        "Robot 2 runs version 0.0.9, this station 0.1.0");
                                  }),
            1);
}

TEST(Station, TellsOnceThatARobotJoined) {
  Station station({});
  hear_frame(station, 2, 1, kStart);
  const Update first = station.update(kStart);
  hear_frame(station, 2, 2, kStart + milliseconds(40));
  const Update second = station.update(kStart + milliseconds(40));

  EXPECT_THAT(first.events, event_with("Robot 2 joined"));
  EXPECT_THAT(second.events, IsEmpty());
}

TEST(Station, ReportsASilentRobotOnceAndItsReturn) {
  Station station({});
  hear_frame(station, 2, 1, kStart);
  static_cast<void>(station.update(kStart));

  const Update silent = station.update(kStart + milliseconds(700));
  const Update still_silent = station.update(kStart + milliseconds(800));
  hear_frame(station, 2, 2, kStart + milliseconds(900));
  const Update back = station.update(kStart + milliseconds(900));

  EXPECT_THAT(silent.events, event_with("Robot 2 is silent"));
  EXPECT_FALSE(silent.robots.at(0).alive);
  EXPECT_EQ(silent.robots.at(0).age, milliseconds(700));
  EXPECT_THAT(still_silent.events, IsEmpty());
  EXPECT_THAT(back.events, event_with("Robot 2 is back"));
  EXPECT_TRUE(back.robots.at(0).alive);
}

TEST(Station, ShowsALostLeaseAtOnceButLogsItOnlyIfItLasts) {
  Station station({});
  hear_frame(station, 2, 1, kStart);
  static_cast<void>(station.update(kStart));
  station.hear(presence_of(bus::Presence::kSilent, 2, kStart + milliseconds(210)));

  const Update update = station.update(kStart + milliseconds(220));

  EXPECT_FALSE(update.robots.at(0).alive);
  EXPECT_THAT(update.events, IsEmpty());
}

TEST(Station, KnowsARestartFromTwoProcessesUnderOneId) {
  Station restarted({});
  hear_frame(restarted, 2, 7, kStart, 11);
  hear_frame(restarted, 2, 1, kStart + seconds(3), 12);
  Station shared({});
  hear_frame(shared, 2, 7, kStart, 11);
  hear_frame(shared, 2, 1, kStart + milliseconds(20), 12);
  hear_frame(shared, 2, 8, kStart + milliseconds(40), 11);

  const Update after_restart = restarted.update(kStart + seconds(3));
  const Update while_shared = shared.update(kStart + milliseconds(40));
  const Update later = shared.update(kStart + seconds(3));

  EXPECT_THAT(after_restart.events, event_with("started again"));
  EXPECT_FALSE(after_restart.robots.at(0).duplicate);
  EXPECT_THAT(while_shared.events, event_with("two processes speak under this id"));
  EXPECT_TRUE(while_shared.robots.at(0).duplicate);
  EXPECT_FALSE(later.robots.at(0).duplicate);
}

TEST(Station, TellsThatACameraIsLostAndBackButNotOfAHiccup) {
  Station station({});
  const auto hear = [&](bool is_lost, milliseconds after) {
    bus::RobotState state;
    state.id = {3, 1, 1};
    state.camera_lost = is_lost;
    station.hear(sample_of(state, kStart + after, 3));
    return station.update(kStart + after).events;
  };
  hear(true, milliseconds(0));
  EXPECT_THAT(hear(true, milliseconds(500)), IsEmpty());
  EXPECT_THAT(hear(false, milliseconds(550)), IsEmpty());

  hear(true, milliseconds(600));
  const auto lost = hear(true, milliseconds(1300));
  const auto still = hear(true, milliseconds(1400));
  const auto back = hear(false, milliseconds(1500));

  EXPECT_THAT(lost, event_with("Robot 3: its camera is lost"));
  EXPECT_THAT(still, IsEmpty());
  EXPECT_THAT(back, event_with("Robot 3: its camera is back"));
}

TEST(Station, TellsWhichFusionLeadsAndWhoTookOver) {
  Station station({});
  hear_world(station, 3, kStart);
  const Update first = station.update(kStart);
  hear_world(station, 1, kStart + milliseconds(300));
  const Update second = station.update(kStart + milliseconds(310));

  EXPECT_THAT(first.events, event_with("The fusion of robot 3 leads"));
  EXPECT_THAT(second.events, event_with("robot 1 took over from that of robot 3"));
  EXPECT_EQ(second.world_age, milliseconds(10));
}

TEST(Station, TellsTheReasonOfAQuarantine) {
  Station station({});
  hear_frame(station, 1, 1, kStart);
  hear_world(station, 3, kStart, Quarantine::kMirrored);
  const Update taken = station.update(kStart);
  hear_world(station, 3, kStart + milliseconds(40), Quarantine::kNone);
  const Update released = station.update(kStart + milliseconds(40));

  EXPECT_THAT(taken.events, event_with("Robot 1 is in quarantine: it stands on the other half"));
  EXPECT_THAT(released.events, event_with("Robot 1 is trusted again"));
}

TEST(Station, KeepsDiagnosticsOfAgentsWithTheirRobotAndOthersApart) {
  Station station({});
  hear_frame(station, 2, 1, kStart);
  bus::Diagnostics agent;
  agent.process = "agent/2";
  agent.id = {2, 1, 1};
  bus::Diagnostics fusion;
  fusion.process = "fusion/2";
  fusion.id = {2, 5, 1};
  fusion.healthy = false;
  fusion.message = "no clock of robot 1";
  station.hear(sample_of(agent, kStart, 1));
  station.hear(sample_of(fusion, kStart, 2));

  const Update update = station.update(kStart);

  EXPECT_EQ(update.robots.at(0).agent, agent);
  EXPECT_THAT(update.processes, ElementsAre(fusion));
  EXPECT_THAT(update.events, event_with("fusion/2: no clock of robot 1"));
}

TEST(Station, SaysOnceThatAnotherStationIsThere) {
  StationParameters parameters;
  parameters.where = "domain 7";
  Station station(parameters);
  bus::Diagnostics other;
  other.process = "monitor";
  for (int second = 0; second < 4; ++second) {
    station.hear(sample_of(other, kStart + seconds(second), 1));
  }

  EXPECT_THAT(station.update(kStart + seconds(4)).events,
              ElementsAre(::testing::Field(
                  &Event::text, ::testing::HasSubstr("Another coach station is on domain 7"))));

  station.hear(sample_of(other, kStart + seconds(60), 1));
  EXPECT_EQ(station.update(kStart + seconds(60)).events.size(), 1U) << "it was gone";
}

TEST(Station, TakesAStationInARecordingForNoOther) {
  StationParameters parameters;
  parameters.is_recording = true;
  Station station(parameters);
  bus::Diagnostics recorded;
  recorded.process = "monitor";
  station.hear(sample_of(recorded, kStart, 1));

  const Update update = station.update(kStart);

  EXPECT_EQ(update.other_stations, 0U);
  EXPECT_THAT(update.events, ElementsAre());
}

TEST(Station, ForgetsTheTruthOfAMatchThatEnded) {
  Station station({});
  bus::Truth truth;
  truth.id = {kNobody, 1, 1};
  station.hear(sample_of(truth, kStart, 1));

  EXPECT_EQ(station.update(kStart + milliseconds(100)).truth, truth);
  EXPECT_FALSE(station.update(kStart + seconds(2)).truth.has_value());
}

TEST(Station, DoesNotGrowWithoutBoundFromManyProcessNames) {
  Station station({});
  for (int i = 0; i < 1000; ++i) {
    bus::Diagnostics diagnostics;
    diagnostics.process = "stranger/" + std::to_string(i);
    diagnostics.healthy = false;
    station.hear(sample_of(diagnostics, kStart, 1));
  }

  const Update update = station.update(kStart);

  EXPECT_LE(update.processes.size(), 64U);
  EXPECT_LE(update.events.size(), 256U);
}

TEST(Station, SaysWhichBallTheHintMeansAndWhenItIsOver) {
  Station station{{}};
  hear_hint(station, {7, 0, seconds(8)}, kStart);
  EXPECT_THAT(station.update(kStart).events, IsEmpty()) << "no ball is seen there yet";

  hear_hint(station, {7, 488, seconds(7)}, kStart + seconds(1));
  const Update told = station.update(kStart + seconds(2));
  hear_hint(station, {7, 488, Duration{0}}, kStart + seconds(8));
  const Update after = station.update(kStart + seconds(9));

  ASSERT_THAT(told.events, SizeIs(1));
  EXPECT_THAT(told.events[0].text, HasSubstr("hint counts"));
  EXPECT_EQ(told.hint, (bus::ExplainedHint{7, 488, seconds(6)}));
  ASSERT_THAT(after.events, SizeIs(1));
  EXPECT_EQ(after.events[0].text, "The ball hint is over");
  EXPECT_EQ(after.hint, std::nullopt);
}

TEST(Station, SaysThatAHintFoundNoBall) {
  Station station{{}};
  hear_hint(station, {7, 0, seconds(8)}, kStart);
  hear_hint(station, {7, 0, Duration{0}}, kStart + seconds(8));

  const Update update = station.update(kStart + seconds(8));

  ASSERT_THAT(update.events, SizeIs(1));
  EXPECT_THAT(update.events[0].text, HasSubstr("no robot saw a ball there"));
}

}  // namespace
}  // namespace teamsight::monitor
