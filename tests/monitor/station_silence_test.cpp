// tests/monitor/station_silence_test.cpp: why nothing shows.
#include <gmock/gmock.h>

#include "tests/monitor/station_samples.hpp"

namespace teamsight::monitor {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(StationSilence, SaysThatNothingWasHeardAndWhere) {
  StationParameters parameters;
  parameters.where = "domain 7";
  Station station(parameters);

  const Update update = station.update(kStart);

  EXPECT_THAT(update.silence, HasSubstr("Nothing heard yet on domain 7"));
  EXPECT_THAT(update.robots, IsEmpty());
  EXPECT_FALSE(update.world.has_value());
}

TEST(StationSilence, SaysThatAnotherVersionOfTheTopicsIsSpoken) {
  StationParameters parameters;
  parameters.where = "domain 7";
  Station station(parameters);
  station.note_versions({"v2"}, kStart);
  station.note_versions({"v2"}, kStart + seconds(1));

  const Update update = station.update(kStart + seconds(1));
  station.note_versions({}, kStart + seconds(2));

  EXPECT_THAT(update.silence, HasSubstr("On domain 7 somebody speaks v2 of the topics"));
  EXPECT_EQ(update.events.size(), 1U);
  EXPECT_THAT(station.update(kStart + seconds(2)).silence, HasSubstr("Nothing heard yet"));
}

TEST(StationSilence, SaysWhichOtherDomainsThereAreWhileNothingIsHeard) {
  StationParameters parameters;
  parameters.where = "domain 7";
  Station station(parameters);
  station.note_domains("domain 20 (blue)");

  EXPECT_THAT(station.update(kStart).silence, EndsWith(". This network carries domain 20 (blue)"));
  station.note_domains("");
  EXPECT_THAT(station.update(kStart).silence, EndsWith("with this version?"));
}

TEST(StationSilence, NamesTheRobotsThatSpeakWithoutAFusion) {
  Station station({});
  hear_frame(station, 1, 1, kStart);
  hear_frame(station, 3, 1, kStart);

  const Update update = station.update(kStart + milliseconds(10));

  EXPECT_THAT(update.silence, HasSubstr("Robots 1, 3 heard, but no fusion"));
}

TEST(StationSilence, IsNoneWhileTheWorldIsFresh) {
  Station station({});
  hear_frame(station, 1, 1, kStart);
  hear_world(station, 1, kStart);

  EXPECT_THAT(station.update(kStart + milliseconds(900)).silence, IsEmpty());
  EXPECT_THAT(station.update(kStart + milliseconds(1100)).silence, Not(IsEmpty()));
}

TEST(StationSilence, SaysThatEverySampleWasDropped) {
  Station station({});
  bus::ReadCounters counters;
  counters.rejected[static_cast<std::size_t>(bus::Reject::kBadCovariance)] = 4;
  station.count("RobotState", counters);

  const Update update = station.update(kStart);

  EXPECT_THAT(update.silence, HasSubstr("RobotState.bad_covariance"));
  EXPECT_THAT(update.rejected, ElementsAre(bus::Counter{"RobotState.bad_covariance", 4}));
}

}  // namespace
}  // namespace teamsight::monitor
