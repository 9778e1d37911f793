// agent/frame_source.hpp: where camera frames come from, behind one interface.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <vector>

#include "geometry/time.hpp"
#include "vision/image.hpp"

namespace teamsight::agent {

/// One picture and the moment it shows.
struct Frame {
  std::vector<std::uint8_t> bytes;  ///< rows from top to bottom without gaps
  std::uint32_t width_px{0};
  std::uint32_t height_px{0};
  vision::PixelFormat format{vision::PixelFormat::kBgr};
  HostTime exposure{};        ///< middle of the exposure, or when it was read if nobody knows
  std::uint64_t sequence{0};  ///< counted by the source; gaps are frames that never got here

  [[nodiscard]] vision::ImageView view() const { return {bytes, width_px, height_px, format}; }
};

/// What became of asking for a frame.
enum class FrameResult : std::uint8_t {
  kFrame,       ///< there is one
  kNothingYet,  ///< the deadline passed
  kGone,        ///< unplugged, or the other side ended; opening again may help
  kFinished,    ///< the last frame has been given; there will never be another
};

/// A source is not there, or cannot be read: one line that says what was found and expected.
class SourceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A camera, or something that takes its place. Used from one thread.
class FrameSource {
 public:
  FrameSource() = default;
  FrameSource(const FrameSource&) = delete;
  FrameSource& operator=(const FrameSource&) = delete;
  virtual ~FrameSource() = default;

  /// Waits for the next frame. May block, but not much longer than until `deadline`.
  ///
  /// @param out  filled if the answer is kFrame, its memory is used again; else unspecified
  virtual FrameResult next(Frame& out, HostTime deadline) noexcept = 0;

  /// Whether frames come by themselves; the frames of files come when they are asked for.
  [[nodiscard]] virtual bool is_live() const noexcept = 0;
};

}  // namespace teamsight::agent
