// monitor/main.cpp: the process `teamsight-monitor`: the team domain in, the coach's page out.
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

#include "bus/clock.hpp"
#include "bus/loop.hpp"
#include "bus/participant.hpp"
#include "bus/reader.hpp"
#include "bus/writer.hpp"
#include "monitor.pb.h"
#include "monitor/feeds.hpp"
#include "monitor/operator.hpp"
#include "monitor/order_desk.hpp"
#include "monitor/own_hearing.hpp"
#include "monitor/recording_feed.hpp"
#include "monitor/referee/referee.hpp"
#include "monitor/replay.hpp"
#include "monitor/secret.hpp"
#include "monitor/station.hpp"
#include "monitor/update_to_proto.hpp"
#include "monitor/web_files.hpp"
#include "monitor/web_server.hpp"
#include "monitor/what_if.hpp"
#include "process/air_share.hpp"
#include "process/domains.hpp"
#include "process/elsewhere.hpp"
#include "process/meter.hpp"
#include "process/program.hpp"
#include "process/supervision.hpp"
#include "recording/recorder.hpp"
#include "settings/load.hpp"

namespace teamsight::monitor {
namespace {

// A new world goes out at once, but not more often than this: more is not seen, and costs every
// client. Without one the rest is still news. A fusion's 30 Hz, with its jitter, lies between.
constexpr Duration kShortestPause = std::chrono::milliseconds(25);
constexpr Duration kLongestPause = std::chrono::milliseconds(50);
constexpr Duration kPaceCheck = std::chrono::milliseconds(10);
constexpr Duration kAway = std::chrono::milliseconds(200);
constexpr Duration kDiagnosticsPeriod = std::chrono::seconds(1);
constexpr Duration kRepeatPeriod = std::chrono::milliseconds(100);

struct Options {
  std::filesystem::path team;
  std::filesystem::path field;  ///< empty: the team's
  std::filesystem::path web;    ///< empty: where it was installed
  std::string bind{"127.0.0.1"};
  std::uint16_t port{8080};
  process::DomainOptions domains;
  std::string match_tag;         ///< empty: no truth
  std::filesystem::path record;  ///< folder; empty: nothing is recorded
  std::uint64_t record_max_megabytes{1024};
  std::filesystem::path replay;  ///< a recording; empty: the present
  std::string box;               ///< ADDRESS or ADDRESS:PORT; empty: no referee box
  std::string own_address;
  std::filesystem::path token_file;  ///< empty: a token is drawn
};

/// The token of a file's first line, or a new one.
std::string token_of(const Options& options) {
  if (options.token_file.empty()) return draw_token();
  std::ifstream file(options.token_file);
  std::string token;
  std::getline(file, token);
  if (token.size() < 16) {
    throw std::runtime_error("--token-file: " + options.token_file.string() +
                             " holds no token, expected a first line of at least 16 characters");
  }
  return token;
}

bool is_this_computer_only(const std::string& bind) {
  return bind.starts_with("127.") || bind == "::1";
}

FieldModel field_of(const Options& options, const settings::TeamSettings& team) {
  return settings::load_field(options.field.empty() ? team.field : options.field);
}

WebServerSettings web_settings(const Options& options,
                               const settings::TeamSettings& team,
                               const std::string& token,
                               v1::MonitorUpdate greeting = {}) {
  to_proto(field_of(options, team), *greeting.mutable_field());
  if (greeting.team().empty()) greeting.set_team(team.name);
  greeting.set_domain_id(options.domains.team_domain.value_or(team.domain_id));
  greeting.set_station_version(TEAMSIGHT_VERSION);
  WebServerSettings web;
  web.bind = options.bind;
  web.port = options.port;
  web.files =
      load_web_files(find_web_folder(options.web, std::filesystem::read_symlink("/proc/self/exe")));
  web.greeting = greeting.SerializeAsString();
  web.name = "teamsight " + team.name;
  web.session = std::to_string(process::draw_boot_id());
  web.token = token;
  if (!is_this_computer_only(options.bind)) web.watch_token = token;
  return web;
}

Update update_at(
    HostTime now, Station& station, Recording& recording, Referee& referee, OrderDesk& desk) {
  auto recorder = recording.report(station, now);
  Update update = station.update(now);
  update.recorder = std::move(recorder);
  update.referee = referee.report(now);
  update.actions = desk.report(now);
  return update;
}

void publish(WebServer& server, Recording& recording, const Update& update) {
  v1::MonitorUpdate state;
  to_proto(update, state);
  v1::MonitorUpdate events;
  events_to_proto(update, events);
  v1::MonitorUpdate pictures;
  thumbnails_to_proto(update, pictures);
  std::string encoded = events.SerializeAsString();
  recording.add_events(update, encoded);
  server.publish({state.SerializeAsString(), std::move(encoded), pictures.SerializeAsString()});
}

/// Whether it is time for an update.
class Pace {
 public:
  /// Is it at least `pause` since the last time that this was true?
  ///
  /// Not when nobody asked for so long that this process must have stood still: what came meanwhile
  /// is to be heard first, or everybody else would seem to be silent.
  bool is_due(HostTime now, Duration pause) {
    const HostTime before = std::exchange(asked_, now);
    const bool was_away = before != HostTime{} && now - before > kAway;
    if (was_away || now - last_ < pause) return false;
    last_ = now;
    return true;
  }

 private:
  HostTime last_;
  HostTime asked_;
};

process::ProcessMeter& described(process::ProcessMeter& meter, const WebServer& server) {
  const WebServerCounters counters = server.counters();
  meter.set("page.clients", counters.clients);
  meter.set("page.refused", counters.refused);
  meter.set("page.overrun", counters.overrun);
  meter.set("page.misbehaved", counters.misbehaved);
  meter.set("viewers", counters.viewers);
  meter.set("viewers.dropped", counters.viewer_dropped);
  return meter;
}

StationParameters station_parameters(const Options& options,
                                     const settings::TeamSettings& team,
                                     std::uint32_t boot) {
  StationParameters parameters;
  parameters.boot = boot;
  parameters.version = TEAMSIGHT_VERSION;
  parameters.where = "domain " +
                     std::to_string(options.domains.team_domain.value_or(team.domain_id)) +
                     " of team \"" + team.name + "\"";
  return parameters;
}

fusion::Parameters fusion_parameters(const settings::TeamSettings& team) {
  fusion::Parameters parameters;
  parameters.ball_radius = team.ball_radius;
  parameters.robot_radius = team.robot_radius;
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

std::unique_ptr<TruthFeed> truth_of(const Options& options,
                                    const settings::TeamSettings& team,
                                    const std::function<bool()>& keep_trying) {
  if (options.match_tag.empty()) return nullptr;
  return std::make_unique<TruthFeed>(process::host_domain(team, options.domains, options.match_tag),
                                     keep_trying);
}

std::optional<BoxAddress> box_of(const Options& options) {
  if (options.box.empty()) return std::nullopt;
  BoxAddress address;
  const auto colon = options.box.find(':');
  address.host = options.box.substr(0, colon);
  if (colon == std::string::npos) return address;
  const std::string port = options.box.substr(colon + 1);
  const bool is_number = !port.empty() && port.size() <= 5 &&
                         port.find_first_not_of("0123456789") == std::string::npos;
  const unsigned long value = is_number ? std::stoul(port) : 0;
  if (value == 0 || value > 65'535) {
    throw std::runtime_error("--box: port \"" + port + "\", expected 1 to 65535");
  }
  address.port = static_cast<std::uint16_t>(value);
  return address;
}

RefereeSettings referee_settings(const Options& options,
                                 const settings::TeamSettings& team,
                                 std::uint32_t boot) {
  return {box_of(options), options.own_address, team.name, boot};
}

std::optional<recording::RecorderSettings> recorder_settings(const Options& options,
                                                             const settings::TeamSettings& team) {
  if (options.record.empty()) return std::nullopt;
  recording::RecorderSettings settings;
  settings.folder = options.record;
  settings.name = team.name;
  settings.library = "teamsight " TEAMSIGHT_VERSION;
  settings.facts = {{"team", team.name}, {"field", team.field.filename().string()}};
  settings.max_file_bytes = options.record_max_megabytes << 20U;
  return settings;
}

/// Where the page is; "open" can be followed at once, as the token stands in it.
void say_address(const WebServer& server, const std::string& token) {
  std::printf("{\"url\": \"%s\", \"open\": \"%s#token=%s\"}\n",
              server.url().c_str(),
              server.url().c_str(),
              token.c_str());
  std::fflush(stdout);
}

/// Shows a recording instead of the present: no domain is joined, nothing is written.
int run_replay(const Options& options) {
  constexpr const char* kPath = "/recording.bin";
  const settings::TeamSettings team = settings::load_team(options.team);
  const std::string token = token_of(options);
  bus::Loop loop;
  StationParameters parameters = station_parameters(options, team, process::draw_boot_id());
  parameters.version.clear();  // a recording may be of any
  Replay replay = load_replay(options.replay, parameters);
  if (!replay.damage.empty()) {
    std::fprintf(stderr,
                 "teamsight-monitor: %s: %s; what stands before is shown\n",
                 options.replay.c_str(),
                 replay.damage.c_str());
  }
  v1::MonitorUpdate greeting;
  greeting.set_recording(kPath);
  greeting.set_team(replay.team);
  greeting.set_date_minus_stamp_ns(replay.date_minus_stamp.count());
  WebServerSettings web = web_settings(options, team, token, greeting);
  web.viewer_notice = "this station shows a recording: open the file itself";
  web.files[kPath] = {"application/octet-stream", std::move(replay.body), true};
  WebServer server(std::move(web));
  server.publish({});  // the greeting goes out with the first state
  say_address(server, token);
  loop.run();
  return process::kDone;
}

/// Orders that are not acknowledged go out again; robots that leave all of them unanswered are told
/// of.
void repeat(Operator& oper, const OrderDesk& desk, const Station& station, OwnHearing& hearing) {
  oper.repeat();
  hearing.note_unanswered(desk.unanswered_by(station.alive(), bus::host_now()));
}

/// The robots' time, and who else is on this network.
void ask_around(const Feeds& feeds, Words& words, process::Elsewhere& elsewhere, Station& station) {
  const HostTime now = bus::host_now();
  words.probes.write(station.next_probe(now));
  station.note_versions(feeds.others.present(), now);
  station.note_domains(elsewhere.others(!station.alive().empty(), now));
}

int run(const Options& options) {
  const settings::TeamSettings team = settings::load_team(options.team);
  const std::string token = token_of(options);
  const std::uint32_t boot = process::draw_boot_id();
  bus::Loop loop;  // before any thread is started: it takes over the signals
  WebServer server(web_settings(options, team, token));
  Recording recording(recorder_settings(options, team), server);
  const auto goes_on = [&loop]() {
    return loop.keeps_running();
  };
  auto participant = bus::Participant::join(process::team_domain(team, options.domains), goes_on);
  say_address(server, token);  // who cannot join ends, and has promised no page
  Station station(station_parameters(options, team, boot));
  OrderDesk desk(boot);
  Feeds feeds(participant);
  Words words(participant);
  process::ProcessMeter meter("monitor", kNobody, boot);
  process::AirShare air(participant, "monitor");
  const FieldModel field = field_of(options, team);
  OwnHearing hearing(participant, feeds, loop);
  process::Elsewhere elsewhere(team, options.domains);
  recording.attach(participant, loop);
  Referee referee(referee_settings(options, team, boot), participant, loop, station);
  WhatIf what_if(fusion_parameters(team), field);
  Operator oper({server, station, desk, referee, what_if, words.commands});
  const auto truth = truth_of(options, team, goes_on);
  if (truth) {
    pass_on(loop, truth->reader, station);
    recording.add_truth(truth->participant);
  }
  pass_on(loop, feeds, station, desk, what_if);
  loop.on_readable(server.event_fd(), [&]() { oper.listen(token); });
  loop.every(kRepeatPeriod, [&]() { repeat(oper, desk, station, hearing); });
  Pace pace;
  const auto tell = [&](Duration pause) {
    const HostTime now = bus::host_now();
    if (!pace.is_due(now, pause)) return;
    const process::StepTimer timer(meter);
    feeds.count(station);
    Update update = update_at(now, station, recording, referee, desk);
    update.without = what_if.at(now);
    publish(server, recording, update);
  };
  loop.on_readable(feeds.worlds.event_fd(), [&]() {
    take(feeds.worlds, station, what_if);
    tell(kShortestPause);
  });
  loop.every(kPaceCheck, [&]() { tell(kLongestPause); });
  loop.every(kDiagnosticsPeriod, [&]() {
    ask_around(feeds, words, elsewhere, station);
    bus::Diagnostics report = hearing.report(described(meter, server), station, bus::host_now());
    air.tell(report);
    words.diagnostics.write(report);
    recording.draw(field, bus::host_now());
  });
  air.attach(loop);
  process::report_to_supervisor(loop);
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
  app.add_option("--record", options.record, "folder: records everything into MCAP files there");
  app.add_option(
         "--record-max-megabytes", options.record_max_megabytes, "a new file begins after so many")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--replay", options.replay, "MCAP file: shows it instead of the present");
  app.add_option("--box", options.box, "referee box: ADDRESS or ADDRESS:PORT (28097)");
  app.add_option("--own-address",
                 options.own_address,
                 "our multicast address in the box's commands; else its WELCOME tells it");
  app.add_option("--token-file",
                 options.token_file,
                 "file with the token that orders need; else one is drawn");
  if (const auto done = process::parse_command_line(app, argc, argv)) return *done;
  return options.replay.empty() ? run(options) : run_replay(options);
}

}  // namespace
}  // namespace teamsight::monitor

int main(int argc, char** argv) {
  return teamsight::process::run_program("teamsight-monitor",
                                         [&]() { return teamsight::monitor::start(argc, argv); });
}
