// agent/frame_thread.hpp: reads frames on a thread of its own and keeps the newest.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "agent/frame_source.hpp"

namespace teamsight::agent {

/// What the thread says of its source.
struct SourceReport {
  bool is_open{false};
  bool is_finished{false};       ///< files without loop: the last frame has been given
  std::uint64_t frames{0};       ///< read
  std::uint64_t overwritten{0};  ///< read but replaced by a newer one before anybody took it
  std::uint64_t reopened{0};     ///< opened again after it was gone
  std::string problem;           ///< why it is not open; empty if it is
};

/// Keeps a source open and the newest frame ready.
///
/// A source that is gone is opened again, first after 50 ms, then ever later up to 2 s. Three
/// frames change places: no memory is taken per frame, and nobody waits for anybody.
class FrameThread {
 public:
  /// Opens the source; throws SourceError when it is not there. Called on the thread.
  using Open = std::function<std::unique_ptr<FrameSource>()>;

  /// @param open     for the next time the source is gone
  /// @param first    already open; nothing: the thread opens it
  /// @param rate_hz  at most so many frames per second; 0: live sources as they come, files when
  ///                 the frame before was taken
  FrameThread(Open open, std::unique_ptr<FrameSource> first, double rate_hz);

  /// Waits for the thread, and so up to a second for a source that blocks.
  ~FrameThread();
  FrameThread(const FrameThread&) = delete;
  FrameThread& operator=(const FrameThread&) = delete;

  /// Readable when there is a frame to take; cleared by `take`.
  [[nodiscard]] int event_fd() const noexcept;

  /// The newest frame that was not taken yet; its `sequence` counts all frames of this thread.
  ///
  /// @return nothing (nullptr) if there is none; valid until the next call
  [[nodiscard]] const Frame* take();

  [[nodiscard]] SourceReport report() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace teamsight::agent
