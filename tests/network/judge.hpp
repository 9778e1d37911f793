// tests/network/judge.hpp: figures out of what a host knew. Plain functions of its sights.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <vector>

#include "geometry/identity.hpp"
#include "tests/network/sight.hpp"

namespace teamsight::network {

/// From and to, as Sight::at_ns counts.
struct Interval {
  std::int64_t from_ns{0};
  std::int64_t to_ns{0};

  [[nodiscard]] bool holds(std::int64_t at_ns) const { return at_ns >= from_ns && at_ns < to_ns; }
};

/// What one host knew during an interval.
struct Knowledge {
  double served{0.0};       ///< share of a behaviour's questions that got a model of at most 300 ms
  double oldest_ms{0.0};    ///< age of the oldest model that a behaviour got
  double own_rate_hz{0.0};  ///< models of the own host's fusion
  double air_share{0.0};    ///< of the leaders' models over the air, those that arrived
  double air_gap_ms{0.0};   ///< longest time without one
  double air_age_ms{0.0};   ///< median age of the leaders' models when they arrived
  double ball_rmse_m{0.0};  ///< of what a behaviour got, against the truth
  double ball_bound_m{0.0};  ///< root of the mean variance that the models themselves name
  std::set<int> leaders;     ///< whose models came over the air
  std::uint8_t robots{0};    ///< in the last model that a behaviour got
};

[[nodiscard]] Knowledge knowledge_of(const std::vector<Sight>& sights, const Interval& interval);

using Claim = std::function<bool(const Sight&)>;

/// When the claim about this channel first held at or after `from_ns`; nothing: never.
[[nodiscard]] std::optional<std::int64_t> first(const std::vector<Sight>& sights,
                                                Channel channel,
                                                std::int64_t from_ns,
                                                const Claim& claim);

/// From when on the claim held for good, at or after `from_ns`; nothing: it does not at the end.
[[nodiscard]] std::optional<std::int64_t> settled(const std::vector<Sight>& sights,
                                                  Channel channel,
                                                  std::int64_t from_ns,
                                                  const Claim& claim);

/// A choice that is worth something to a behaviour: a model of at most 300 ms.
[[nodiscard]] bool is_fresh(const Sight& sight);

}  // namespace teamsight::network
