// tools/log_command.cpp: see tools/log_command.hpp.
#include "tools/log_command.hpp"

#include <memory>

#include <CLI/CLI.hpp>

#include "tools/log_actions.hpp"

namespace teamsight::tools {
namespace {

void add_selection(CLI::App& command, LogSelection& selection) {
  command.add_option("--from", selection.from_s, "seconds since the first message");
  command.add_option("--until", selection.until_s, "seconds since the first message");
  command.add_option("--topics", selection.topics, "only these, e.g. WorldModel,Sightings")
      ->delimiter(',');
}

void add_record(CLI::App& log, int& exit_code) {
  auto request = std::make_shared<LogRecord>();
  CLI::App* command = log.add_subcommand("record", "Everything on the team's domain into MCAP");
  command->add_option("--team", request->team, "team file (config/teams)")->required();
  command->add_option("--out", request->out, "folder of the files")->required();
  command->add_option("--seconds", request->seconds, "ends after so many; else at Ctrl-C")
      ->check(CLI::PositiveNumber);
  command->add_option("--max-megabytes", request->max_megabytes, "a new file begins after so many")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--match-tag", request->match_tag, "tag of a simulated match: its truth too");
  command->add_option("--team-domain", request->domains.team_domain, "instead of the team's")
      ->check(CLI::Range(0, 229));
  command->callback([request, &exit_code]() { exit_code = log_record(*request); });
}

void add_info(CLI::App& log, int& exit_code) {
  auto files = std::make_shared<std::vector<std::filesystem::path>>();
  CLI::App* command = log.add_subcommand("info", "What recordings hold: one JSON line per file");
  command->add_option("files", *files, "MCAP files")->required();
  command->callback([files, &exit_code]() { exit_code = log_info(*files); });
}

void add_cut(CLI::App& log, int& exit_code) {
  auto request = std::make_shared<LogCut>();
  CLI::App* command =
      log.add_subcommand("cut", "Part of a recording; the whole of one that was cut off");
  command->add_option("--in", request->in, "MCAP file")->required();
  command->add_option("--out", request->out, "new MCAP file")->required();
  add_selection(*command, request->selection);
  command->callback([request, &exit_code]() { exit_code = log_cut(*request); });
}

void add_convert(CLI::App& log, int& exit_code) {
  auto request = std::make_shared<LogConvert>();
  CLI::App* command = log.add_subcommand("convert", "A recording as JSON lines or CSV");
  command->add_option("--in", request->in, "MCAP file")->required();
  command->add_option("--format", request->format)
      ->required()
      ->check(CLI::IsMember({"jsonl", "csv"}));
  command->add_option("--out", request->out, "jsonl: file, else stdout; csv: folder");
  add_selection(*command, request->selection);
  command->callback([request, &exit_code]() { exit_code = log_convert(*request); });
}

void add_import(CLI::App& log, int& exit_code) {
  auto request = std::make_shared<LogImport>();
  CLI::App* command = log.add_subcommand("import", "A game recorded by the league's referee box");
  command->add_option("--worlds", request->worlds, "one team's world states, *.A.msl or *.B.msl")
      ->required();
  command->add_option("--events", request->events, "the referee's events, *.msl");
  command->add_option("--own", request->own, "that team's colour in the events")
      ->check(CLI::IsMember({"cyan", "magenta"}))
      ->capture_default_str();
  command->add_option("--out", request->out, "new MCAP file")->required();
  command->callback([request, &exit_code]() { exit_code = log_import(*request); });
}

void add_replay(CLI::App& log, int& exit_code) {
  auto request = std::make_shared<LogReplay>();
  CLI::App* command = log.add_subcommand("replay", "Puts a recording back on the bus");
  command->add_option("--in", request->in, "MCAP file")->required();
  command->add_option("--team", request->team, "team file (config/teams)")->required();
  command->add_option("--speed", request->speed, "1 = as it was")
      ->check(CLI::Range(0.1, 10.0))
      ->capture_default_str();
  command->add_option("--team-domain", request->domains.team_domain, "instead of the team's")
      ->check(CLI::Range(0, 229));
  add_selection(*command, request->selection);
  command->callback([request, &exit_code]() { exit_code = log_replay(*request); });
}

}  // namespace

void add_log_command(CLI::App& app, int& exit_code) {
  CLI::App* log =
      app.add_subcommand("log", "Recordings: record, info, cut, convert, import, replay");
  log->require_subcommand(1);
  add_record(*log, exit_code);
  add_info(*log, exit_code);
  add_cut(*log, exit_code);
  add_convert(*log, exit_code);
  add_import(*log, exit_code);
  add_replay(*log, exit_code);
}

}  // namespace teamsight::tools
