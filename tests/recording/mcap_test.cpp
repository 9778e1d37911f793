// tests/recording/mcap_test.cpp: what was written can be read, whatever happened to the file.
#include <algorithm>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "recording/mcap_format.hpp"
#include "recording/mcap_reader.hpp"
#include "recording/mcap_writer.hpp"
#include "tests/support/process.hpp"

namespace teamsight::recording {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::SizeIs;

const Channel kBall{"ball", "protobuf", {"x.Ball", "protobuf", "schema bytes"}};
const Channel kRobot{"robot", "protobuf", {"x.Robot", "protobuf", "others"}};

/// A file in memory with `count` messages 10 ns apart.
std::string some_file(int count, bool is_finished = true, int chunk = 100) {
  std::string bytes;
  McapWriter writer([&](std::string_view part) { return bytes.append(part), true; }, "test");
  writer.add_metadata("facts", {{"team", "demo"}});
  const auto ball = writer.add_channel(kBall);
  const auto robot = writer.add_channel(kRobot);
  for (int i = 0; i < count; ++i) {
    writer.write(i % 2 == 0 ? ball : robot, {1000 + 10 * i, 500 + i, 7}, std::to_string(i));
    if (i % chunk == chunk - 1) writer.flush();
  }
  if (is_finished) writer.finish();
  return bytes;
}

class Mcap : public ::testing::Test {
 protected:
  [[nodiscard]] McapReader open(const std::string& bytes) const {
    return McapReader(folder_.write("file.mcap", bytes));
  }

  static std::vector<std::string> payloads(const McapReader& reader, const TimeSpan& span = {}) {
    std::vector<std::string> found;
    reader.for_each(span, [&](const Message& message) {
      found.emplace_back(message.payload);
      return true;
    });
    return found;
  }

  test::TempDirectory folder_;
};

TEST_F(Mcap, GivesBackEveryMessageWithItsChannelAndStamps) {
  const McapReader reader = open(some_file(250));
  std::vector<MessageStamp> stamps;
  std::vector<Channel> channels;

  reader.for_each({}, [&](const Message& message) {
    stamps.push_back(message.stamp);
    channels.push_back(*message.channel);
    return true;
  });

  ASSERT_THAT(stamps, SizeIs(250));
  EXPECT_EQ(stamps[3], (MessageStamp{1030, 503, 7}));
  EXPECT_EQ(channels[0], kBall);
  EXPECT_EQ(channels[249], kRobot);
  EXPECT_EQ(payloads(reader)[249], "249");
}

TEST_F(Mcap, TellsWhatAFileHolds) {
  const Contents contents = open(some_file(250)).contents();

  EXPECT_EQ(contents.messages, 250U);
  EXPECT_EQ(contents.span, (TimeSpan{1000, 3490}));
  EXPECT_EQ(contents.library, "test");
  EXPECT_EQ(contents.metadata.at("facts").at("team"), "demo");
  EXPECT_THAT(contents.message_counts, ElementsAre(std::pair(0, 125U), std::pair(1, 125U)));
  EXPECT_EQ(contents.damage, "");
}

TEST_F(Mcap, ReadsAWindowWithBothEnds) {
  EXPECT_THAT(payloads(open(some_file(250)), {1990, 2010}), ElementsAre("99", "100", "101"));
}

TEST_F(Mcap, StopsWhenTheReaderHasEnough) {
  int seen = 0;

  open(some_file(250)).for_each({}, [&](const Message& /*message*/) { return ++seen < 5; });

  EXPECT_EQ(seen, 5);
}

TEST_F(Mcap, PutsChunksThatLieOverOneAnotherInOrder) {
  std::string bytes;
  McapWriter writer([&](std::string_view part) { return bytes.append(part), true; }, "test");
  const auto ball = writer.add_channel(kBall);
  for (const int time : {10, 40, 20}) writer.write(ball, {time, 0, 0}, std::to_string(time));
  writer.flush();
  for (const int time : {30, 15, 40}) writer.write(ball, {time, 1, 0}, std::to_string(time) + "b");
  writer.finish();

  EXPECT_THAT(payloads(open(bytes)), ElementsAre("10", "15b", "20", "30b", "40", "40b"));
}

TEST_F(Mcap, KeepsEveryWholeChunkOfAFileThatWasCutOffAnywhere) {
  const std::string whole = some_file(30, false, 10);
  std::vector<std::size_t> found;

  for (std::size_t size = 8; size <= whole.size(); size += 11) {
    const McapReader reader = open(whole.substr(0, size));
    EXPECT_THAT(reader.contents().damage, HasSubstr("the file ends"));
    const std::size_t messages = payloads(reader).size();
    EXPECT_EQ(messages, reader.contents().messages);
    EXPECT_EQ(messages % 10, 0U);
    found.push_back(messages);
  }

  EXPECT_TRUE(std::ranges::is_sorted(found));
  EXPECT_EQ(found.back(), 30U);
}

TEST_F(Mcap, NoticesAFlippedBitAnywhereInAChunk) {
  const std::string whole = some_file(100);
  const std::size_t begin = whole.find("zstd");
  const std::size_t end = whole.find("\x07", whole.size() / 2);  // within chunk or index

  for (std::size_t at = begin + 12; at < std::min(end, begin + 200); at += 5) {
    std::string broken = whole;
    broken[at] = static_cast<char>(broken[at] ^ 0x10);
    EXPECT_THROW(static_cast<void>(payloads(open(broken))), RecordingError) << at;
  }
}

TEST_F(Mcap, SearchesAFileWhoseSummaryIsBroken) {
  std::string broken = some_file(200);
  broken[broken.size() - 60] = static_cast<char>(broken[broken.size() - 60] ^ 1);

  const McapReader reader = open(broken);

  EXPECT_EQ(reader.contents().damage, "the summary is broken");
  EXPECT_THAT(payloads(reader), SizeIs(200));
}

TEST_F(Mcap, RefusesWhatIsNoMcapFile) {
  EXPECT_THROW(open(""), RecordingError);
  EXPECT_THROW(open("hello, this is text"), RecordingError);
  EXPECT_THROW(McapReader("/does/not/exist.mcap"), RecordingError);
}

TEST_F(Mcap, SurvivesBytesThatWereChangedAnywhere) {
  const std::string whole = some_file(120, true, 30);
  std::mt19937 random(20260725);  // NOLINT: a fixed seed is wanted
  std::uniform_int_distribution<std::size_t> place(8, whole.size() - 1);
  std::uniform_int_distribution<int> byte(0, 255);

  for (int round = 0; round < 100; ++round) {
    std::string broken = whole;
    for (int k = 0; k < 4; ++k) broken[place(random)] = static_cast<char>(byte(random));
    try {
      EXPECT_LE(payloads(open(broken)).size(), 120U);
    } catch (const RecordingError& error) {
      EXPECT_THAT(error.what(), HasSubstr("file.mcap"));
    }
  }
}

TEST_F(Mcap, ReportsASinkThatTakesNoMore) {
  std::size_t room = 400;
  McapWriter writer(
      [&](std::string_view part) {
        const bool fits = part.size() <= room;
        if (fits) room -= part.size();
        return fits;
      },
      "test");
  const auto ball = writer.add_channel(kBall);

  writer.write(ball, {}, "small");
  writer.flush();
  EXPECT_TRUE(writer.is_good());
  for (int i = 0; i < 200; ++i) writer.write(ball, {i, i, 0}, std::to_string(i * 7919));
  writer.flush();

  EXPECT_FALSE(writer.is_good());
}

}  // namespace
}  // namespace teamsight::recording
