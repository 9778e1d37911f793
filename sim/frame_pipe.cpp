// sim/frame_pipe.cpp: see frame_pipe.hpp.
#include "sim/frame_pipe.hpp"

#include <cerrno>
#include <csignal>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace teamsight::sim {
namespace {

// A whole frame of 640x480 fits, so that one write hands it over.
constexpr int kPipeBytes = 1 << 20;

}  // namespace

FramePipe::FramePipe(std::filesystem::path path) : path_(std::move(path)) {
  struct ::sigaction ignore {};

  ignore.sa_handler = SIG_IGN;  // a reader that leaves is an error code of write(), not the end
  ::sigaction(SIGPIPE, &ignore, nullptr);
  const bool is_made = ::mkfifo(path_.c_str(), 0600) == 0;
  if (!is_made && errno != EEXIST) {
    throw std::runtime_error(path_.string() + ": cannot be made (" +
                             std::generic_category().message(errno) + "), expected a FIFO");
  }
  if (!is_made && !std::filesystem::is_fifo(path_)) {
    throw std::runtime_error(path_.string() + ": found something else, expected a FIFO");
  }
}

FramePipe::~FramePipe() {
  close();
}

void FramePipe::open() {
  descriptor_ = ::open(path_.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor_ >= 0) {
    ::fcntl(descriptor_, F_SETPIPE_SZ, kPipeBytes);  // if refused it takes several writes
  }
  buffer_.clear();
  sent_ = 0;
}

void FramePipe::close() noexcept {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
  descriptor_ = -1;
  sent_ = buffer_.size();
}

// A reader that left behind half a frame: the next one must not find it.
bool FramePipe::has_lost_its_reader() const {
  pollfd waiting{descriptor_, POLLOUT, 0};
  return descriptor_ >= 0 && ::poll(&waiting, 1, 0) == 1 && (waiting.revents & POLLERR) != 0;
}

bool FramePipe::is_free() {
  if (has_lost_its_reader()) {
    close();
  }
  if (descriptor_ < 0) {
    open();
  }
  flush();
  int waiting = 0;
  return descriptor_ >= 0 && sent_ == buffer_.size() &&
         ::ioctl(descriptor_, FIONREAD, &waiting) == 0 && waiting == 0;
}

void FramePipe::send(const agent::StreamHeader& header, std::span<const std::uint8_t> picture) {
  if (!is_free()) {
    ++dropped_;
    return;
  }
  const agent::StreamHeaderBytes head = agent::encode_stream_header(header);
  buffer_.assign(head.begin(), head.end());
  buffer_.insert(buffer_.end(), picture.begin(), picture.end());
  sent_ = 0;
  flush();
}

void FramePipe::flush() {
  while (descriptor_ >= 0 && sent_ < buffer_.size()) {
    const ssize_t count = ::write(descriptor_, buffer_.data() + sent_, buffer_.size() - sent_);
    if (count > 0) {
      sent_ += static_cast<std::size_t>(count);
    } else if (errno == EPIPE) {
      close();
    } else if (errno != EINTR) {
      return;  // full: the rest goes when the reader has made room
    }
  }
}

}  // namespace teamsight::sim
