// bench/fusion.cpp: how long fusion works for one cycle of a team, by the number of robots.
//
// A cycle is one frame of each robot, in the order of arrival, and one world model. As many robots
// as the topics can name; bench-fusion-large is the same with room for more (bench/large_team.hpp).
#include "fusion/fusion.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "bench/play/play_log.hpp"
#include "bench/quantiles.hpp"
#include "process/program.hpp"

namespace teamsight::bench {
namespace {

/// This thread's computing time: what else runs on the machine does not count.
struct Clock {
  using time_point = std::chrono::nanoseconds;

  static time_point now() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
  }
};

struct Options {
  std::vector<int> robots = kMaxRobotId > 50 ? std::vector{5, 10, 20, 50}
                                             : std::vector{5, 10, static_cast<int>(kMaxRobotId)};
  int opponents{10};
  double seconds{10.0};
};

play::PlayLog log_of(int robots, const Options& options) {
  play::Scenario scenario;
  scenario.name = "growth";
  scenario.play.own = robots;
  scenario.play.opponents = options.opponents;
  return play::play_log(scenario, 1, options.seconds);
}

/// The first second, while tracks begin, is left out.
std::vector<Duration> measure(const play::PlayLog& log) {
  constexpr double kWarmUp = 1.0;  // s
  const auto robots = static_cast<std::size_t>(log.scenario.play.own);
  fusion::Fusion fusion(fusion::Parameters{}, play::play_field());
  std::vector<Duration> cycles;
  std::size_t tracks = 0;
  for (std::size_t first = 0; first + robots <= log.deliveries.size(); first += robots) {
    const auto start = Clock::now();
    for (std::size_t i = first; i < first + robots; ++i) {
      fusion.insert(log.observation(log.deliveries[i]), play::host_time(log.deliveries[i].arrival));
    }
    const double now = log.deliveries[first + robots - 1].arrival;
    tracks += fusion.world_at(play::host_time(now)).obstacles.size();
    const auto took = std::chrono::duration_cast<Duration>(Clock::now() - start);
    if (now > kWarmUp) cycles.push_back(took);
  }
  // Of a team that sees nothing there is nothing to measure.
  TEAMSIGHT_EXPECT(tracks > 0);
  return cycles;
}

void report(int robots, const std::vector<Duration>& cycles, double first_us) {
  const Quantiles quantiles = quantiles_of(cycles);
  const double over_first = quantiles.median_us / first_us;
  fmt::print("{{\"bench\":\"fusion\",\"robots\":{},{},\"over_first\":{:.2f}}}\n",
             robots,
             json_members(quantiles),
             over_first);
  fmt::print(
      stderr, "{:>2} robots        {} {:>8.2f}\n", robots, table_columns(quantiles), over_first);
}

int run(int argc, const char* const* argv) {
  Options options;
  CLI::App app("Measures how long fusion works for one frame of each robot and a world model.");
  app.add_option("--robots", options.robots, "team sizes; ratios are to the first")
      ->capture_default_str()
      ->check(CLI::Range(1, static_cast<int>(kMaxRobotId)));
  app.add_option("--opponents", options.opponents)->capture_default_str()->check(CLI::Range(0, 20));
  app.add_option("--seconds", options.seconds, "length of the made-up game")
      ->capture_default_str()
      ->check(CLI::Range(2.0, 600.0));
  if (const std::optional<int> done = process::parse_command_line(app, argc, argv)) {
    return *done;
  }
  fmt::print(stderr, "budget for 5 robots: 1 ms\n{:16} {} {:>8}\n", "", table_head(), "/ first");
  double first_us = 0.0;
  for (const int robots : options.robots) {
    const std::vector<Duration> cycles = measure(log_of(robots, options));
    if (first_us == 0.0) first_us = quantiles_of(cycles).median_us;
    report(robots, cycles, first_us);
  }
  return process::kDone;
}

}  // namespace
}  // namespace teamsight::bench

int main(int argc, char** argv) {
  return teamsight::process::run_program("bench-fusion",
                                         [&] { return teamsight::bench::run(argc, argv); });
}
