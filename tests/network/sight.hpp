// tests/network/sight.hpp: one line of what a host knew: a world model as it came in or was handed
// out.
#pragma once

#include <array>
#include <cstdint>

namespace teamsight::network {

/// Which way the world model came.
enum class Channel : std::uint8_t {
  kLeader,   ///< over the air, from the leading fusion
  kOwnHost,  ///< from the fusion on the same computer
  kChoice,   ///< what client::TeamWorld would have handed to a behaviour, asked 50 times a second
};

/// Fixed size, written as it lies in memory: the writer and the reader are the same build.
struct Sight {
  std::int64_t at_ns{0};  ///< monotonic clock of the test itself
  Channel channel{Channel::kLeader};
  std::uint8_t source{0};  ///< of a choice: client's Source
  std::uint8_t maker{0};   ///< robot id of the fusion; 0 = there was none
  std::uint8_t robots{0};  ///< bit r-1: robot r stands in it, seen within the last second
  std::uint32_t boot{0};
  std::uint32_t sequence{0};
  float age_ms{0.0F};          ///< between the moment it is about and now
  float ball_error_x_m{0.0F};  ///< against the truth at the moment it is about; NaN = no ball
  float ball_error_y_m{0.0F};
  float ball_var_m2{0.0F};                          ///< trace of its horizontal covariance
  std::uint32_t ball_track{0};                      ///< 0 = none
  std::array<std::uint32_t, 12> obstacle_tracks{};  ///< 0 = none
};

}  // namespace teamsight::network
