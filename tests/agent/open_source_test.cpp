// tests/agent/open_source_test.cpp: what --source takes, and what it says when it does not.
#include "agent/open_source.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/process.hpp"

namespace teamsight::agent {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr PictureLayout kTiny{4, 2, vision::PixelFormat::kUyvy};

std::string complaint_of(const std::string& spec) {
  try {
    (void)open_source(parse_source(spec), kTiny, false);
  } catch (const SourceError& error) {
    return error.what();
  }
  return "";
}

TEST(ParseSource, TakesThePrefixOrTheEnding) {
  EXPECT_EQ(parse_source("raw:a.bin").kind, SourceKind::kRaw);
  EXPECT_EQ(parse_source("frame.uyvy").kind, SourceKind::kRaw);
  EXPECT_EQ(parse_source("a.png").kind, SourceKind::kPictures);
  EXPECT_EQ(parse_source("match.mp4").kind, SourceKind::kVideoFile);
  EXPECT_EQ(parse_source("gst:videotestsrc ! appsink").what, "videotestsrc ! appsink");
  EXPECT_EQ(parse_source("/dev/video0").kind, SourceKind::kDevice);
  EXPECT_EQ(parse_source("stream:/tmp/fifo").kind, SourceKind::kStream);
}

TEST(ParseSource, SplitsListsOfFiles) {
  EXPECT_THAT(parse_source("raw:a,b").files, ElementsAre("a", "b"));
}

TEST(ParseSource, NamesWhatItCouldHaveBeen) {
  EXPECT_THAT(complaint_of("film:x"), HasSubstr("\"film:x\", expected raw:FILE"));
  EXPECT_THAT(complaint_of("raw:"), HasSubstr("expected raw:FILE"));
}

TEST(OpenSource, RefusesARawDumpOfAnotherSize) {
  const test::TempDirectory directory;
  const std::string path = directory.write("short.raw", "12345").string();

  EXPECT_EQ(complaint_of(path), path + ": found 5 bytes, expected 16 (4x2 as in the camera file)");
}

TEST(OpenSource, RefusesAFileThatIsNotThere) {
  EXPECT_THAT(complaint_of("/nowhere/frame.raw"), HasSubstr("/nowhere/frame.raw: cannot be read"));
  EXPECT_THAT(complaint_of("stream:/nowhere/fifo"), HasSubstr("/nowhere/fifo: cannot be opened"));
}

TEST(OpenSource, GivesEachRawDumpOnceUnlessItLoops) {
  const test::TempDirectory directory;
  const std::string files = directory.write("a.raw", std::string(16, 'a')).string() + "," +
                            directory.write("b.raw", std::string(16, 'b')).string();
  Frame frame;

  const auto once = open_source(parse_source("raw:" + files), kTiny, false);
  EXPECT_EQ(once->next(frame, {}), FrameResult::kFrame);
  EXPECT_EQ(frame.bytes.front(), 'a');
  EXPECT_EQ(once->next(frame, {}), FrameResult::kFrame);
  EXPECT_EQ(frame.bytes.front(), 'b');
  EXPECT_EQ(once->next(frame, {}), FrameResult::kFinished);

  const auto loop = open_source(parse_source("raw:" + files), kTiny, true);
  for (const char expected : {'a', 'b', 'a'}) {
    EXPECT_EQ(loop->next(frame, {}), FrameResult::kFrame);
    EXPECT_EQ(frame.bytes.front(), expected);
  }
}

}  // namespace
}  // namespace teamsight::agent
