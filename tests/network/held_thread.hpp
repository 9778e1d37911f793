// tests/network/held_thread.hpp: one thread of another process stands still, and its others go on.
#pragma once

#include <sys/types.h>

namespace teamsight::network {

/// Holds a thread where it is, as a loop that never comes back holds it; the object's end lets it
/// go on. A signal would stop the whole process.
class HeldThread {
 public:
  /// @param thread  of a child of this process; the main thread's number is the process's
  /// @throws std::runtime_error if it cannot be held
  explicit HeldThread(pid_t thread);
  HeldThread(const HeldThread&) = delete;
  HeldThread& operator=(const HeldThread&) = delete;
  ~HeldThread();

 private:
  pid_t thread_;
};

}  // namespace teamsight::network
