// tests/agent/frame_stream_test.cpp: frames through a pipe survive any cutting, rubbish does not.
#include "agent/frame_stream.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/property.hpp"

namespace teamsight::agent {
namespace {

StreamHeader small_header() {
  return {4, 2, vision::PixelFormat::kYuyv, HostTime{Duration{123456789}}, 7};
}

std::vector<std::uint8_t> whole(const StreamHeader& header, std::uint8_t fill) {
  const StreamHeaderBytes head = encode_stream_header(header);
  std::vector<std::uint8_t> bytes(head.begin(), head.end());
  bytes.insert(bytes.end(), picture_bytes(header), fill);
  return bytes;
}

// Feeds a stream in pieces of at most `piece` bytes; the frames that came out.
std::vector<Frame> parse(const std::vector<std::uint8_t>& stream, std::size_t piece) {
  StreamParser parser;
  Frame frame;
  std::vector<Frame> frames;
  for (std::size_t at = 0; at < stream.size();) {
    const auto room = parser.room(frame);
    const std::size_t count = std::min({room.size(), piece, stream.size() - at});
    std::copy_n(stream.begin() + static_cast<std::ptrdiff_t>(at), count, room.begin());
    at += count;
    if (parser.filled(count, frame)) {
      frames.push_back(frame);
    }
  }
  return frames;
}

TEST(StreamHeader, ComesBackAsItWasWritten) {
  const StreamHeader header{640, 480, vision::PixelFormat::kUyvy, HostTime{Duration{-5}}, 99};

  EXPECT_EQ(decode_stream_header(encode_stream_header(header)), header);
}

TEST(StreamHeader, IsRefusedWithAnotherMagicNumberFormatOrSize) {
  StreamHeaderBytes magic = encode_stream_header(small_header());
  magic[0] = 'X';
  StreamHeaderBytes format = encode_stream_header(small_header());
  format[12] = 77;
  StreamHeader empty = small_header();
  empty.width_px = 0;
  StreamHeader huge = small_header();
  huge.height_px = 100000;
  StreamHeader odd = small_header();
  odd.width_px = 5;  // two pixels share their chroma

  EXPECT_FALSE(decode_stream_header(magic).has_value());
  EXPECT_FALSE(decode_stream_header(format).has_value());
  EXPECT_FALSE(decode_stream_header(encode_stream_header(empty)).has_value());
  EXPECT_FALSE(decode_stream_header(encode_stream_header(huge)).has_value());
  EXPECT_FALSE(decode_stream_header(encode_stream_header(odd)).has_value());
  EXPECT_FALSE(decode_stream_header({}).has_value());
}

TEST(StreamParser, FindsTheNextFrameAfterRubbish) {
  std::vector<std::uint8_t> stream{'T', 'S', 'T', 'S', 'F', 9, 9, 9};
  stream.resize(1000, 'T');  // every byte might be the beginning
  const auto frame = whole(small_header(), 42);
  stream.insert(stream.end(), frame.begin(), frame.end());

  const std::vector<Frame> frames = parse(stream, 64);

  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0].sequence, 7U);
  EXPECT_EQ(frames[0].exposure, HostTime{Duration{123456789}});
  EXPECT_EQ(frames[0].bytes, std::vector<std::uint8_t>(16, 42));
}

TEST(StreamParser, GivesTheSameFramesHoweverTheStreamIsCut) {
  testing_support::holds_for_all(20261122, [] {
    const auto piece = static_cast<std::size_t>(*rc::gen::inRange(1, 200));
    const auto rubbish = *rc::gen::container<std::vector<std::uint8_t>>(
        rc::gen::inRange<std::uint8_t>(0, 'T'));  // never the first letter of a header
    std::vector<std::uint8_t> stream = rubbish;
    for (std::uint8_t fill = 1; fill <= 3; ++fill) {
      const auto frame = whole(small_header(), fill);
      stream.insert(stream.end(), frame.begin(), frame.end());
    }

    const std::vector<Frame> frames = parse(stream, piece);

    RC_ASSERT(frames.size() == 3U);
    RC_ASSERT(frames[2].bytes == std::vector<std::uint8_t>(16, 3));
  });
}

}  // namespace
}  // namespace teamsight::agent
