// tests/network/held_thread.cpp: see held_thread.hpp.
#include "tests/network/held_thread.hpp"

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <string>

#include <sys/ptrace.h>
#include <sys/wait.h>

namespace teamsight::network {

HeldThread::HeldThread(pid_t thread) : thread_(thread) {
  int status = 0;
  const bool is_held = ::ptrace(PTRACE_SEIZE, thread, nullptr, nullptr) == 0 &&
                       ::ptrace(PTRACE_INTERRUPT, thread, nullptr, nullptr) == 0 &&
                       ::waitpid(thread, &status, __WALL) == thread && WIFSTOPPED(status);
  if (!is_held) {
    throw std::runtime_error("cannot hold thread " + std::to_string(thread) + ": " +
                             std::strerror(errno));
  }
}

HeldThread::~HeldThread() {
  ::ptrace(PTRACE_DETACH, thread_, nullptr, nullptr);
}

}  // namespace teamsight::network
