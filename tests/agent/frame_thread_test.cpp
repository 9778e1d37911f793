// tests/agent/frame_thread_test.cpp: a source that comes and goes, a reader that is slow.
#include "agent/frame_thread.hpp"

#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include <gtest/gtest.h>
#include <poll.h>

#include "agent/open_source.hpp"
#include "bus/clock.hpp"
#include "sim/frame_pipe.hpp"
#include "tests/support/process.hpp"

namespace teamsight::agent {
namespace {

using namespace std::chrono_literals;
using test::wait_until;

constexpr PictureLayout kTiny{4, 2, vision::PixelFormat::kYuyv};

Frame tiny_frame(std::uint8_t fill) {
  return {std::vector<std::uint8_t>(16, fill), 4, 2, vision::PixelFormat::kYuyv};
}

bool is_readable(int descriptor) {
  pollfd waiting{descriptor, POLLIN, 0};
  return ::poll(&waiting, 1, 0) == 1;
}

// Takes frames until there is one with these pixels.
bool gets(FrameThread& frames, std::uint8_t fill) {
  return wait_until(
      [&] {
        const Frame* frame = frames.take();
        return frame != nullptr && frame->bytes == std::vector<std::uint8_t>(16, fill);
      },
      10s);
}

void send(sim::FramePipe& pipe, std::uint64_t sequence, std::uint8_t fill) {
  const StreamHeader header{4, 2, vision::PixelFormat::kYuyv, bus::host_now(), sequence};
  ASSERT_TRUE(wait_until([&] { return pipe.is_free(); }, 10s));
  pipe.send(header, std::vector<std::uint8_t>(16, fill));
}

TEST(FrameThread, GivesFilesOneByOneWhenNobodyNamesARate) {
  FrameThread frames(nullptr, make_still_frames({tiny_frame(1), tiny_frame(2)}, false), 0.0);

  EXPECT_TRUE(gets(frames, 1));
  EXPECT_TRUE(gets(frames, 2));
  EXPECT_TRUE(wait_until([&] { return frames.report().is_finished; }, 10s));
  EXPECT_EQ(frames.report().overwritten, 0U);
}

TEST(FrameThread, IsReadableAsLongAsThereIsAFrame) {
  FrameThread frames(nullptr, make_still_frames({tiny_frame(1)}, false), 0.0);

  ASSERT_TRUE(wait_until([&] { return is_readable(frames.event_fd()); }, 10s));
  EXPECT_NE(frames.take(), nullptr);
  EXPECT_FALSE(is_readable(frames.event_fd()));
  EXPECT_EQ(frames.take(), nullptr);
}

TEST(FrameThread, KeepsOnlyTheNewestForAReaderThatIsSlow) {
  FrameThread frames(nullptr, make_still_frames({tiny_frame(1)}, true), 1000.0);
  ASSERT_TRUE(wait_until([&] { return frames.report().frames >= 20; }, 10s));

  const Frame* frame = frames.take();

  ASSERT_NE(frame, nullptr);
  EXPECT_GE(frame->sequence, 20U);
  EXPECT_GE(frames.report().overwritten, 19U);
}

TEST(FrameThread, TakesUpAStreamWhoseWriterDiedAndCameBack) {
  const test::TempDirectory directory;
  const std::string path = (directory.path() / "camera.stream").string();
  auto writer = std::make_unique<sim::FramePipe>(path);
  const SourceChoice choice = parse_source("stream:" + path);
  FrameThread frames([&] { return open_source(choice, kTiny, false); }, nullptr, 0.0);
  send(*writer, 1, 11);
  ASSERT_TRUE(gets(frames, 11));

  writer.reset();
  EXPECT_TRUE(wait_until([&] { return !frames.report().is_open; }, 10s));
  writer = std::make_unique<sim::FramePipe>(path);
  send(*writer, 1, 22);

  EXPECT_TRUE(gets(frames, 22));
  EXPECT_GE(frames.report().reopened, 1U);
}

TEST(FrameThread, WaitsForASourceThatIsNotThereYet) {
  std::atomic<bool> is_plugged_in{false};
  FrameThread frames(
      [&]() -> std::unique_ptr<FrameSource> {
        if (!is_plugged_in) {
          throw SourceError("/dev/video7: not there");
        }
        return make_still_frames({tiny_frame(5)}, true);
      },
      nullptr,
      0.0);

  EXPECT_TRUE(wait_until([&] { return frames.report().problem == "/dev/video7: not there"; }, 10s));
  is_plugged_in = true;

  EXPECT_TRUE(gets(frames, 5));
}

TEST(FrameThread, KeepsALiveSourceBelowTheRate) {
  const test::TempDirectory directory;
  const std::string path = (directory.path() / "camera.stream").string();
  sim::FramePipe writer(path);
  const SourceChoice choice = parse_source("stream:" + path);
  FrameThread frames([&] { return open_source(choice, kTiny, false); }, nullptr, 1.0);

  const HostTime start = bus::host_now();
  for (std::uint64_t i = 1; i <= 50; ++i) {  // far faster than one per second
    send(writer, i, 1);
  }
  ASSERT_TRUE(wait_until([&] { return writer.is_free(); }, 10s));

  const double seconds = to_seconds(bus::host_now() - start);
  EXPECT_LE(static_cast<double>(frames.report().frames), seconds + 2.0);
}

}  // namespace
}  // namespace teamsight::agent
