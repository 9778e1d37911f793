// bus/ending_signals.hpp: SIGINT and SIGTERM as something to ask for, not something that strikes.
#pragma once

#include <csignal>

namespace teamsight::bus {

/// The signals that ask a program to end.
[[nodiscard]] inline sigset_t ending_signals() noexcept {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  return set;
}

/// Holds the ending signals back while it lives; the caller's mask is put back at the end.
///
/// A Loop has one, and finds the signals in its signalfd. A program that starts processes of its
/// own holds one around everything, or a second signal (Ctrl-C, then a supervisor's SIGTERM) ends
/// it while it still waits for them. Threads and children made meanwhile inherit the mask.
class HeldSignals {
 public:
  HeldSignals() noexcept {
    const sigset_t set = ending_signals();
    pthread_sigmask(SIG_BLOCK, &set, &before_);
  }

  ~HeldSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

 private:
  sigset_t before_{};
};

}  // namespace teamsight::bus
