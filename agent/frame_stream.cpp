// agent/frame_stream.cpp: see frame_stream.hpp.
#include "agent/frame_stream.hpp"

#include <algorithm>
#include <cstring>

namespace teamsight::agent {
namespace {

constexpr std::array<std::uint8_t, 4> kMagic{'T', 'S', 'F', '1'};

template <class Number>
void put(StreamHeaderBytes& bytes, std::size_t at, Number number) {
  std::memcpy(bytes.data() + at, &number, sizeof(number));
}

template <class Number>
Number get(std::span<const std::uint8_t> bytes, std::size_t at) {
  Number number{};
  std::memcpy(&number, bytes.data() + at, sizeof(number));
  return number;
}

std::optional<vision::PixelFormat> format_of(std::uint32_t code) {
  using vision::PixelFormat;
  if (code > static_cast<std::uint32_t>(PixelFormat::kBayerGbrg)) return std::nullopt;
  return static_cast<PixelFormat>(code);
}

bool is_plausible(std::uint32_t side_px) {
  return side_px > 0 && side_px <= 8192;
}

}  // namespace

StreamHeaderBytes encode_stream_header(const StreamHeader& header) {
  StreamHeaderBytes bytes{};
  std::copy(kMagic.begin(), kMagic.end(), bytes.begin());
  put(bytes, 4, header.width_px);
  put(bytes, 8, header.height_px);
  put(bytes, 12, static_cast<std::uint32_t>(header.format));
  put<std::int64_t>(bytes, 16, header.exposure.time_since_epoch().count());
  put(bytes, 24, header.sequence);
  return bytes;
}

std::optional<StreamHeader> decode_stream_header(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kStreamHeaderBytes ||
      !std::equal(kMagic.begin(), kMagic.end(), bytes.begin())) {
    return std::nullopt;
  }
  const auto format = format_of(get<std::uint32_t>(bytes, 12));
  StreamHeader header;
  header.width_px = get<std::uint32_t>(bytes, 4);
  header.height_px = get<std::uint32_t>(bytes, 8);
  if (!format.has_value() || !is_plausible(header.width_px) || !is_plausible(header.height_px) ||
      !vision::has_even_size(*format, header.width_px, header.height_px)) {
    return std::nullopt;
  }
  header.format = *format;
  header.exposure = HostTime{Duration{get<std::int64_t>(bytes, 16)}};
  header.sequence = get<std::uint64_t>(bytes, 24);
  return header;
}

std::size_t picture_bytes(const StreamHeader& header) {
  return vision::frame_bytes(header.format, header.width_px, header.height_px);
}

std::span<std::uint8_t> StreamParser::room(Frame& frame) {
  if (in_picture_) {
    return std::span(frame.bytes).subspan(picture_filled_);
  }
  return std::span(header_).subspan(header_filled_);
}

bool StreamParser::filled(std::size_t count, Frame& frame) {
  if (in_picture_) {
    picture_filled_ += count;
    in_picture_ = picture_filled_ < frame.bytes.size();
    return !in_picture_;
  }
  header_filled_ += count;
  if (header_filled_ == header_.size()) {
    find_header(frame);
  }
  return false;
}

void StreamParser::find_header(Frame& frame) {
  if (const auto header = decode_stream_header(header_)) {
    frame.width_px = header->width_px;
    frame.height_px = header->height_px;
    frame.format = header->format;
    frame.exposure = header->exposure;
    frame.sequence = header->sequence;
    frame.bytes.resize(picture_bytes(*header));
    in_picture_ = true;
    picture_filled_ = 0;
    header_filled_ = 0;
    return;
  }
  // Not a header: keep what may be the beginning of one, from the second byte on.
  const auto next = std::find(header_.begin() + 1, header_.end(), kMagic.front());
  skipped_ += static_cast<std::uint64_t>(next - header_.begin());
  header_filled_ =
      static_cast<std::size_t>(std::copy(next, header_.end(), header_.begin()) - header_.begin());
}

}  // namespace teamsight::agent
