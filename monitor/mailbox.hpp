// monitor/mailbox.hpp: messages from the web server's thread to the station's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <utility>
#include <vector>

#include <sys/eventfd.h>
#include <unistd.h>

#include "monitor/web_server.hpp"

namespace teamsight::monitor {

/// What clients said, for the station's thread.
class Mailbox {
 public:
  Mailbox() : event_fd_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}

  ~Mailbox() { ::close(event_fd_); }

  Mailbox(const Mailbox&) = delete;
  Mailbox& operator=(const Mailbox&) = delete;

  [[nodiscard]] int event_fd() const { return event_fd_; }

  /// @return false if the station does not keep up
  bool put(ClientMessage message) {
    const std::lock_guard lock(mutex_);
    if (messages_.size() == kMostWaiting) return false;
    messages_.push_back(std::move(message));
    const std::uint64_t one = 1;
    return ::write(event_fd_, &one, sizeof one) == sizeof one;
  }

  [[nodiscard]] std::vector<ClientMessage> take() {
    const std::lock_guard lock(mutex_);
    std::uint64_t ignored = 0;
    [[maybe_unused]] const ssize_t got = ::read(event_fd_, &ignored, sizeof ignored);
    return std::exchange(messages_, {});
  }

 private:
  static constexpr std::size_t kMostWaiting = 256;

  int event_fd_;
  std::mutex mutex_;
  std::vector<ClientMessage> messages_;
};

}  // namespace teamsight::monitor
