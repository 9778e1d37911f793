// agent/frame_stream.hpp: frames through a pipe from another process on this computer.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "agent/frame_source.hpp"

namespace teamsight::agent {

/// Stands before each frame's bytes in a stream. Both ends run on one computer: its byte order.
struct StreamHeader {
  std::uint32_t width_px{0};
  std::uint32_t height_px{0};
  vision::PixelFormat format{vision::PixelFormat::kBgr};
  HostTime exposure{};
  std::uint64_t sequence{0};

  friend bool operator==(const StreamHeader&, const StreamHeader&) = default;
};

/// Magic number, width, height, format (4 bytes each), exposure in ns, sequence (8 bytes each).
inline constexpr std::size_t kStreamHeaderBytes = 32;

/// Larger pictures than this are no pictures (8192 x 8192 in 3 bytes).
inline constexpr std::size_t kMaxStreamFrameBytes = std::size_t{8192} * 8192 * 3;

using StreamHeaderBytes = std::array<std::uint8_t, kStreamHeaderBytes>;

[[nodiscard]] StreamHeaderBytes encode_stream_header(const StreamHeader& header);

/// Reads a header.
///
/// @return nothing if these bytes are none: wrong magic number, unknown format, a size that
///         cannot be, or not in this format
[[nodiscard]] std::optional<StreamHeader> decode_stream_header(std::span<const std::uint8_t> bytes);

/// How many bytes of picture follow a header.
[[nodiscard]] std::size_t picture_bytes(const StreamHeader& header);

/// Takes a stream apart, however it is cut into pieces. After bytes that are no header it looks
/// for the next magic number, so that a reader that joins in the middle finds the next frame.
class StreamParser {
 public:
  /// Where the next bytes of the stream belong; never empty.
  ///
  /// @param frame  being filled; the same object until it is whole
  [[nodiscard]] std::span<std::uint8_t> room(Frame& frame);

  /// So many bytes were put there.
  ///
  /// @return whether `frame` is whole now
  bool filled(std::size_t count, Frame& frame);

  /// Bytes thrown away because they were no header.
  [[nodiscard]] std::uint64_t skipped() const { return skipped_; }

 private:
  void find_header(Frame& frame);

  StreamHeaderBytes header_{};
  std::size_t header_filled_{0};
  std::size_t picture_filled_{0};
  bool in_picture_{false};
  std::uint64_t skipped_{0};
};

}  // namespace teamsight::agent
