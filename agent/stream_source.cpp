// agent/stream_source.cpp: see stream_source.hpp.
#include "agent/stream_source.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "agent/frame_stream.hpp"
#include "bus/clock.hpp"

namespace teamsight::agent {
namespace {

int milliseconds_until(HostTime deadline) {
  const auto left =
      std::chrono::duration_cast<std::chrono::milliseconds>(deadline - bus::host_now());
  return static_cast<int>(std::clamp<std::int64_t>(left.count() + 1, 0, 1000));
}

class StreamSource final : public FrameSource {
 public:
  explicit StreamSource(int descriptor) : descriptor_(descriptor) {}

  ~StreamSource() override { ::close(descriptor_); }

  StreamSource(const StreamSource&) = delete;
  StreamSource& operator=(const StreamSource&) = delete;

  FrameResult next(Frame& out, HostTime deadline) noexcept override {
    while (bus::host_now() < deadline) {
      pollfd waiting{descriptor_, POLLIN, 0};
      if (::poll(&waiting, 1, milliseconds_until(deadline)) <= 0) {
        continue;  // nothing in time, or a signal
      }
      switch (read_some()) {
        case Step::kWhole:
          std::swap(out, frame_);
          return FrameResult::kFrame;
        case Step::kEnd:
          return FrameResult::kGone;
        case Step::kMore:
          break;
      }
    }
    return FrameResult::kNothingYet;
  }

  [[nodiscard]] bool is_live() const noexcept override { return true; }

 private:
  enum class Step : std::uint8_t { kMore, kWhole, kEnd };

  Step read_some() {
    const auto room = parser_.room(frame_);
    const ssize_t count = ::read(descriptor_, room.data(), room.size());
    if (count > 0) {
      return parser_.filled(static_cast<std::size_t>(count), frame_) ? Step::kWhole : Step::kMore;
    }
    const bool is_passing = count < 0 && (errno == EAGAIN || errno == EINTR);
    return is_passing ? Step::kMore : Step::kEnd;
  }

  int descriptor_;
  StreamParser parser_;
  Frame frame_;  // being filled; may stay half full over several calls
};

}  // namespace

std::unique_ptr<FrameSource> open_stream(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) {
    throw SourceError(path + ": cannot be opened (" + std::generic_category().message(errno) +
                      "), expected a stream of frames");
  }
  return std::make_unique<StreamSource>(descriptor);
}

}  // namespace teamsight::agent
