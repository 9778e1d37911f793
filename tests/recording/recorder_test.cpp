// tests/recording/recorder_test.cpp: files that follow one another, and a disk that is full.
#include "recording/recorder.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <sys/resource.h>

#include "recording/mcap_reader.hpp"
#include "tests/support/process.hpp"

namespace teamsight::recording {
namespace {

using std::chrono::milliseconds;
using ::testing::HasSubstr;

constexpr milliseconds kBound{10'000};
const Channel kChannel{"topic", "protobuf", {"x.Y", "protobuf", ""}};

/// Bytes that zstd cannot make smaller.
std::string noise(std::size_t size) {
  static std::mt19937 random(7);  // NOLINT: a fixed seed is wanted
  std::string bytes(size, '\0');
  std::ranges::generate(bytes, []() { return static_cast<char>(random()); });
  return bytes;
}

RecorderSettings settings_in(const std::filesystem::path& folder) {
  RecorderSettings settings;
  settings.folder = folder / "log";
  settings.library = "test";
  settings.facts = {{"team", "demo"}};
  settings.flush_every = milliseconds(5);
  settings.retry_every = milliseconds(20);
  settings.log_minus_host = Duration{1000};
  return settings;
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "log")) {
    files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

/// Lets no file of this process grow beyond so many bytes: a disk that is full, for one test.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }

  ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }

  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
};

TEST(Recorder, StampsWithTheTimeOfArrivalMovedToTheFilesClock) {
  const test::TempDirectory folder;
  Recorder recorder(settings_in(folder.path()));
  const ChannelId channel = recorder.add_channel(kChannel);

  recorder.write(channel, HostTime{Duration{5}}, PeerTime{Duration{77}}, "hello");
  recorder.finish();

  const McapReader reader(files_in(folder.path()).at(0));
  EXPECT_EQ(reader.contents().metadata.at("teamsight.recording").at("log_minus_host_ns"), "1000");
  reader.for_each({}, [](const Message& message) {
    EXPECT_EQ(message.stamp, (MessageStamp{1005, 77, 0}));
    EXPECT_EQ(message.payload, "hello");
    return true;
  });
  EXPECT_EQ(reader.contents().messages, 1U);
}

TEST(Recorder, BeginsANewFileWhenOneIsFullAndLosesNothing) {
  const test::TempDirectory folder;
  RecorderSettings settings = settings_in(folder.path());
  settings.max_file_bytes = 100'000;
  Recorder recorder(settings);
  const ChannelId channel = recorder.add_channel(kChannel);

  for (int i = 0; i < 50; ++i) {
    recorder.write(channel, HostTime{Duration{i}}, {}, noise(20'000));
    ASSERT_TRUE(
        test::wait_until([&]() { return recorder.report().messages > std::uint64_t(i); }, kBound));
  }
  recorder.finish();

  std::uint64_t messages = 0;
  for (const auto& file : files_in(folder.path())) {
    const Contents contents = McapReader(file).contents();
    EXPECT_EQ(contents.damage, "");
    EXPECT_LT(contents.file_bytes, 150'000U);
    messages += contents.messages;
  }
  EXPECT_EQ(messages, 50U);
  EXPECT_GE(files_in(folder.path()).size(), 8U);
  EXPECT_EQ(recorder.report().dropped, 0U);
}

TEST(Recorder, SaysWhenTheDiskIsFullCountsTheRestAndGoesOnWhenThereIsRoom) {
  const test::TempDirectory folder;
  Recorder recorder(settings_in(folder.path()));
  const ChannelId channel = recorder.add_channel(kChannel);
  int sent = 0;
  const auto send = [&]() {
    recorder.write(channel, HostTime{Duration{++sent}}, {}, noise(30'000));
  };

  {
    const FullDisk disk(100'000);
    const bool told = test::wait_until(
        [&]() {
          send();
          return !recorder.report().problem.empty() && recorder.report().dropped > 0;
        },
        kBound);
    ASSERT_TRUE(told);
    EXPECT_THAT(recorder.report().problem, HasSubstr(".mcap: File too large"));
  }
  ASSERT_TRUE(test::wait_until(
      [&]() {
        send();
        return recorder.report().problem.empty();
      },
      kBound));
  send();
  recorder.finish();

  std::uint64_t readable = 0;
  for (const auto& file : files_in(folder.path())) {
    readable += McapReader(file).contents().messages;
  }
  const RecorderReport report = recorder.report();
  EXPECT_EQ(report.messages + report.dropped, static_cast<std::uint64_t>(sent));
  EXPECT_EQ(readable, report.messages);
}

TEST(Recorder, DropsAndCountsWhatADiskThatStallsCannotTake) {
  const test::TempDirectory folder;
  RecorderSettings settings = settings_in(folder.path());
  settings.flush_every = std::chrono::hours(1);
  settings.max_queued_bytes = 1000;
  Recorder recorder(settings);
  const ChannelId channel = recorder.add_channel(kChannel);

  for (int i = 0; i < 5; ++i) recorder.write(channel, {}, {}, noise(300));
  recorder.finish();

  EXPECT_EQ(recorder.report().messages, 3U);
  EXPECT_EQ(recorder.report().dropped, 2U);
}

TEST(Recorder, RefusesAFolderThatCannotBe) {
  const test::TempDirectory folder;
  RecorderSettings settings;
  settings.folder = folder.write("file", "") / "below";

  EXPECT_THROW(Recorder{settings}, RecordingError);
}

}  // namespace
}  // namespace teamsight::recording
