// sim/frame_rate.cpp: see frame_rate.hpp.
#include "sim/frame_rate.hpp"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <memory>
#include <system_error>

#include <fmt/format.h>
#include <sys/mman.h>

#include "geometry/expect.hpp"

namespace teamsight::sim {

Duration time_to_draw(const Setup& setup, Eye& eye) {
  constexpr int kMoments = 11;
  Match match(setup.parameters, setup.field);
  Random random(1);
  Scene scene;
  std::vector<std::uint8_t> picture;
  std::vector<Duration> draws;
  for (int moment = 0; moment <= kMoments; ++moment) {
    match.advance_to(0.5 * moment);
    show(match.state(), 0, eye.bodies, scene);
    const auto start = std::chrono::steady_clock::now();
    eye.renderer.draw(scene, random, picture);
    draws.push_back(std::chrono::duration_cast<Duration>(std::chrono::steady_clock::now() - start));
  }
  draws.erase(draws.begin());  // which brought the tables into the caches
  const auto middle = draws.begin() + kMoments / 2;
  std::nth_element(draws.begin(), middle, draws.end());
  return *middle;
}

double rate_that_holds(Duration draw, std::size_t cameras, unsigned cores) {
  TEAMSIGHT_EXPECT(draw > Duration{} && cameras > 0 && cores > 0);
  const double rate = kDrawingShare * cores / (to_seconds(draw) * static_cast<double>(cameras));
  return std::clamp(std::floor(rate), kSlowestRate, kFastestRate);
}

struct FrameTally::Entry {
  std::atomic<std::uint64_t> due{0};
  std::atomic<std::uint64_t> taken{0};
};

static_assert(std::atomic<std::uint64_t>::is_always_lock_free, "or processes could not share it");

FrameTally::FrameTally(std::size_t cameras) : cameras_(cameras) {
  TEAMSIGHT_EXPECT(cameras > 0);
  void* memory = ::mmap(
      nullptr, cameras * sizeof(Entry), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) {
    throw std::system_error(errno, std::generic_category(), "memory for the count of frames");
  }
  entries_ = static_cast<Entry*>(memory);
  std::uninitialized_default_construct_n(entries_, cameras);
}

FrameTally::~FrameTally() {
  ::munmap(entries_, cameras_ * sizeof(Entry));
}

void FrameTally::set(std::size_t camera, const FrameCount& count) noexcept {
  TEAMSIGHT_EXPECT(camera < cameras_);
  entries_[camera].due.store(count.due, std::memory_order_relaxed);
  entries_[camera].taken.store(count.taken, std::memory_order_relaxed);
}

FrameCount FrameTally::of(std::size_t camera) const noexcept {
  TEAMSIGHT_EXPECT(camera < cameras_);
  return {entries_[camera].due.load(std::memory_order_relaxed),
          entries_[camera].taken.load(std::memory_order_relaxed)};
}

RateJudge::RateJudge(std::size_t cameras, double rate_hz) : rate_hz_(rate_hz), before_(cameras) {
  TEAMSIGHT_EXPECT(rate_hz > 0.0);
}

std::optional<std::string> RateJudge::judge(const FrameTally& tally, double seconds) {
  TEAMSIGHT_EXPECT(seconds > 0.0 && tally.cameras() == before_.size());
  constexpr double kWhole = 0.9;  // of a window's frames: the camera was read nearly all the time
  std::optional<double> slowest;  // share
  for (std::size_t camera = 0; camera < before_.size(); ++camera) {
    const FrameCount now = tally.of(camera);
    const auto due = static_cast<double>(now.due - before_[camera].due);
    const auto taken = static_cast<double>(now.taken - before_[camera].taken);
    before_[camera] = now;
    if (due >= kWhole * rate_hz_ * seconds) {
      slowest = std::min(slowest.value_or(1.0), taken / due);
    }
  }
  if (!slowest.has_value() || held_ == (*slowest >= kHeld)) {
    return std::nullopt;
  }
  held_ = *slowest >= kHeld;
  return fmt::format("{} {:.1f} of {:g} Hz{}",
                     *held_ ? "hold" : "do not hold their rate:",
                     *slowest * rate_hz_,
                     rate_hz_,
                     *held_ ? "" : "; this computer has too much to do");
}

}  // namespace teamsight::sim
