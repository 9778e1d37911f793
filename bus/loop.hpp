// bus/loop.hpp: the one thread of a process, waiting on topics, timers and descriptors.
#pragma once

#include <functional>
#include <memory>

#include "geometry/time.hpp"

namespace teamsight::bus {

/// Waits with epoll and CLOCK_MONOTONIC timers, so that no step of the wall clock delays it.
///
/// Handlers run one after the other on the thread that calls `run`; they must not throw.
/// SIGINT and SIGTERM end `run`; from its making to its end they are blocked and wait here, so make
/// it first in `main`: threads made before would still be ended by them. Programs that it starts
/// inherit the block. Only `stop` may be called from another thread.
class Loop {
 public:
  Loop();
  ~Loop();
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  /// Calls `handler` whenever `descriptor` is readable, e.g. Reader::event_fd().
  void on_readable(int descriptor, std::function<void()> handler);

  /// No longer listens to `descriptor`.
  void forget(int descriptor);

  /// Calls `handler` every `period`, the first time after one period. Missed ticks are not made up.
  ///
  /// @param jitter  each period is drawn anew, up to this share longer or shorter, so that
  /// processes
  ///                that started together do not speak together; in [0, 1)
  void every(Duration period, std::function<void()> handler, double jitter = 0.0);

  /// Returns after `stop`, SIGINT or SIGTERM.
  void run();

  void stop() noexcept;

  /// False once a stop was asked for; for loops inside handlers and for Participant::join.
  [[nodiscard]] bool keeps_running() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace teamsight::bus
