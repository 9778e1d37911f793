// sim/frame_rate.hpp: how often this computer can draw what all cameras see, and whether it does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geometry/time.hpp"
#include "sim/setup.hpp"

namespace teamsight::sim {

/// A live match is drawn between these; Hz.
inline constexpr double kSlowestRate = 5.0;
inline constexpr double kFastestRate = 25.0;

/// Share of the computer that drawing may take: agents, fusions, coach station and a page that is
/// looked at need the rest (`bench/README.md` has what they take).
inline constexpr double kDrawingShare = 0.3;

/// How long one frame of the match takes to be drawn here and now: the median of a few moments of
/// its first seconds.
[[nodiscard]] Duration time_to_draw(const Setup& setup, Eye& eye);

/// The rate at which so many cameras can be drawn on so many cores within kDrawingShare.
///
/// @param draw  for one frame, positive
/// @return a whole number from kSlowestRate to kFastestRate; Hz
[[nodiscard]] double rate_that_holds(Duration draw, std::size_t cameras, unsigned cores);

/// Frames of one camera since its start, of the times in which somebody read them.
struct FrameCount {
  std::uint64_t due{0};
  std::uint64_t taken{0};
};

/// Counts of all cameras, in memory that a process shares with those that it forks after this.
///
/// Each camera is written by one process; any reads.
class FrameTally {
 public:
  /// @throws std::system_error if there is no memory
  explicit FrameTally(std::size_t cameras);
  ~FrameTally();
  FrameTally(const FrameTally&) = delete;
  FrameTally& operator=(const FrameTally&) = delete;

  /// @pre camera < the number of cameras
  void set(std::size_t camera, const FrameCount& count) noexcept;
  [[nodiscard]] FrameCount of(std::size_t camera) const noexcept;

  [[nodiscard]] std::size_t cameras() const { return cameras_; }

 private:
  struct Entry;

  std::size_t cameras_;
  Entry* entries_{nullptr};
};

/// Whether the cameras hold their rate, judged over windows of time.
class RateJudge {
 public:
  /// A rate holds if so much of it is reached by the slowest camera.
  static constexpr double kHeld = 0.95;

  /// @param rate_hz  that is asked for
  RateJudge(std::size_t cameras, double rate_hz);

  /// The next window's end.
  ///
  /// @param seconds  since the last one, positive
  /// @return what to tell the operator: the first judgement, and each that differs from the one
  ///         before; nothing as well while no camera was read for the whole window
  [[nodiscard]] std::optional<std::string> judge(const FrameTally& tally, double seconds);

 private:
  double rate_hz_;
  std::vector<FrameCount> before_;
  std::optional<bool> held_;
};

}  // namespace teamsight::sim
