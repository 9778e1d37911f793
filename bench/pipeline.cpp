// bench/pipeline.cpp: listens to a running team on this computer and splits the way of its frames
// into stages.
#include <chrono>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "bench/quantiles.hpp"
#include "bench/stage_meter.hpp"
#include "bus/clock.hpp"
#include "bus/loop.hpp"
#include "bus/participant.hpp"
#include "bus/reader.hpp"
#include "process/domains.hpp"
#include "process/program.hpp"
#include "settings/load.hpp"

namespace teamsight::bench {
namespace {

struct Options {
  std::string team_file;
  process::DomainOptions domains;
  double seconds{20.0};
};

void report(const StageMeter& meter) {
  fmt::print(stderr, "{:<42} {}\n", "stage", table_head());
  for (std::size_t i = 0; i < kStages; ++i) {
    const auto stage = static_cast<Stage>(i);
    const Quantiles quantiles = quantiles_of(meter.of(stage));
    fmt::print(R"({{"bench":"pipeline","stage":"{}",{}}})"
               "\n",
               to_string(stage),
               json_members(quantiles));
    fmt::print(stderr, "{:<42} {}\n", to_string(stage), table_columns(quantiles));
  }
}

// Everything that has arrived on one topic goes to the meter.
template <class Message>
void drain(bus::Reader<Message>& reader, StageMeter& meter) {
  reader.take(bus::host_now(), [&](const bus::Sample<Message>& sample) {
    if (sample.message) {
      meter.add(*sample.message, sample.received);
    }
  });
}

StageMeter listen(const Options& options) {
  const settings::TeamSettings team = settings::load_team(options.team_file);
  const bus::Participant participant =
      bus::Participant::join(process::team_domain(team, options.domains));
  bus::Reader<bus::Sightings> sightings(participant);
  bus::Reader<WorldModel> worlds(participant);
  StageMeter meter;
  bus::Loop loop;
  loop.on_readable(sightings.event_fd(), [&] { drain(sightings, meter); });
  loop.on_readable(worlds.event_fd(), [&] { drain(worlds, meter); });
  loop.every(from_seconds(options.seconds), [&] { loop.stop(); });
  loop.run();
  return meter;
}

int run(int argc, char** argv) {
  Options options;
  CLI::App app{
      "Listens to a running team on this computer and splits the way of its frames into stages.",
      "bench-pipeline"};
  app.add_option("--team", options.team_file, "team file of the running team")->required();
  app.add_option("--team-domain", options.domains.team_domain, "instead of the team file's domain");
  app.add_option("--seconds", options.seconds, "how long to listen")->capture_default_str();
  if (const std::optional<int> done = process::parse_command_line(app, argc, argv)) {
    return *done;
  }
  const StageMeter meter = listen(options);
  report(meter);
  if (meter.of(Stage::kWhole).empty()) {
    fmt::print(stderr, "bench-pipeline: no frame was found in a world model\n");
    return process::kAnswerIsNo;
  }
  return process::kDone;
}

}  // namespace
}  // namespace teamsight::bench

int main(int argc, char** argv) {
  return teamsight::process::run_program("bench-pipeline",
                                         [&] { return teamsight::bench::run(argc, argv); });
}
