// tests/network/rtps_frame.cpp: see rtps_frame.hpp. The layout is that of RTPS 2.2, chapter 9.
#include "tests/network/rtps_frame.hpp"

#include <algorithm>
#include <cstring>
#include <vector>

namespace teamsight::network {
namespace {

constexpr std::size_t kEthernet = 14;
constexpr std::size_t kUdp = 8;
constexpr std::size_t kRtps = 20;
constexpr std::size_t kSubmessage = 4;

enum Submessage : std::uint8_t {
  kAckNack = 0x06,
  kHeartbeat = 0x07,
  kGap = 0x08,
  kNackFragment = 0x12,
  kHeartbeatFragment = 0x13,
  kData = 0x15,
  kDataFragment = 0x16,
};

/// Where in the submessage's body the writer's entity id stands; 0: it has none.
std::size_t writer_at(std::uint8_t kind) {
  switch (kind) {
    case kData:
    case kDataFragment:
      return 8;  // after extra flags, offset to the inline QoS and the reader's id
    case kHeartbeat:
    case kHeartbeatFragment:
    case kGap:
    case kAckNack:
    case kNackFragment:
      return 4;  // after the reader's id
    default:
      return 0;
  }
}

/// The UDP payload of an Ethernet frame with IPv4, if it begins as RTPS does.
struct Payload {
  const std::uint8_t* data{nullptr};
  std::size_t size{0};
};

Payload rtps_in(const std::uint8_t* frame, std::size_t size) {
  if (size < kEthernet + 20 || frame[12] != 0x08 || frame[13] != 0x00) return {};
  const std::size_t ip = static_cast<std::size_t>(frame[kEthernet] & 0x0fU) * 4;
  const std::size_t start = kEthernet + ip + kUdp;
  if (frame[kEthernet + 9] != 17 || size < start + kRtps) return {};
  if (std::memcmp(frame + start, "RTPS", 4) != 0) return {};
  return {frame + start, size - start};
}

std::vector<WriterGuid> writers_in(const Payload& payload) {
  std::vector<WriterGuid> writers;
  for (std::size_t at = kRtps; at + kSubmessage <= payload.size;) {
    const std::uint8_t* header = payload.data + at;
    const bool little = (header[1] & 1U) != 0;
    const std::size_t low = header[little ? 2 : 3];
    const std::size_t length = low | static_cast<std::size_t>(header[little ? 3 : 2]) << 8U;
    const std::size_t offset = writer_at(header[0]);
    if (offset != 0 && at + kSubmessage + offset + 4 <= payload.size) {
      WriterGuid guid{};
      std::copy_n(payload.data + 8, 12, guid.begin());
      std::copy_n(header + kSubmessage + offset, 4, guid.begin() + 12);
      writers.push_back(guid);
    }
    if (length == 0) break;  // the last one, or padding
    at += kSubmessage + length;
  }
  return writers;
}

}  // namespace

void share_out(const std::uint8_t* frame,
               std::size_t size,
               std::map<WriterGuid, std::uint64_t>& bytes) {
  const std::vector<WriterGuid> writers = writers_in(rtps_in(frame, size));
  if (writers.empty()) {
    bytes[WriterGuid{}] += size;
    return;
  }
  for (const WriterGuid& writer : writers) bytes[writer] += size / writers.size();
}

}  // namespace teamsight::network
