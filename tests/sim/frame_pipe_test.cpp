// tests/sim/frame_pipe_test.cpp: a FIFO that nobody reads stalls nobody.
#include "sim/frame_pipe.hpp"

#include <stdexcept>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/support/process.hpp"

namespace teamsight::sim {
namespace {

const agent::StreamHeader kHeader{4, 2, vision::PixelFormat::kYuyv, {}, 1};

TEST(FramePipe, DropsFramesWhileNobodyReads) {
  const test::TempDirectory directory;
  FramePipe pipe(directory.path() / "a.stream");

  pipe.send(kHeader, std::vector<std::uint8_t>(16, 1));

  EXPECT_EQ(pipe.dropped(), 1U);
}

TEST(FramePipe, DropsFramesUntilTheReaderHasTakenTheLast) {
  const test::TempDirectory directory;
  const std::string path = (directory.path() / "a.stream").string();
  FramePipe pipe(path);
  const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  ASSERT_GE(reader, 0);

  pipe.send(kHeader, std::vector<std::uint8_t>(16, 1));
  pipe.send(kHeader, std::vector<std::uint8_t>(16, 2));
  EXPECT_EQ(pipe.dropped(), 1U);
  std::vector<std::uint8_t> got(1000);
  EXPECT_EQ(::read(reader, got.data(), got.size()), 48);
  pipe.send(kHeader, std::vector<std::uint8_t>(16, 3));

  EXPECT_EQ(::read(reader, got.data(), got.size()), 48);
  EXPECT_EQ(got[40], 3);
  ::close(reader);
}

TEST(FramePipe, OutlivesItsReader) {
  const test::TempDirectory directory;
  const std::string path = (directory.path() / "a.stream").string();
  FramePipe pipe(path);
  const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  pipe.send(kHeader, std::vector<std::uint8_t>(16, 1));
  ::close(reader);

  pipe.send(kHeader, std::vector<std::uint8_t>(16, 2));  // SIGPIPE would end this test
  const int second = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  pipe.send(kHeader, std::vector<std::uint8_t>(16, 3));

  std::vector<std::uint8_t> got(1000);
  EXPECT_EQ(::read(second, got.data(), got.size()), 48);
  EXPECT_EQ(got[40], 3);
  ::close(second);
}

TEST(FramePipe, RefusesToReplaceAFile) {
  const test::TempDirectory directory;
  const auto path = directory.write("a.stream", "precious");

  EXPECT_THROW(FramePipe{path}, std::runtime_error);
}

}  // namespace
}  // namespace teamsight::sim
