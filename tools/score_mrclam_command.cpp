// tools/score_mrclam_command.cpp: see tools/score_command.hpp.
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "bench/mrclam/score.hpp"
#include "process/program.hpp"
#include "tools/score_command.hpp"
#include "tools/score_rounding.hpp"

namespace teamsight::tools {
namespace {

using nlohmann::ordered_json;

ordered_json json_of(const mrclam::PostureScore& score) {
  ordered_json json;
  json["alone_rmse_m"] = rounded(score.alone.rms());
  json["team_rmse_m"] = rounded(score.team.rms());
  json["alone_p95_m"] = rounded(score.alone.quantile(0.95));
  json["team_p95_m"] = rounded(score.team.quantile(0.95));
  json["alone_heading_rad"] = rounded(score.heading_alone.rms());
  json["team_heading_rad"] = rounded(score.heading_team.rms());
  json["alone_nees"] = rounded(score.nees_alone.mean());
  json["team_nees"] = rounded(score.nees_team.mean());
  json["quarantined_share"] = rounded(score.quarantined / std::max(1.0, 1.0 * score.team.count()));
  json["moments"] = score.team.count();
  return json;
}

void print(const mrclam::RobotLogs& logs, std::optional<RobotId> blind) {
  const mrclam::PostureScores scores = mrclam::score_postures(logs, blind);
  for (std::size_t i = 0; i < scores.size(); ++i) {
    ordered_json line;
    line["case"] = blind ? "robot " + std::to_string(*blind) + " sees no landmarks" : "all see";
    line["robot"] = i + 1;
    line.update(json_of(scores[i]));
    std::cout << line.dump() << std::endl;
  }
}

}  // namespace

void add_score_mrclam_command(CLI::App& score, int& exit_code) {
  const auto folder = std::make_shared<std::filesystem::path>();
  CLI::App* mrclam = score.add_subcommand(
      "mrclam", "what the team makes of real robots' postures (UTIAS MRCLAM data)");
  mrclam->add_option("FOLDER", *folder, "with Barcodes.dat and the robots' files, plain or .gz")
      ->required();
  mrclam->callback([folder, &exit_code] {
    const mrclam::RobotLogs logs = mrclam::read_robot_logs(*folder);
    print(logs, std::nullopt);
    for (int robot = 1; robot <= mrclam::kRobots; ++robot) {
      print(logs, static_cast<RobotId>(robot));
    }
    exit_code = process::kDone;
  });
}

}  // namespace teamsight::tools
