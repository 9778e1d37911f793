// monitor/main.cpp: the process `teamsight-monitor`: the team domain in, the coach's page out.
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

#include "bus/clock.hpp"
#include "bus/loop.hpp"
#include "bus/participant.hpp"
#include "bus/reader.hpp"
#include "bus/writer.hpp"
#include "monitor.pb.h"
#include "monitor/station.hpp"
#include "monitor/update_to_proto.hpp"
#include "monitor/web_files.hpp"
#include "monitor/web_server.hpp"
#include "process/domains.hpp"
#include "process/meter.hpp"
#include "process/program.hpp"
#include "settings/load.hpp"

namespace teamsight::monitor {
namespace {

// More is not seen, and costs every client.
constexpr Duration kUpdatePeriod = std::chrono::milliseconds(34);
constexpr Duration kDiagnosticsPeriod = std::chrono::seconds(1);

struct Options {
  std::filesystem::path team;
  std::filesystem::path field;  ///< empty: the team's
  std::filesystem::path web;    ///< empty: where it was installed
  std::string bind{"127.0.0.1"};
  std::uint16_t port{8080};
  process::DomainOptions domains;
  std::string match_tag;  ///< empty: no truth
};

/// Every topic that the station listens to.
struct Feeds {
  explicit Feeds(const bus::Participant& participant)
      : states(participant),
        sightings(participant),
        worlds(participant),
        explanations(participant),
        diagnostics(participant) {}

  void count(Station& station) const {
    station.count("RobotState", states.counters());
    station.count("Sightings", sightings.counters());
    station.count("WorldModel", worlds.counters());
    station.count("Explanation", explanations.counters());
    station.count("Diagnostics", diagnostics.counters());
  }

  bus::Reader<bus::RobotState> states;
  bus::Reader<bus::Sightings> sightings;
  bus::Reader<WorldModel> worlds;
  bus::Reader<bus::Explanation> explanations;
  bus::Reader<bus::Diagnostics> diagnostics;
};

template <class Message>
void pass_on(bus::Loop& loop, bus::Reader<Message>& reader, Station& station) {
  loop.on_readable(reader.event_fd(), [&reader, &station]() {
    reader.take(bus::host_now(), [&](const bus::Sample<Message>& sample) { station.hear(sample); });
  });
}

void pass_on(bus::Loop& loop, Feeds& feeds, Station& station) {
  pass_on(loop, feeds.states, station);
  pass_on(loop, feeds.sightings, station);
  pass_on(loop, feeds.worlds, station);
  pass_on(loop, feeds.explanations, station);
  pass_on(loop, feeds.diagnostics, station);
}

WebServerSettings web_settings(const Options& options, const settings::TeamSettings& team) {
  v1::MonitorUpdate greeting;
  to_proto(settings::load_field(options.field.empty() ? team.field : options.field),
           *greeting.mutable_field());
  greeting.set_team(team.name);
  greeting.set_domain_id(options.domains.team_domain.value_or(team.domain_id));
  greeting.set_station_version(TEAMSIGHT_VERSION);
  WebServerSettings web;
  web.bind = options.bind;
  web.port = options.port;
  web.files =
      load_web_files(find_web_folder(options.web, std::filesystem::read_symlink("/proc/self/exe")));
  web.greeting = greeting.SerializeAsString();
  return web;
}

void publish(WebServer& server, const Update& update) {
  v1::MonitorUpdate state;
  to_proto(update, state);
  v1::MonitorUpdate events;
  events_to_proto(update, events);
  server.publish({state.SerializeAsString(), events.SerializeAsString()});
}

void describe(process::ProcessMeter& meter, const WebServer& server) {
  const WebServerCounters counters = server.counters();
  meter.set("page.clients", counters.clients);
  meter.set("page.refused", counters.refused);
  meter.set("page.overrun", counters.overrun);
  meter.set("page.misbehaved", counters.misbehaved);
}

StationParameters station_parameters(const Options& options, const settings::TeamSettings& team) {
  StationParameters parameters;
  parameters.where = "domain " +
                     std::to_string(options.domains.team_domain.value_or(team.domain_id)) +
                     " of team \"" + team.name + "\"";
  return parameters;
}

/// The simulator's truth, where there is one on this computer.
struct TruthFeed {
  TruthFeed(const bus::DomainSettings& domain, const std::function<bool()>& keep_trying)
      : participant(bus::Participant::join(domain, keep_trying)),
        reader(participant) {}

  bus::Participant participant;
  bus::Reader<bus::Truth> reader;
};

int run(const Options& options) {
  const settings::TeamSettings team = settings::load_team(options.team);
  bus::Loop loop;  // before any thread is started: it takes over the signals
  WebServer server(web_settings(options, team));
  std::printf("{\"url\": \"%s\"}\n", server.url().c_str());
  std::fflush(stdout);
  const auto keep_trying = [&loop]() {
    return loop.keeps_running();
  };
  const bus::Participant participant =
      bus::Participant::join(process::team_domain(team, options.domains), keep_trying);
  Station station(station_parameters(options, team));
  Feeds feeds(participant);
  bus::Writer<bus::Diagnostics> diagnostics(participant);
  process::ProcessMeter meter("monitor", kNobody, process::draw_boot_id());
  std::optional<TruthFeed> truth;
  if (!options.match_tag.empty()) {
    truth.emplace(process::host_domain(team, options.domains, options.match_tag), keep_trying);
    pass_on(loop, truth->reader, station);
  }
  pass_on(loop, feeds, station);
  loop.every(kUpdatePeriod, [&]() {
    const process::StepTimer timer(meter);
    feeds.count(station);
    publish(server, station.update(bus::host_now()));
  });
  loop.every(kDiagnosticsPeriod, [&]() {
    describe(meter, server);
    diagnostics.write(meter.report(bus::host_now()));
  });
  loop.run();
  return process::kDone;
}

int start(int argc, char** argv) {
  Options options;
  CLI::App app{"The coach station: serves a page that shows the team's picture of the game.",
               "teamsight-monitor"};
  app.set_version_flag("--version", TEAMSIGHT_VERSION);
  app.add_option("--team", options.team, "team file (config/teams)")->required();
  app.add_option("--field", options.field, "field file instead of the team's");
  app.add_option("--port", options.port, "of the page; 0 takes a free one")->capture_default_str();
  app.add_option("--bind", options.bind, "address of this computer to serve the page on")
      ->capture_default_str();
  app.add_option("--team-domain", options.domains.team_domain, "DDS domain instead of the team's")
      ->check(CLI::Range(0, 229));
  app.add_option("--match-tag", options.match_tag, "tag of a simulated match: shows its truth");
  app.add_option("--web", options.web, "folder of the built page");
  if (const auto done = process::parse_command_line(app, argc, argv)) return *done;
  return run(options);
}

}  // namespace
}  // namespace teamsight::monitor

int main(int argc, char** argv) {
  return teamsight::process::run_program("teamsight-monitor",
                                         [&]() { return teamsight::monitor::start(argc, argv); });
}
