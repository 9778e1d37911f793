// tests/tools/fuse_command_test.cpp: `teamsight fuse` over a made-up recording.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "bus/messages.hpp"
#include "recording/from_proto.hpp"
#include "recording/mcap_reader.hpp"
#include "recording/output_file.hpp"
#include "recording/topic_channel.hpp"
#include "tests/fusion/scenario.hpp"
#include "tests/support/process.hpp"

namespace teamsight {
namespace {

using fusion::test::at_second;
using fusion::test::Eye;
using test::ChildProcess;
using ::testing::HasSubstr;

constexpr std::chrono::milliseconds kBound{30'000};
constexpr std::int64_t kLogMinusHost = 1'000'000'000;
const Point<Field> kBall{1.0, 0.5};

bus::Sightings sightings_of(const fusion::Observation& seen) {
  bus::Sightings sightings;
  sightings.id = seen.id;
  sightings.exposure = stamp_of(seen.exposure);
  sightings.published = stamp_of(seen.exposure);
  sightings.posture = seen.posture;
  sightings.balls = seen.balls;
  sightings.obstacles = seen.obstacles;
  return sightings;
}

/// Two robots that watch a ball for two seconds.
void write_recording(const std::filesystem::path& path) {
  recording::OutputFile file(path);
  recording::McapWriter writer([&](std::string_view bytes) { return file.write(bytes); }, "test");
  writer.add_metadata("teamsight.recording",
                      {{"log_minus_host_ns", std::to_string(kLogMinusHost)}});
  const auto channel = writer.add_channel(recording::channel_of<bus::Sightings>());
  Eye left(1, 11);
  Eye right(4, 44);
  std::uint32_t sequence = 0;
  for (int i = 0; i < 100; ++i) {
    const HostTime exposure = at_second(0.02 * i);
    Eye& eye = i % 2 == 0 ? left : right;
    eye.look(i % 2 == 0 ? Pose<Field, Robot>(-2.0, 0.0, 0.0) : Pose<Field, Robot>(3.0, 1.0, 2.0),
             exposure);
    eye.see_ball(kBall);
    const bus::Sightings seen = sightings_of(eye.frame());
    const std::int64_t host_ns =
        (exposure + std::chrono::milliseconds(5)).time_since_epoch().count();
    writer.write(
        channel, {host_ns + kLogMinusHost, host_ns, ++sequence}, recording::payload_of(seen));
  }
  writer.finish();
  ASSERT_EQ(file.problem(), "");
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class FuseCommand : public ::testing::Test {
 protected:
  void SetUp() override { write_recording(recording_); }

  [[nodiscard]] ChildProcess fuse(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(),
                     {test::program("teamsight"),
                      "fuse",
                      recording_,
                      "--team",
                      test::source_path("config/teams/demo.textproto")});
    return ChildProcess(arguments);
  }

  test::TempDirectory folder_;
  std::filesystem::path recording_{std::filesystem::path(folder_.path()) / "game.mcap"};
};

TEST_F(FuseCommand, MakesTheSameWorldsOfARecordingToTheLastBit) {
  const std::filesystem::path first = recording_.parent_path() / "first.mcap";
  const std::filesystem::path second = recording_.parent_path() / "second.mcap";

  ChildProcess once = fuse({"--out", first});
  ASSERT_EQ(once.wait_exit(kBound), 0) << once.err();
  ChildProcess again = fuse({"--out", second});
  ASSERT_EQ(again.wait_exit(kBound), 0) << again.err();

  const auto facts = nlohmann::json::parse(once.out());
  EXPECT_EQ(facts["sightings"], 100);
  EXPECT_EQ(facts["accepted"], 100);
  EXPECT_GT(facts["worlds"], 55);
  EXPECT_GT(facts["with_ball"], 50);
  EXPECT_EQ(bytes_of(first), bytes_of(second));
  WorldModel last;
  recording::McapReader(first).for_each({}, [&](const recording::Message& message) {
    last = recording::from_payload<WorldModel>(message.payload).value();
    return true;
  });
  ASSERT_EQ(last.balls.size(), 1U);
  EXPECT_NEAR(last.balls[0].p_FB.x, kBall.x, 0.05);
  EXPECT_NEAR(last.balls[0].p_FB.y, kBall.y, 0.05);
  EXPECT_EQ(last.balls[0].supporters, robot_bit(1) | robot_bit(4));
}

TEST_F(FuseCommand, LeavesOneRobotOut) {
  ChildProcess without = fuse({"--without", "4"});
  ASSERT_EQ(without.wait_exit(kBound), 0) << without.err();

  EXPECT_EQ(nlohmann::json::parse(without.out())["sightings"], 50);
}

TEST_F(FuseCommand, SaysWhatIsNoRecordingAndTouchesNoFileThatExists) {
  ChildProcess taken = fuse({"--out", recording_});
  EXPECT_NE(taken.wait_exit(kBound), 0);
  EXPECT_THAT(taken.err(), HasSubstr("game.mcap"));
  EXPECT_GT(std::filesystem::file_size(recording_), 1000U);
}

}  // namespace
}  // namespace teamsight
