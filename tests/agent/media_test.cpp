// tests/agent/media_test.cpp: pictures and videos through the plugin.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "agent/media_plugin.hpp"
#include "agent/open_source.hpp"
#include "tests/support/process.hpp"

namespace teamsight::agent {
namespace {

using testing::HasSubstr;

std::string write_picture(const test::TempDirectory& directory, int width, int height) {
  std::string path = (directory.path() / "picture.png").string();
  cv::imwrite(path, cv::Mat(height, width, CV_8UC3, cv::Scalar(10, 20, 30)));
  return path;
}

TEST(MediaPlugin, DecodesAPictureToRowsWithoutGaps) {
  const test::TempDirectory directory;
  const std::string path = write_picture(directory, 6, 4);
  const PictureLayout layout{6, 4, vision::PixelFormat::kBgr};
  Frame frame;

  ASSERT_EQ(open_source(parse_source(path), layout, false)->next(frame, {}), FrameResult::kFrame);

  EXPECT_EQ(frame.format, vision::PixelFormat::kBgr);
  ASSERT_TRUE(vision::is_whole(frame.view()));
  EXPECT_EQ(frame.bytes[3], 10);
  EXPECT_EQ(frame.bytes[4], 20);
  EXPECT_EQ(frame.bytes[5], 30);
}

TEST(MediaPlugin, RefusesAPictureOfAnotherSize) {
  const test::TempDirectory directory;
  const std::string path = write_picture(directory, 6, 4);

  try {
    (void)open_source(parse_source(path), {8, 4, vision::PixelFormat::kBgr}, false);
    FAIL() << "expected a SourceError";
  } catch (const SourceError& error) {
    EXPECT_EQ(std::string(error.what()),
              path + ": found a picture of 6x4, expected 8x4 as in the camera file");
  }
}

TEST(MediaPlugin, RefusesAFileThatIsNoPicture) {
  const test::TempDirectory directory;
  const std::string path = directory.write("fake.png", "no picture").string();

  EXPECT_THROW((void)media_plugin().read_picture(path), SourceError);
}

TEST(MediaPlugin, PlaysAGstreamerPipeline) {
  const MediaRequest request{MediaKind::kGstreamer,
                             "videotestsrc num-buffers=2 ! video/x-raw,format=BGR,width=16,"
                             "height=8 ! appsink",
                             false,
                             16,
                             8,
                             vision::PixelFormat::kBgr};
  const auto source = media_plugin().open(request);
  Frame frame;

  EXPECT_EQ(source->next(frame, HostTime::max()), FrameResult::kFrame);
  EXPECT_EQ(frame.width_px, 16U);
  EXPECT_EQ(source->next(frame, HostTime::max()), FrameResult::kFrame);
  EXPECT_EQ(source->next(frame, HostTime::max()), FrameResult::kGone);
}

TEST(MediaPlugin, SaysWhichDeviceIsMissing) {
  try {
    (void)open_source(parse_source("/dev/video99"), {4, 2, vision::PixelFormat::kYuyv}, false);
    FAIL() << "expected a SourceError";
  } catch (const SourceError& error) {
    EXPECT_THAT(error.what(), HasSubstr("/dev/video99"));
  }
}

}  // namespace
}  // namespace teamsight::agent
