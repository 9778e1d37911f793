// tests/recording/spoilt_recording_test.cpp: whatever stands in a recording, it is read or refused.
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>

#include "bus/fault.hpp"
#include "recording/from_proto.hpp"
#include "recording/mcap_reader.hpp"
#include "recording/topic_channel.hpp"
#include "tests/bus/samples.hpp"
#include "tests/support/process.hpp"
#include "tests/support/property.hpp"
#include "tests/support/spoilt.hpp"

namespace teamsight::recording {
namespace {

using testing_support::holds_for_all;
using testing_support::spoilt_at_random;

/// A file of six chunks with an index.
std::string good_file() {
  std::string bytes;
  McapWriter writer([&](std::string_view part) { return bytes.append(part), true; }, "test");
  writer.add_metadata("facts", {{"team", "demo"}});
  const auto channel = writer.add_channel({"ball", "protobuf", {"x.Ball", "protobuf", "schema"}});
  for (int i = 0; i < 60; ++i) {
    writer.write(channel, {1000 + 10 * i, 500 + i, 7}, std::to_string(i));
    if (i % 10 == 9) writer.flush();
  }
  writer.finish();
  return bytes;
}

/// What is wrong with a file, in one line; empty: nothing, and all of it was read.
std::string complaint_of(const std::filesystem::path& path) {
  try {
    const McapReader reader(path);
    std::uint64_t messages = 0;
    std::size_t bytes = 0;
    reader.for_each({}, [&](const Message& message) {
      bytes += message.payload.size() + message.channel->topic.size();
      RC_ASSERT(bytes < 100'000U);
      ++messages;
      return true;
    });
    return messages == reader.contents().messages ? reader.contents().damage : "miscounted";
  } catch (const RecordingError& error) {
    const std::string text = error.what();
    return text.find("spoilt.mcap: ") == std::string::npos ? "not named\n" + text : text;
  }
}

TEST(SpoiltRecording, IsReadOrRefusedInOneLineThatNamesTheFile) {
  const test::TempDirectory folder;
  const std::string good = good_file();
  int refused = 0;

  holds_for_all(
      51,
      [&] {
        const auto path = folder.write("spoilt.mcap", spoilt_at_random(good));
        const std::string complaint = complaint_of(path);
        refused += complaint.empty() ? 0 : 1;
        RC_ASSERT(complaint.find('\n') == std::string::npos);
      },
      200);

  EXPECT_GT(refused, 60);
}

/// Whether a spoilt payload of this topic is refused; one that is taken must be a good value.
template <class Message>
bool is_refused() {
  const std::string good = payload_of(bus::testing::full<Message>());
  const auto message = from_payload<Message>(spoilt_at_random(good));
  if (!message) return true;
  RC_ASSERT(!bus::fault_of(*message));
  RC_ASSERT(from_payload<Message>(payload_of(*message)) == message);
  return false;
}

TEST(SpoiltPayload, IsAValueThatAReaderOnTheBusWouldTakeOrRefused) {
  const std::vector<std::function<bool()>> topics{is_refused<WorldModel>,
                                                  is_refused<bus::RobotState>,
                                                  is_refused<bus::Sightings>,
                                                  is_refused<bus::Explanation>,
                                                  is_refused<bus::GameState>,
                                                  is_refused<bus::Diagnostics>,
                                                  is_refused<bus::LinePoints>};
  int refused = 0;

  holds_for_all(
      52,
      [&] { refused += topics[*rc::gen::inRange(std::size_t{0}, topics.size())]() ? 1 : 0; },
      3000);

  EXPECT_GT(refused, 300);
  EXPECT_LT(refused, 3000);
}

}  // namespace
}  // namespace teamsight::recording
