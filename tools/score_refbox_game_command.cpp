// tools/score_refbox_game_command.cpp: see tools/score_command.hpp.
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "bench/fuse_score/league.hpp"
#include "process/program.hpp"
#include "tools/league_team.hpp"
#include "tools/score_command.hpp"
#include "tools/score_rounding.hpp"

namespace teamsight::tools {
namespace {

using nlohmann::ordered_json;

ordered_json score_json(const score::LeagueScore& score) {
  ordered_json json;
  json["estimator"] = score.estimator;
  json["count"] = score.nearest.count();
  if (score.nearest.count() > 0) {
    json["median_m"] = rounded(score.nearest.quantile(0.5));
    json["within_half_m"] = rounded(score.nearest.share_within(0.5));
  }
  const score::ObstacleTally& obstacles = score.obstacles;
  if (obstacles.gospa.count == 0) return json;
  json["gospa_m"] = rounded(std::sqrt(obstacles.gospa.mean()));
  json["localisation_m"] = rounded(std::sqrt(obstacles.localisation.mean()));
  json["missed"] = rounded(obstacles.missed.mean());
  json["false"] = rounded(obstacles.false_ones.mean());
  if (!score.counts.empty()) json["counts"] = score.counts;
  return json;
}

void score_team(const score::LeagueTeam& own,
                const score::LeagueTeam& other,
                const std::vector<score::LeagueSpan>& spans) {
  const score::LeagueResult result = run_league(own, other, spans);
  ordered_json said{{"team", own.name}, {"records", own.read}, {"gaps", own.gaps}};
  said["dropped"] = own.dropped;
  said["counts"] = result.counts;
  std::cout << said.dump() << std::endl;
  for (const score::LeagueScore& score : result.scores) {
    ordered_json line{{"team", own.name}};
    line.update(score_json(score));
    std::cout << line.dump() << std::endl;
  }
}

/// GAME.msl holds the events; GAME.A.msl and GAME.B.msl beside it the teams' world states.
void score_game(const std::filesystem::path& events) {
  const auto beside = [&](const char* team) {
    std::filesystem::path path = events;
    return path.replace_extension(team + events.extension().string());
  };
  const auto spans = read_league_spans(events);
  const score::LeagueTeam first = read_league_team(beside(".A"));
  const score::LeagueTeam second = read_league_team(beside(".B"));
  score_team(first, second, spans);
  score_team(second, first, spans);
}

}  // namespace

void add_score_refbox_game_command(CLI::App& score, int& exit_code) {
  const auto path = std::make_shared<std::string>();
  CLI::App* game = score.add_subcommand(
      "refbox-game", "a real game's obstacles beside the other team's own postures");
  game->add_option("FILE", *path, "its events, GAME.msl; GAME.A.msl and GAME.B.msl lie beside it")
      ->required();
  game->callback([path, &exit_code] {
    score_game(*path);
    exit_code = process::kDone;
  });
}

}  // namespace teamsight::tools
