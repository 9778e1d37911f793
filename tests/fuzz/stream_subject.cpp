// tests/fuzz/stream_subject.cpp: the stream in pieces and at once must give the same frames.
#include <algorithm>
#include <vector>

#include "agent/frame_stream.hpp"
#include "tests/fuzz/subjects.hpp"

namespace teamsight::fuzz {
namespace {

// A frame larger than what is left of the stream would only be waited for.
constexpr std::uint32_t kMostPixels = 1U << 20U;

struct Parsed {
  std::vector<agent::Frame> frames;
  std::string fault;
};

Parsed parse(std::span<const std::uint8_t> stream, std::size_t piece) {
  Parsed parsed;
  agent::StreamParser parser;
  agent::Frame frame;
  while (!stream.empty()) {
    const auto room = parser.room(frame);
    if (room.empty()) {
      parsed.fault = "no room";
      return parsed;
    }
    const std::size_t count = std::min({room.size(), piece, stream.size()});
    std::copy_n(stream.begin(), count, room.begin());
    stream = stream.subspan(count);
    if (parser.filled(count, frame)) {
      if (!vision::is_whole(frame.view())) parsed.fault = "not a whole frame";
      parsed.frames.push_back(frame);
    }
    if (frame.width_px * frame.height_px > kMostPixels) break;
  }
  return parsed;
}

bool are_same(const agent::Frame& a, const agent::Frame& b) {
  return a.bytes == b.bytes && a.width_px == b.width_px && a.height_px == b.height_px &&
         a.format == b.format && a.exposure == b.exposure && a.sequence == b.sequence;
}

}  // namespace

std::string fault_of_frame_stream(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return "";
  const auto stream = bytes.subspan(1);
  const Parsed whole = parse(stream, stream.size());
  if (!whole.fault.empty()) return whole.fault;
  const Parsed pieces = parse(stream, std::size_t{bytes.front()} + 1);
  if (!pieces.fault.empty()) return pieces.fault;
  const bool same = std::ranges::equal(whole.frames, pieces.frames, are_same);
  return same ? "" : "pieces give other frames";
}

}  // namespace teamsight::fuzz
