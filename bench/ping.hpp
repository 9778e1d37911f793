// bench/ping.hpp: one message to another process and back, in several ways that can be compared.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/time.hpp"

namespace teamsight::bench {

/// What one run of pings does; both processes are given the same plan.
struct PingPlan {
  std::uint32_t domain_id{0};
  std::string profile_path;   ///< Cyclone DDS XML file
  std::uint16_t udp_port{0};  ///< of the echo, on the loopback interface
  std::size_t count{0};       ///< round trips to measure, after the warm-up
  Duration pause{0};          ///< between two round trips; 0 = none
};

struct PingResult {
  std::vector<Duration> round_trips;
  std::size_t lost{0};  ///< no answer within kAnswerWithin
};

inline constexpr Duration kAnswerWithin = std::chrono::milliseconds(100);

/// Answered pings before the measurement begins.
inline constexpr std::size_t kWarmUp = 100;

/// What a ping carries: Sightings with so many of each.
inline constexpr std::size_t kPingBalls = 1;
inline constexpr std::size_t kPingObstacles = 8;

/// The bytes of such a sample in XCDR1, as idl/teamsight.idl lays it out: 88 up to the balls, 49
/// the ball, 7 to the obstacles, 28 each but for the last one's padding.
inline constexpr std::size_t kPingBytes = 88 + 49 + 7 + 8 * 28 - 2;

/// One way to send a ping. `ping` measures; `echo` answers until the process is ended.
struct PingMethod {
  std::string_view name;
  PingResult (*ping)(const PingPlan& plan);
  void (*echo)(const PingPlan& plan);
};

/// As many bytes through a UDP socket, blocking.
[[nodiscard]] PingResult ping_udp(const PingPlan& plan);
void echo_udp(const PingPlan& plan);

/// The same sample through the bare Cyclone DDS C API, best effort, woken by a waitset.
[[nodiscard]] PingResult ping_cyclone_waitset(const PingPlan& plan);
void echo_cyclone_waitset(const PingPlan& plan);

/// The same, answered and noticed in the library's own receive thread.
[[nodiscard]] PingResult ping_cyclone_listener(const PingPlan& plan);
void echo_cyclone_listener(const PingPlan& plan);

/// The same sample through bus/: conversion and validation on both sides, as our processes do it.
[[nodiscard]] PingResult ping_bus(const PingPlan& plan);
void echo_bus(const PingPlan& plan);

/// All of them; the bare Cyclone ping is what the others are compared with.
inline constexpr std::array<PingMethod, 4> kPingMethods{{
    {"udp", ping_udp, echo_udp},
    {"cyclone_waitset", ping_cyclone_waitset, echo_cyclone_waitset},
    {"cyclone_listener", ping_cyclone_listener, echo_cyclone_listener},
    {"bus", ping_bus, echo_bus},
}};

/// Runs warm-up and measurement.
///
/// @param send_and_wait  sends one ping; returns whether its answer came within kAnswerWithin
/// @throws std::runtime_error if nobody answers during the warm-up
[[nodiscard]] PingResult run_pings(const PingPlan& plan,
                                   const std::function<bool()>& send_and_wait);

}  // namespace teamsight::bench
