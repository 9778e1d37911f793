// tests/network/switch.cpp: see switch.hpp.
#include "tests/network/switch.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <queue>
#include <random>
#include <thread>
#include <utility>

#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include "tests/network/rtps_frame.hpp"

namespace teamsight::network {
namespace {

using Clock = std::chrono::steady_clock;
using Address = std::array<std::uint8_t, 6>;
using Frame = std::shared_ptr<const std::vector<std::uint8_t>>;

constexpr std::size_t kLargestFrame = 2048;
// What a port may have waiting: more is what a real switch would drop as well.
constexpr std::size_t kLargestQueue = 20000;

struct Waiting {
  Clock::time_point due;
  std::uint64_t order{0};
  std::size_t port{0};
  Frame frame;

  bool operator<(const Waiting& other) const {
    return std::pair(other.due, other.order) < std::pair(due, order);
  }
};

}  // namespace

struct Switch::Impl {
  Impl(std::vector<int> descriptors, std::uint64_t seed)
      : taps(std::move(descriptors)),
        random(seed),
        groups(taps.size(), 0),
        is_cut(taps.size(), false),
        in_burst(taps.size() * taps.size(), false),
        counters(taps.size()),
        by_writer(taps.size()) {
    for (std::size_t port = 0; port < taps.size(); ++port) watch(taps[port], port);
    watch(wake, taps.size());
    thread = std::thread([this] { run(); });
  }

  ~Impl() {
    stopped = true;
    const std::uint64_t one = 1;
    [[maybe_unused]] const auto written = ::write(wake, &one, sizeof one);
    thread.join();
    for (const int tap : taps) ::close(tap);
    ::close(wake);
    ::close(epoll);
  }

  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  void watch(int descriptor, std::size_t port) const {
    epoll_event event{};
    event.events = EPOLLIN;
    event.data.u64 = port;
    epoll_ctl(epoll, EPOLL_CTL_ADD, descriptor, &event);
  }

  void run() {
    std::array<epoll_event, 32> events{};
    while (!stopped) {
      const int count =
          epoll_wait(epoll, events.data(), static_cast<int>(events.size()), patience_ms());
      const std::lock_guard lock(mutex);
      for (int i = 0; i < count; ++i) {
        const std::size_t port = events[static_cast<std::size_t>(i)].data.u64;
        if (port < taps.size()) take_all(port);
      }
      deliver_due();
    }
  }

  int patience_ms() {
    const std::lock_guard lock(mutex);
    if (waiting.empty()) return 100;
    const auto rest =
        std::chrono::ceil<std::chrono::milliseconds>(waiting.top().due - Clock::now());
    return static_cast<int>(std::clamp<std::int64_t>(rest.count(), 0, 100));
  }

  void take_all(std::size_t port) {
    std::array<std::uint8_t, kLargestFrame> buffer;
    for (;;) {
      const auto size = ::read(taps[port], buffer.data(), buffer.size());
      if (size < 14) return;
      take(port, std::vector<std::uint8_t>(buffer.begin(), buffer.begin() + size));
    }
  }

  void take(std::size_t from, std::vector<std::uint8_t> bytes) {
    ++counters[from].frames;
    counters[from].bytes += bytes.size();
    share_out(bytes.data(), bytes.size(), by_writer[from]);
    if (onlooker) onlooker(bytes.data(), bytes.size());
    const auto frame = std::make_shared<const std::vector<std::uint8_t>>(std::move(bytes));
    Address to{};
    Address source{};
    std::copy_n(frame->begin(), 6, to.begin());
    std::copy_n(frame->begin() + 6, 6, source.begin());
    known[source] = from;
    const auto found = known.find(to);
    for (std::size_t port = 0; port < taps.size(); ++port) {
      const bool is_meant = found == known.end() || found->second == port;
      if (port != from && is_meant) forward(from, port, frame);
    }
  }

  void forward(std::size_t from, std::size_t port, const Frame& frame) {
    if (groups[from] != groups[port] || is_cut[from] || is_cut[port]) return;
    const bool is_broadcast = std::all_of(
        frame->begin(), frame->begin() + 6, [](std::uint8_t byte) { return byte == 0xff; });
    const bool is_multicast = ((*frame)[0] & 1U) != 0 && !is_broadcast;
    if ((is_multicast && weather.drops_multicast) || is_lost(from, port)) return;
    const int copies = draw(weather.duplicated) ? 2 : 1;
    for (int i = 0; i < copies; ++i) send(port, frame);
  }

  bool is_lost(std::size_t from, std::size_t port) {
    bool burst = in_burst[from * taps.size() + port];
    burst = burst ? !draw(weather.burst_ends) : draw(weather.burst_begins);
    in_burst[from * taps.size() + port] = burst;
    return burst || draw(weather.loss);
  }

  bool draw(double probability) {
    return probability > 0.0 && std::uniform_real_distribution<double>()(random) < probability;
  }

  void send(std::size_t port, const Frame& frame) {
    std::chrono::microseconds delay = weather.delay;
    if (weather.jitter.count() > 0) {
      delay += std::chrono::microseconds(
          std::uniform_int_distribution<std::int64_t>(0, weather.jitter.count())(random));
    }
    if (delay.count() == 0) return hand_over(port, *frame);
    if (waiting.size() < kLargestQueue) {
      waiting.push({Clock::now() + delay, ++order, port, frame});
    }
  }

  void hand_over(std::size_t port, const std::vector<std::uint8_t>& frame) {
    if (::write(taps[port], frame.data(), frame.size()) < 0) return;  // the host's card is down
    ++counters[port].delivered;
    counters[port].bytes_delivered += frame.size();
  }

  void deliver_due() {
    while (!waiting.empty() && waiting.top().due <= Clock::now()) {
      hand_over(waiting.top().port, *waiting.top().frame);
      waiting.pop();
    }
  }

  std::vector<int> taps;
  int epoll{epoll_create1(EPOLL_CLOEXEC)};
  int wake{eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)};
  std::atomic<bool> stopped{false};
  std::mutex mutex;  // guards everything below
  std::mt19937_64 random;
  Weather weather;
  std::vector<int> groups;
  std::vector<bool> is_cut;
  std::vector<bool> in_burst;  // by (from, to)
  std::vector<PortCounters> counters;
  std::map<Address, std::size_t> known;
  BytesByWriter by_writer;
  std::function<void(const std::uint8_t*, std::size_t)> onlooker;
  std::priority_queue<Waiting> waiting;
  std::uint64_t order{0};
  std::thread thread;
};

Switch::Switch(std::vector<int> taps, std::uint64_t seed)
    : impl_(std::make_unique<Impl>(std::move(taps), seed)) {}

Switch::~Switch() = default;

void Switch::set_weather(const Weather& weather) {
  const std::lock_guard lock(impl_->mutex);
  impl_->weather = weather;
}

void Switch::set_groups(const std::vector<int>& groups) {
  const std::lock_guard lock(impl_->mutex);
  impl_->groups = groups;
}

void Switch::cut(std::size_t port, bool is_cut) {
  const std::lock_guard lock(impl_->mutex);
  impl_->is_cut.at(port) = is_cut;
}

PortCounters Switch::counters(std::size_t port) const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->counters.at(port);
}

BytesByWriter Switch::bytes_by_writer() const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->by_writer;
}

void Switch::mirror(std::function<void(const std::uint8_t*, std::size_t)> onlooker) {
  const std::lock_guard lock(impl_->mutex);
  impl_->onlooker = std::move(onlooker);
}

}  // namespace teamsight::network
