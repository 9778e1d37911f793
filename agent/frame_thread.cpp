// agent/frame_thread.cpp: see frame_thread.hpp.
#include "agent/frame_thread.hpp"

#include <algorithm>
#include <array>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include <sys/eventfd.h>
#include <unistd.h>

#include "bus/clock.hpp"

namespace teamsight::agent {
namespace {

using namespace std::chrono_literals;

constexpr Duration kPatience =
    100ms;  // how long one call of next() may keep the thread from ending
constexpr Duration kFirstBackOff = 50ms;
constexpr Duration kLongestBackOff = 2s;

}  // namespace

struct FrameThread::Impl {
  Impl(Open open_again, std::unique_ptr<FrameSource> first, double rate_hz)
      : open(std::move(open_again)),
        source(std::move(first)),
        period(rate_hz > 0 ? from_seconds(1.0 / rate_hz) : Duration{0}),
        event(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
    report.is_open = source != nullptr;
  }

  ~Impl() { ::close(event); }

  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void run() noexcept {
    while (!is_stopping()) {
      if (source == nullptr && !try_open()) {
        rest(back_off);
        back_off = std::min<Duration>(2 * back_off, kLongestBackOff);
        continue;
      }
      read_one();
    }
  }

  bool try_open() noexcept {
    std::string problem;
    try {
      source = open();
    } catch (const std::exception& error) {
      problem = error.what();
    }
    const std::scoped_lock lock(mutex);
    report.is_open = source != nullptr;
    report.problem = problem;
    if (report.is_open && was_open) {
      ++report.reopened;
    }
    return report.is_open;
  }

  void read_one() noexcept {
    if (!source->is_live() && !wait_for_turn()) {
      return;
    }
    switch (source->next(frames[writing], bus::host_now() + kPatience)) {
      case FrameResult::kFrame:
        accept();
        break;
      case FrameResult::kNothingYet:
        break;
      case FrameResult::kGone:
        lose("the source ended");
        rest(back_off);
        break;
      case FrameResult::kFinished:
        finish();
        break;
    }
  }

  // Files: until the rate allows the next one, or without a rate until the last one was taken.
  bool wait_for_turn() {
    std::unique_lock lock(mutex);
    if (period.count() == 0) {
      changed.wait(lock, [this] { return stopping || !ready.has_value(); });
      return !stopping;
    }
    const HostTime now = bus::host_now();
    due = due + 2 * period < now ? now : due + period;  // a turn or more missed: not made up
    changed.wait_for(lock, std::max<Duration>(due - now, Duration{0}), [this] { return stopping; });
    return !stopping;
  }

  void accept() {
    Frame& frame = frames[writing];
    const std::scoped_lock lock(mutex);
    was_open = true;
    back_off = kFirstBackOff;
    if (source->is_live() && is_too_early(frame.exposure)) {
      return;
    }
    frame.sequence = ++report.frames;
    if (ready.has_value()) {
      ++report.overwritten;
    }
    // The one that is neither written nor read: the frame just replaced, or the spare one.
    const std::size_t free = ready.value_or(3 - writing - reading);
    ready = std::exchange(writing, free);
    signal();
  }

  // Keeps to the rate on average, whatever the source's own rate is.
  bool is_too_early(HostTime exposure) {
    if (period.count() == 0) {
      return false;
    }
    if (exposure < due) {
      return true;
    }
    due = std::max(due + period, exposure);
    return false;
  }

  void lose(const char* problem) {
    const std::scoped_lock lock(mutex);
    source.reset();
    report.is_open = false;
    report.problem = problem;
  }

  void finish() {
    std::unique_lock lock(mutex);
    report.is_finished = true;
    changed.wait(lock, [this] { return stopping; });
  }

  void rest(Duration duration) {
    std::unique_lock lock(mutex);
    changed.wait_for(lock, duration, [this] { return stopping; });
  }

  bool is_stopping() {
    const std::scoped_lock lock(mutex);
    return stopping;
  }

  void signal() const {
    const std::uint64_t one = 1;
    [[maybe_unused]] const auto written = ::write(event, &one, sizeof(one));
  }

  void clear() const {
    std::uint64_t count = 0;
    [[maybe_unused]] const auto got = ::read(event, &count, sizeof(count));
  }

  Open open;
  std::unique_ptr<FrameSource> source;
  Duration period;
  int event;
  HostTime due{};
  Duration back_off{kFirstBackOff};
  bool was_open{false};
  std::array<Frame, 3> frames;
  std::size_t writing{0};  // the thread's own

  std::mutex mutex;  // guards what follows
  std::condition_variable changed;
  bool stopping{false};
  std::size_t reading{1};
  std::optional<std::size_t> ready;
  SourceReport report;
  std::thread thread;
};

FrameThread::FrameThread(Open open, std::unique_ptr<FrameSource> first, double rate_hz)
    : impl_(std::make_unique<Impl>(std::move(open), std::move(first), rate_hz)) {
  impl_->thread = std::thread([impl = impl_.get()] { impl->run(); });
}

FrameThread::~FrameThread() {
  {
    const std::scoped_lock lock(impl_->mutex);
    impl_->stopping = true;
  }
  impl_->changed.notify_all();
  impl_->thread.join();
}

int FrameThread::event_fd() const noexcept {
  return impl_->event;
}

const Frame* FrameThread::take() {
  const std::scoped_lock lock(impl_->mutex);
  impl_->clear();
  if (!impl_->ready.has_value()) {
    return nullptr;
  }
  impl_->reading = *std::exchange(impl_->ready, std::nullopt);
  impl_->changed.notify_all();
  return &impl_->frames[impl_->reading];
}

SourceReport FrameThread::report() const {
  const std::scoped_lock lock(impl_->mutex);
  return impl_->report;
}

}  // namespace teamsight::agent
