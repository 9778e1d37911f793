// sim/frame_pipe.hpp: frames into a FIFO that nobody may be reading.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "agent/frame_stream.hpp"

namespace teamsight::sim {

/// Writes frames to a FIFO without ever waiting: while nobody reads, or the reader has not taken
/// the frame before, a frame is dropped. Ignores SIGPIPE for the process.
class FramePipe {
 public:
  /// Makes the FIFO if it is not there.
  ///
  /// @throws std::runtime_error if it cannot be made, or something else has that name
  explicit FramePipe(std::filesystem::path path);
  ~FramePipe();
  FramePipe(const FramePipe&) = delete;
  FramePipe& operator=(const FramePipe&) = delete;

  /// Whether a frame given now would be taken: somebody reads and the last one is through.
  [[nodiscard]] bool is_free();

  /// Whether somebody read when is_free() was last asked.
  [[nodiscard]] bool is_read() const { return descriptor_ >= 0; }

  /// Sends one frame, or drops it if the pipe is not free.
  void send(const agent::StreamHeader& header, std::span<const std::uint8_t> picture);

  /// Goes on with a frame that did not fit at once; to be called now and then.
  void flush();

  [[nodiscard]] std::uint64_t dropped() const { return dropped_; }

 private:
  [[nodiscard]] bool has_lost_its_reader() const;
  void open();
  void close() noexcept;

  std::filesystem::path path_;
  int descriptor_{-1};
  std::vector<std::uint8_t> buffer_;  // the frame on its way
  std::size_t sent_{0};               // of the buffer
  std::uint64_t dropped_{0};
};

}  // namespace teamsight::sim
