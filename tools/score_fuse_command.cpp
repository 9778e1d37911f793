// tools/score_fuse_command.cpp: see tools/score_command.hpp.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "bench/camera_play/camera_eyes.hpp"
#include "bench/fuse_score/claims.hpp"
#include "bench/fuse_score/run.hpp"
#include "process/program.hpp"
#include "tools/camera_games.hpp"
#include "tools/many_threads.hpp"
#include "tools/progress_line.hpp"
#include "tools/score_command.hpp"
#include "tools/score_rounding.hpp"

namespace teamsight::tools {
namespace {

using nlohmann::ordered_json;

struct Options {
  std::vector<std::string> scenarios;
  std::uint64_t first_seed{1};
  std::uint64_t seeds{100};
  double seconds{20.0};
  bool no_peers{false};
  std::optional<double> rate_hz;
  std::size_t threads{1};
  bool cameras{false};
  std::string camera{"config/cameras/sim-640.textproto"};
  std::string field{"config/fields/msl-2024.textproto"};
  int samples{1};
  std::string kept;
};

constexpr double kCameraRate = 10.0;  // Hz, if nobody says another

/// One game as everybody sees it.
struct Game {
  score::Tally fused;
  score::Tally without_bad;
  score::ClaimTally claims;
  std::vector<score::Scored> balls;
  std::vector<score::Scored> obstacles;
  double worst_clock{0.0};  ///< s
};

using Cameras = std::optional<CameraGames>;

ordered_json ball_json(const score::BallTally& ball) {
  const double bound = std::sqrt(ball.bound_position.mean());
  const double bound_v = std::sqrt(ball.bound_velocity.mean());
  ordered_json json;
  json["rmse_m"] = rounded(ball.position.rms());
  json["bound_m"] = bound > 0.0 ? ordered_json(rounded(bound)) : nullptr;
  json["ratio"] = bound > 0.0 ? ordered_json(rounded(ball.position.rms() / bound)) : nullptr;
  json["median_m"] = rounded(ball.position.quantile(0.5));
  json["p95_m"] = rounded(ball.position.quantile(0.95));
  json["ticks"] = ball.position.count();
  json["velocity_rmse_mps"] = rounded(ball.velocity.rms());
  json["velocity_bound_mps"] = bound_v > 0.0 ? ordered_json(rounded(bound_v)) : nullptr;
  json["velocity_median_mps"] = rounded(ball.velocity.quantile(0.5));
  json["known_share"] = ball.needed == 0
                            ? nullptr
                            : ordered_json(rounded(static_cast<double>(ball.position.count()) /
                                                   static_cast<double>(ball.needed)));
  if (ball.high.count() > 0) {
    json["high_rmse_m"] = rounded(ball.high.rms());
    json["high_median_m"] = rounded(ball.high.quantile(0.5));
    json["high_ticks"] = ball.high.count();
  }
  if (ball.bound_high.count > 0) json["high_bound_m"] = rounded(std::sqrt(ball.bound_high.mean()));
  if (ball.nees_position.count > 0) {
    json["nees_position"] = rounded(ball.nees_position.mean());
    json["nees_velocity"] = rounded(ball.nees_velocity.mean());
    json["second_ball_share"] = rounded(ball.second_balls / std::max(1.0, 1.0 * ball.needed));
  }
  return json;
}

ordered_json obstacle_json(const score::ObstacleTally& obstacles, double minutes) {
  ordered_json json;
  json["gospa_m"] = rounded(std::sqrt(obstacles.gospa.mean()));
  json["localisation_m"] = rounded(std::sqrt(obstacles.localisation.mean()));
  json["missed"] = rounded(obstacles.missed.mean());
  json["false"] = rounded(obstacles.false_ones.mean());
  json["id_switches_per_minute"] = rounded(obstacles.switches / std::max(1e-9, minutes));
  json["false_tracks_per_minute"] = rounded(obstacles.false_tracks / std::max(1e-9, minutes));
  if (obstacles.nees.count > 0) json["nees"] = rounded(obstacles.nees.mean());
  return json;
}

/// Median, 95 % and most of some durations; @pre there is one.
void add_spread(ordered_json& json, const std::string& name, std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  json[name + "_s_median"] = rounded(seconds[seconds.size() / 2]);
  json[name + "_s_p95"] = rounded(seconds[(seconds.size() - 1) * 95 / 100]);
  json[name + "_s_max"] = rounded(seconds.back());
}

ordered_json trust_json(const score::TrustTally& trust) {
  ordered_json json;
  json["found"] = trust.found_after.size();
  json["not_found"] = trust.not_found;
  json["wrong_reason"] = trust.wrong_reason;
  json["false_alarms"] = trust.false_alarms;
  if (!trust.over_after.empty()) {
    json["over_by_themselves"] = trust.over_after.size();
    json["over_after_s_max"] =
        rounded(*std::max_element(trust.over_after.begin(), trust.over_after.end()));
  }
  if (trust.found_after.empty()) return json;
  add_spread(json, "found_after", trust.found_after);
  add_spread(json, "found_after_evidence", trust.found_after_evidence);
  return json;
}

ordered_json shares_json(const std::array<score::MeanTally, 3>& rings) {
  ordered_json json = ordered_json::array();
  for (const score::MeanTally& ring : rings) json.push_back(rounded(ring.mean()));
  return json;
}

ordered_json claims_json(const score::ClaimTally& claims) {
  ordered_json json;
  json["posture"]["rmse_m"] = rounded(claims.posture.rms());
  json["posture"]["p95_m"] = rounded(claims.posture.quantile(0.95));
  json["posture"]["nees"] = rounded(claims.posture_nees.mean());
  json["ball"]["nees_direction"] = rounded(claims.ray_nees.mean());
  json["ball"]["nees_angular_radius"] = rounded(claims.radius_nees.mean());
  json["ball"]["shown_share_3_6_9_m"] = shares_json(claims.balls_shown);
  json["ball"]["false_per_frame"] = rounded(claims.false_balls.mean());
  json["obstacles"]["rmse_m"] = rounded(claims.obstacle.rms());
  json["obstacles"]["nees"] = rounded(claims.obstacle_nees.mean());
  json["obstacles"]["shown_share_3_6_9_m"] = shares_json(claims.players_shown);
  json["obstacles"]["false_per_frame"] = rounded(claims.false_obstacles.mean());
  return json;
}

ordered_json fusion_json(const score::Tally& tally) {
  ordered_json json;
  json["ball"] = ball_json(tally.ball);
  json["obstacles"] = obstacle_json(tally.obstacles, tally.minutes);
  json["teammates"]["rmse_m"] = rounded(tally.mates.position.rms());
  json["teammates"]["said_rmse_m"] = rounded(tally.mates.said.rms());
  json["teammates"]["nees"] = rounded(tally.mates.nees.mean());
  json["trust"] = trust_json(tally.trust);
  json["insert_us"] = rounded(tally.insert_us.mean());
  json["minutes"] = rounded(tally.minutes);
  return json;
}

void print(const std::string& scenario, const std::string& estimator, const ordered_json& rest) {
  ordered_json line;
  line["scenario"] = scenario;
  line["estimator"] = estimator;
  line.update(rest);
  std::cout << line.dump() << std::endl;
}

/// Adds the results of one seed to those of the seeds before.
void merge(std::vector<score::Scored>& into, const std::vector<score::Scored>& from) {
  if (into.empty()) into.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) {
    into[i].estimator = from[i].estimator;
    into[i].tally.merge(from[i].tally);
  }
}

Game score_game(const play::Scenario& scenario,
                std::uint64_t seed,
                const Options& options,
                const Cameras& cameras) {
  const play::PlayLog log = cameras ? camera_game(scenario, seed, options.seconds, *cameras)
                                    : play::play_log(scenario, seed, options.seconds);
  const auto ticks = score::make_ticks(log);
  Game game;
  game.fused = score::run_fusion(log, ticks, false);
  if (!scenario.faults.empty()) game.without_bad = score::run_fusion(log, ticks, true);
  game.claims = score::count_claims(log);
  game.worst_clock = log.worst_clock_error;
  if (options.no_peers) return game;
  game.balls = score::run_ball_rules(log, ticks);
  game.obstacles = score::run_obstacle_rules(log, ticks);
  return game;
}

/// All games of a scenario, in the order of their seeds.
std::vector<Game> score_games(const play::Scenario& scenario,
                              const Options& options,
                              const Cameras& cameras) {
  std::vector<Game> games(options.seeds);
  const ProgressLine progress;
  run_on_threads(
      games.size(),
      options.threads,
      [&](std::size_t i) {
        games[i] = score_game(scenario, options.first_seed + i, options, cameras);
      },
      [&](std::size_t done) {
        progress.say(fmt::format("{}: {} of {} games", scenario.name, done, games.size()));
      });
  progress.clear();
  return games;
}

/// Nothing that depends on how many threads there are.
Game merged(const std::vector<Game>& games) {
  Game all;
  for (const Game& game : games) {
    all.fused.merge(game.fused);
    all.without_bad.merge(game.without_bad);
    all.claims.merge(game.claims);
    all.worst_clock = std::max(all.worst_clock, game.worst_clock);
    merge(all.balls, game.balls);
    merge(all.obstacles, game.obstacles);
  }
  return all;
}

void score_scenario(const play::Scenario& scenario,
                    const Options& options,
                    const Cameras& cameras) {
  const Game all = merged(score_games(scenario, options, cameras));
  ordered_json own = fusion_json(all.fused);
  if (cameras) own["cameras"] = cameras->setup.camera.name;
  own["rate_hz"] = scenario.perception.rate;
  if (scenario.clocks.is_unknown) own["worst_clock_error_ms"] = rounded(1e3 * all.worst_clock);
  print(scenario.name, "teamsight", own);
  print(scenario.name, "single-frames", claims_json(all.claims));
  if (!scenario.faults.empty()) {
    print(scenario.name, "teamsight-without-the-bad", fusion_json(all.without_bad));
  }
  for (const score::Scored& scored : all.balls) {
    print(scenario.name, scored.estimator, {{"ball", ball_json(scored.tally.ball)}});
  }
  for (const score::Scored& scored : all.obstacles) {
    print(scenario.name,
          scored.estimator,
          {{"obstacles", obstacle_json(scored.tally.obstacles, scored.tally.minutes)}});
  }
}

[[noreturn]] void refuse(const std::string& name, const std::vector<play::Scenario>& all) {
  std::string known;
  for (const play::Scenario& scenario : all) known.append(" ").append(scenario.name);
  throw std::runtime_error("--scenario: found " + name + ", expected one of" + known);
}

/// The scenarios asked for, in the order of the list. @throws if one has no such name
std::vector<play::Scenario> chosen(const std::vector<std::string>& names) {
  std::vector<play::Scenario> all = play::all_scenarios();
  if (names.empty()) return all;
  for (const std::string& name : names) {
    const auto is_named = [&](const play::Scenario& scenario) {
      return scenario.name == name;
    };
    if (std::any_of(all.begin(), all.end(), is_named)) continue;
    refuse(name, all);
  }
  std::erase_if(all, [&](const play::Scenario& scenario) {
    return std::find(names.begin(), names.end(), scenario.name) == names.end();
  });
  return all;
}

Cameras cameras_of(const Options& options) {
  if (!options.cameras) return std::nullopt;
  CameraGames games = load_camera_games(options.camera, options.field, options.samples);
  games.kept = options.kept;
  const camera_play::CameraSetup& setup = games.setup;
  const FieldModel expected = play::play_field();
  if (setup.field.length == expected.length && setup.field.width == expected.width) return games;
  throw std::runtime_error(fmt::format("{}: found {} x {} m, expected {} x {} m, where games are",
                                       options.field,
                                       setup.field.length,
                                       setup.field.width,
                                       expected.length,
                                       expected.width));
}

bool can_be_played(const play::Scenario& scenario, const Cameras& cameras) {
  return !cameras || std::ranges::all_of(scenario.faults, [&](const play::FaultPlan& plan) {
    return camera_play::can_have(plan.fault, cameras->setup.camera);
  });
}

void score_all(const Options& options) {
  const Cameras cameras = cameras_of(options);
  for (play::Scenario& scenario : chosen(options.scenarios)) {
    if (!can_be_played(scenario, cameras)) {
      std::cerr << scenario.name << ": left out, this camera's mirror has no shape to bump\n";
      continue;
    }
    if (cameras) scenario.perception.rate = kCameraRate;
    if (options.rate_hz) scenario.perception.rate = *options.rate_hz;
    score_scenario(scenario, options, cameras);
  }
}

}  // namespace

void add_score_fuse_command(CLI::App& score, int& exit_code) {
  const auto options = std::make_shared<Options>();
  CLI::App* fuse = score.add_subcommand("fuse", "fusion over made-up games, beside peers' rules");
  fuse->add_option("--scenario", options->scenarios, "only these; default all");
  fuse->add_option("--seeds", options->seeds, "games per scenario")->check(CLI::Range(1, 100000));
  fuse->add_option("--first-seed", options->first_seed, "the first one");
  fuse->add_option("--seconds", options->seconds, "length of a game")
      ->check(CLI::Range(7.0, 3600.0));
  fuse->add_flag("--no-peers", options->no_peers, "leave the peers' rules out");
  fuse->add_option("--rate", options->rate_hz, "frames per robot and second; 25, 10 with cameras")
      ->check(CLI::Range(1.0, 50.0));
  fuse->add_option("--threads", options->threads, "games at a time")->check(CLI::Range(1, 256));
  CLI::Option* const cameras =
      fuse->add_flag("--cameras", options->cameras, "render what robots see, and perceive it");
  fuse->add_option("--camera", options->camera, "camera file")->capture_default_str();
  fuse->add_option("--field", options->field, "field file")->capture_default_str();
  fuse->add_option("--samples", options->samples, "drawn per pixel and axis")
      ->capture_default_str()
      ->check(CLI::Range(1, 8));
  fuse->add_option(
          "--kept", options->kept, "folder of games that were rendered before; others go there")
      ->needs(cameras);
  fuse->callback([options, &exit_code] {
    score_all(*options);
    exit_code = process::kDone;
  });
}

}  // namespace teamsight::tools
