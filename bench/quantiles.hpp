// bench/quantiles.hpp: what is said of many measured durations.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/time.hpp"

namespace teamsight::bench {

/// Quantiles of a set of durations; microseconds. All 0 if the set is empty.
struct Quantiles {
  std::size_t count{0};
  double median_us{0.0};
  double p90_us{0.0};
  double p99_us{0.0};
  double max_us{0.0};
};

/// Sorts a copy and reads the quantiles off (nearest rank).
[[nodiscard]] Quantiles quantiles_of(std::vector<Duration> durations);

/// As the members of a JSON object, without the braces.
[[nodiscard]] std::string json_members(const Quantiles& quantiles);

/// As the columns count, median, p90, p99 and largest of a table.
[[nodiscard]] std::string table_columns(const Quantiles& quantiles);

/// The head over `table_columns`.
[[nodiscard]] std::string table_head();

}  // namespace teamsight::bench
