// sim/setup.hpp: a match file and what it names, ready to be played and looked at.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "settings/load.hpp"
#include "sim/match/match.hpp"
#include "sim/render/renderer.hpp"
#include "sim/show.hpp"

namespace teamsight::sim {

/// Names and purposes of the scenarios, for a program's help.
[[nodiscard]] std::string scenario_help();

struct Setup {
  settings::MatchSettings match;
  FieldModel field;
  vision::CameraParameters camera;  ///< as the agents know it
  MatchParameters parameters;
};

/// Reads a match file and the files that it names.
///
/// @param team  a team file instead of the match's; empty: the match's
/// @param seed  instead of the match's
/// @throws std::exception naming file, key, what was found and what was expected
[[nodiscard]] Setup load_setup(const std::filesystem::path& match,
                               const std::filesystem::path& team,
                               std::optional<std::uint32_t> seed);

/// What one robot sees with, its defects in it, and of whom.
struct Eye {
  Renderer renderer;
  Bodies bodies;
};

/// @param player  index in the match's players
/// @param format  of the frames: the camera's, or another
[[nodiscard]] Eye make_eye(const Setup& setup, std::size_t player, vision::PixelFormat format);

}  // namespace teamsight::sim
