// tools/league_game.hpp: the files in which the league's referee box keeps a game.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace teamsight::tools {

/// `size` finite numbers of a list; nothing where one is null or missing.
[[nodiscard]] std::optional<std::vector<double>> numbers(const nlohmann::json& item,
                                                         const char* key,
                                                         std::size_t size);

/// @return `otherwise` where there is none
[[nodiscard]] double number(const nlohmann::json& item, const char* key, double otherwise);

/// One record at a time, of a list of one team's world states: a game is a hundred megabytes.
///
/// @return whether the list was whole; a box that was switched off leaves it open
/// @throws std::runtime_error if the file cannot be read or is no list
bool for_each_league_record(const std::filesystem::path& path,
                            const std::function<void(const nlohmann::json& record)>& take);

/// One event at a time: Unix time in ms, and the words of it ("START", "CYAN Throw In").
///
/// @throws std::runtime_error if the file cannot be read
void for_each_league_event(
    const std::filesystem::path& path,
    const std::function<void(std::int64_t ms, const std::string& words)>& take);

}  // namespace teamsight::tools
