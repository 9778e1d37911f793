// tools/log_record.cpp: `teamsight log record`.
#include <cstdio>
#include <memory>
#include <optional>

#include "bus/clock.hpp"
#include "bus/loop.hpp"
#include "bus/participant.hpp"
#include "process/program.hpp"
#include "recording/bus_recorder.hpp"
#include "recording/recorder.hpp"
#include "settings/load.hpp"
#include "tools/log_actions.hpp"

namespace teamsight::tools {
namespace {

recording::RecorderSettings recorder_settings(const LogRecord& request,
                                              const settings::TeamSettings& team) {
  recording::RecorderSettings settings;
  settings.folder = request.out;
  settings.name = team.name;
  settings.library = "teamsight " TEAMSIGHT_VERSION;
  settings.facts = {{"team", team.name}, {"field", team.field.filename().string()}};
  settings.max_file_bytes = request.max_megabytes << 20U;
  return settings;
}

int finish(const recording::RecorderReport& report) {
  std::printf("{\"messages\": %llu, \"bytes\": %llu, \"dropped\": %llu}\n",
              static_cast<unsigned long long>(report.messages),
              static_cast<unsigned long long>(report.bytes),
              static_cast<unsigned long long>(report.dropped));
  if (report.messages == 0) std::fprintf(stderr, "teamsight log: nothing was heard\n");
  if (!report.problem.empty()) std::fprintf(stderr, "teamsight log: %s\n", report.problem.c_str());
  const bool is_good = report.messages > 0 && report.problem.empty() && report.dropped == 0;
  return is_good ? process::kDone : process::kAnswerIsNo;
}

}  // namespace

int log_record(const LogRecord& request) {
  const settings::TeamSettings team = settings::load_team(request.team);
  bus::Loop loop;
  const auto keep_trying = [&]() {
    return loop.keeps_running();
  };
  auto recorder = std::make_unique<recording::Recorder>(recorder_settings(request, team));
  std::printf("{\"file\": \"%s\"}\n", recorder->report().file.c_str());
  std::fflush(stdout);
  const auto participant =
      bus::Participant::join(process::team_domain(team, request.domains), keep_trying);
  recording::BusRecorder feeds(participant, loop, *recorder);
  std::optional<bus::Participant> match;
  if (!request.match_tag.empty()) {
    match = bus::Participant::join(process::host_domain(team, request.domains, request.match_tag),
                                   keep_trying);
    feeds.add_truth(*match);
  }
  const FieldModel field = settings::load_field(team.field);
  std::string problem;
  loop.every(std::chrono::seconds(1), [&]() {
    feeds.draw(field, bus::host_now());
    const std::string now = recorder->report().problem;
    if (!now.empty() && now != problem) std::fprintf(stderr, "teamsight log: %s\n", now.c_str());
    problem = now;
  });
  if (request.seconds) loop.every(from_seconds(*request.seconds), [&]() { loop.stop(); });
  loop.run();
  recorder->finish();
  return finish(recorder->report());
}

}  // namespace teamsight::tools
