// tests/network/judge.cpp: see judge.hpp.
#include "tests/network/judge.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace teamsight::network {
namespace {

constexpr float kFresh_ms = 300.0F;

double ms(std::int64_t ns) {
  return 1e-6 * static_cast<double>(ns);
}

void judge_air(const std::vector<Sight>& sights, const Interval& interval, Knowledge& out) {
  struct Run {
    std::uint32_t first{0};
    std::uint32_t last{0};
    std::uint32_t heard{0};
  };

  std::map<std::uint32_t, Run> runs;  // by boot of the leader
  std::int64_t before = interval.from_ns;
  std::vector<double> ages;
  for (const Sight& sight : sights) {
    if (sight.channel != Channel::kLeader || !interval.holds(sight.at_ns)) continue;
    out.leaders.insert(sight.maker);
    out.air_gap_ms = std::max(out.air_gap_ms, ms(sight.at_ns - before));
    before = sight.at_ns;
    ages.push_back(static_cast<double>(sight.age_ms));
    Run& run = runs.try_emplace(sight.boot, Run{sight.sequence, sight.sequence, 0}).first->second;
    run.last = std::max(run.last, sight.sequence);
    ++run.heard;
  }
  out.air_gap_ms = std::max(out.air_gap_ms, ms(interval.to_ns - before));
  if (!ages.empty()) {
    const auto middle = ages.begin() + static_cast<std::ptrdiff_t>(ages.size() / 2);
    std::nth_element(ages.begin(), middle, ages.end());
    out.air_age_ms = *middle;
  }
  double sent = 0.0;
  double heard = 0.0;
  for (const auto& [boot, run] : runs) {
    sent += run.last - run.first + 1U;
    heard += run.heard;
  }
  out.air_share = sent > 0.0 ? heard / sent : 0.0;
}

void judge_choices(const std::vector<Sight>& sights, const Interval& interval, Knowledge& out) {
  double asked = 0.0;
  double served = 0.0;
  double balls = 0.0;
  double error = 0.0;
  double variance = 0.0;
  for (const Sight& sight : sights) {
    if (sight.channel != Channel::kChoice || !interval.holds(sight.at_ns)) continue;
    ++asked;
    if (sight.maker == 0) continue;
    out.robots = sight.robots;
    out.oldest_ms = std::max(out.oldest_ms, static_cast<double>(sight.age_ms));
    if (is_fresh(sight)) ++served;
    if (std::isnan(sight.ball_error_x_m)) continue;
    ++balls;
    const double x = static_cast<double>(sight.ball_error_x_m);
    const double y = static_cast<double>(sight.ball_error_y_m);
    error += x * x + y * y;
    variance += static_cast<double>(sight.ball_var_m2);
  }
  if (asked > 0.0) out.served = served / asked;
  if (balls > 0.0) {
    out.ball_rmse_m = std::sqrt(error / balls);
    out.ball_bound_m = std::sqrt(variance / balls);
  }
}

}  // namespace

bool is_fresh(const Sight& sight) {
  return sight.maker != 0 && sight.age_ms <= kFresh_ms;
}

Knowledge knowledge_of(const std::vector<Sight>& sights, const Interval& interval) {
  Knowledge out;
  judge_air(sights, interval, out);
  judge_choices(sights, interval, out);
  const auto own = std::count_if(sights.begin(), sights.end(), [&](const Sight& sight) {
    return sight.channel == Channel::kOwnHost && interval.holds(sight.at_ns);
  });
  out.own_rate_hz = 1e3 * static_cast<double>(own) / ms(interval.to_ns - interval.from_ns);
  return out;
}

std::optional<std::int64_t> first(const std::vector<Sight>& sights,
                                  Channel channel,
                                  std::int64_t from_ns,
                                  const Claim& claim) {
  const auto found = std::find_if(sights.begin(), sights.end(), [&](const Sight& sight) {
    return sight.channel == channel && sight.at_ns >= from_ns && claim(sight);
  });
  return found == sights.end() ? std::nullopt : std::optional(found->at_ns);
}

std::optional<std::int64_t> settled(const std::vector<Sight>& sights,
                                    Channel channel,
                                    std::int64_t from_ns,
                                    const Claim& claim) {
  std::optional<std::int64_t> since;
  for (const Sight& sight : sights) {
    if (sight.channel != channel || sight.at_ns < from_ns) continue;
    if (!claim(sight)) {
      since.reset();
    } else if (!since) {
      since = sight.at_ns;
    }
  }
  return since;
}

}  // namespace teamsight::network
