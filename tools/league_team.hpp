// tools/league_team.hpp: the referee box's files of a game, as what can be scored.
#pragma once

#include <filesystem>
#include <vector>

#include "bench/fuse_score/league.hpp"

namespace teamsight::tools {

/// One team's world states from its first to its last; what is unusable is dropped and counted.
///
/// The box's frame (x right, y to the opponent goal) becomes F. Of a list with as many obstacles
/// as robots that names places without obstacle as null, each place is one robot's own; otherwise
/// nobody is named as reporter.
///
/// @throws std::runtime_error if the file is not there, no list, cut off, or without a usable
///         record
[[nodiscard]] score::LeagueTeam read_league_team(const std::filesystem::path& path);

/// From each START to the next STOP.
///
/// @throws std::runtime_error if the file is not there or the ball never was in play
[[nodiscard]] std::vector<score::LeagueSpan> read_league_spans(const std::filesystem::path& path);

}  // namespace teamsight::tools
