// tools/camera_games.cpp: see tools/camera_games.hpp.
#include "tools/camera_games.hpp"

#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <variant>

#include <fmt/format.h>

#include "bench/kept_play/kept_game.hpp"
#include "settings/load.hpp"

namespace teamsight::tools {
namespace {

/// FNV-1a: tells files apart that were changed, not forged.
std::string sum_of(std::string_view text) {
  std::uint64_t sum = 0xCBF29CE484222325U;
  for (const char c : text) sum = (sum ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  return fmt::format("{:016x}", sum);
}

std::string text_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The numbers of a mirror's profile, which stand in a file of their own; nothing for a table.
std::string profile_of(const vision::CameraParameters& camera) {
  std::string text;
  const auto* mirror = std::get_if<vision::ProfileMirror>(&camera.mirror);
  if (mirror == nullptr) return text;
  for (const auto& point : mirror->profile) text += fmt::format("{} {}\n", point.x, point.y);
  return text;
}

kept_play::Facts facts_of(const play::Scenario& scenario,
                          std::uint64_t seed,
                          double seconds,
                          const CameraGames& games) {
  return {{"scenario", scenario.name},
          {"seed", std::to_string(seed)},
          {"seconds", fmt::format("{}", seconds)},
          {"rate_hz", fmt::format("{}", scenario.perception.rate)},
          {"camera", games.setup.camera.name},
          {"camera_sum", games.camera_sum},
          {"field_sum", games.field_sum},
          {"samples", std::to_string(games.setup.picture.fineness)},
          {"code", std::string(kept_play::seeing_code())}};
}

/// Nothing if it is not there, or not whole.
std::optional<kept_play::Looks> looks_in(const std::filesystem::path& file,
                                         const kept_play::Facts& facts) {
  if (!std::filesystem::exists(file)) return std::nullopt;
  try {
    return kept_play::read_game(file, facts);
  } catch (const kept_play::OtherGame& other) {
    throw kept_play::OtherGame(std::string(other.what()) +
                               "; remove it to have the game rendered again");
  } catch (const std::runtime_error& damage) {
    std::cerr << damage.what() << "; rendered again\n";
    return std::nullopt;
  }
}

}  // namespace

CameraGames load_camera_games(const std::string& camera, const std::string& field, int samples) {
  CameraGames games;
  games.setup.camera = settings::load_camera(camera);
  games.setup.field = settings::load_field(field);
  games.setup.picture.fineness = samples;
  games.camera_sum = sum_of(text_of(camera) + profile_of(games.setup.camera));
  games.field_sum = sum_of(text_of(field));
  return games;
}

play::PlayLog camera_game(const play::Scenario& scenario,
                          std::uint64_t seed,
                          double seconds,
                          const CameraGames& games) {
  if (games.kept.empty()) {
    camera_play::CameraEyes eyes(games.setup, scenario, seed);
    return play::play_log(scenario, seed, seconds, eyes);
  }
  std::error_code error;
  std::filesystem::create_directories(games.kept, error);
  if (error) {
    throw std::runtime_error(fmt::format(
        "{}: found {}, expected a folder to keep games in", games.kept.string(), error.message()));
  }
  const auto file = games.kept / fmt::format("{}-{}.mcap", scenario.name, seed);
  const kept_play::Facts facts = facts_of(scenario, seed, seconds, games);
  if (auto looks = looks_in(file, facts)) {
    kept_play::KeptEyes eyes(*std::move(looks), scenario.play.robot_radius);
    return play::play_log(scenario, seed, seconds, eyes);
  }
  camera_play::CameraEyes rendered(games.setup, scenario, seed);
  kept_play::KeepingEyes eyes(rendered);
  play::PlayLog log = play::play_log(scenario, seed, seconds, eyes);
  kept_play::write_game(file, facts, eyes.looks());
  return log;
}

}  // namespace teamsight::tools
