// bench/quantiles.cpp: see quantiles.hpp.
#include "bench/quantiles.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

namespace teamsight::bench {
namespace {

double microseconds(Duration duration) {
  return std::chrono::duration<double, std::micro>(duration).count();
}

double at_rank(const std::vector<Duration>& sorted, double share) {
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
  return microseconds(sorted[std::max<std::size_t>(rank, 1) - 1]);
}

}  // namespace

Quantiles quantiles_of(std::vector<Duration> durations) {
  if (durations.empty()) {
    return {};
  }
  std::sort(durations.begin(), durations.end());
  return {durations.size(),
          at_rank(durations, 0.5),
          at_rank(durations, 0.9),
          at_rank(durations, 0.99),
          microseconds(durations.back())};
}

std::string json_members(const Quantiles& q) {
  return fmt::format(
      R"("count":{},"median_us":{:.1f},"p90_us":{:.1f},"p99_us":{:.1f},"max_us":{:.1f})",
      q.count,
      q.median_us,
      q.p90_us,
      q.p99_us,
      q.max_us);
}

std::string table_columns(const Quantiles& q) {
  return fmt::format("{:>8} {:>10.1f} {:>10.1f} {:>10.1f} {:>10.1f}",
                     q.count,
                     q.median_us,
                     q.p90_us,
                     q.p99_us,
                     q.max_us);
}

std::string table_head() {
  return fmt::format(
      "{:>8} {:>10} {:>10} {:>10} {:>10}", "count", "median us", "p90 us", "p99 us", "max us");
}

}  // namespace teamsight::bench
