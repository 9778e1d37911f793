// bus/loop.cpp: epoll, timerfd, eventfd and signalfd; nothing that waits on the wall clock.
#include "bus/loop.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <map>
#include <random>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include "bus/ending_signals.hpp"
#include "bus/participant.hpp"
#include "geometry/expect.hpp"

namespace teamsight::bus {
namespace {

using Handler = std::function<void()>;

int opened(int descriptor, const char* call) {
  if (descriptor >= 0) return descriptor;
  throw BusError(std::string(call) + ": " + std::generic_category().message(errno));
}

class Descriptor {
 public:
  explicit Descriptor(int descriptor) noexcept : descriptor_(descriptor) {}

  ~Descriptor() { ::close(descriptor_); }

  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int get() const noexcept { return descriptor_; }

 private:
  int descriptor_;
};

int make_signal_fd() {
  const sigset_t set = ending_signals();
  return opened(signalfd(-1, &set, SFD_CLOEXEC | SFD_NONBLOCK), "signalfd");
}

/// Reads until there is no more; whether there was something.
bool drain(int descriptor) noexcept {
  std::array<char, sizeof(signalfd_siginfo)> buffer{};
  bool something = false;
  while (::read(descriptor, buffer.data(), buffer.size()) > 0) something = true;
  return something;
}

timespec to_timespec(Duration duration) {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(duration);
  return {seconds.count(), (duration - seconds).count()};
}

// A timer of equal periods, or of periods that are drawn one by one.
class Metronome {
 public:
  Metronome(int timer, Duration period, double jitter)
      : timer_(timer),
        period_(period),
        jitter_(jitter) {}

  [[nodiscard]] int start() {
    const bool is_drawn = jitter_ > 0.0;
    std::uniform_real_distribution<double> share(1.0 - jitter_, 1.0 + jitter_);
    const timespec first =
        to_timespec(is_drawn ? from_seconds(share(random_) * to_seconds(period_)) : period_);
    const itimerspec spec{is_drawn ? timespec{} : first, first};
    return timerfd_settime(timer_, 0, &spec, nullptr);
  }

  /// However many ticks there were: one.
  [[nodiscard]] bool ticked() {
    std::uint64_t ticks = 0;
    if (::read(timer_, &ticks, sizeof ticks) != sizeof ticks) return false;
    if (jitter_ > 0.0) (void)start();
    return true;
  }

 private:
  int timer_;
  Duration period_;
  double jitter_;
  std::minstd_rand random_{std::random_device{}()};
};

}  // namespace

struct Loop::Impl {
  Impl() {
    watch(wake.get(), [this] { drain(wake.get()); });
    watch(signals.get(), [this] { look_for_signals(); });
  }

  // A signal that waits would end the process as soon as it is no longer blocked.
  ~Impl() { look_for_signals(); }

  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void look_for_signals() noexcept {
    if (drain(signals.get())) stopped = true;
  }

  void watch(int descriptor, Handler handler) {
    epoll_event event{};
    event.events = EPOLLIN;
    event.data.fd = descriptor;
    opened(epoll_ctl(epoll.get(), EPOLL_CTL_ADD, descriptor, &event), "epoll_ctl");
    handlers[descriptor] = std::make_shared<Handler>(std::move(handler));
  }

  void call(int descriptor) {
    const auto found = handlers.find(descriptor);
    if (found == handlers.end()) return;                     // forgotten by a handler just before
    const std::shared_ptr<Handler> handler = found->second;  // it may forget itself
    (*handler)();
  }

  HeldSignals held;
  Descriptor epoll{opened(epoll_create1(EPOLL_CLOEXEC), "epoll_create1")};
  Descriptor wake{opened(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK), "eventfd")};
  Descriptor signals{make_signal_fd()};
  std::map<int, std::shared_ptr<Handler>> handlers;
  std::vector<std::unique_ptr<Descriptor>> timers;
  std::atomic<bool> stopped{false};
};

Loop::Loop() : impl_(std::make_unique<Impl>()) {}

Loop::~Loop() = default;

void Loop::on_readable(int descriptor, std::function<void()> handler) {
  impl_->watch(descriptor, std::move(handler));
}

void Loop::forget(int descriptor) {
  if (impl_->handlers.erase(descriptor) == 0) return;
  epoll_ctl(impl_->epoll.get(), EPOLL_CTL_DEL, descriptor, nullptr);
}

void Loop::every(Duration period, std::function<void()> handler, double jitter) {
  TEAMSIGHT_EXPECT(period > Duration{0} && jitter >= 0.0 && jitter < 1.0);
  const int timer =
      opened(timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC | TFD_NONBLOCK), "timerfd_create");
  impl_->timers.push_back(std::make_unique<Descriptor>(timer));
  const auto metronome = std::make_shared<Metronome>(timer, period, jitter);
  opened(metronome->start(), "timerfd_settime");
  impl_->watch(timer, [metronome, handler = std::move(handler)] {
    if (metronome->ticked()) handler();
  });
}

void Loop::run() {
  std::array<epoll_event, 16> events{};
  while (!impl_->stopped) {
    const int count =
        epoll_wait(impl_->epoll.get(), events.data(), static_cast<int>(events.size()), -1);
    for (int i = 0; i < count && !impl_->stopped; ++i) {
      impl_->call(events[static_cast<std::size_t>(i)].data.fd);
    }
  }
}

void Loop::stop() noexcept {
  impl_->stopped = true;
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = ::write(impl_->wake.get(), &one, sizeof one);
}

bool Loop::keeps_running() const noexcept {
  impl_->look_for_signals();
  return !impl_->stopped;
}

}  // namespace teamsight::bus
