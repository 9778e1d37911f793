// tools/league_game.cpp: see tools/league_game.hpp.
#include "tools/league_game.hpp"

#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace teamsight::tools {
namespace {

using nlohmann::json;

std::ifstream open_text(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path))
    throw std::runtime_error(path.string() + ": cannot be read");
  return file;
}

}  // namespace

std::optional<std::vector<double>> numbers(const json& item, const char* key, std::size_t size) {
  const auto list = item.find(key);
  if (list == item.end() || !list->is_array() || list->size() < size) return std::nullopt;
  std::vector<double> values;
  for (std::size_t i = 0; i < size; ++i) {
    if (!(*list)[i].is_number()) return std::nullopt;
    values.push_back((*list)[i].get<double>());
  }
  return values;
}

double number(const json& item, const char* key, double otherwise) {
  const auto found = item.find(key);
  return found != item.end() && found->is_number() ? found->get<double>() : otherwise;
}

bool for_each_league_record(const std::filesystem::path& path,
                            const std::function<void(const json& record)>& take) {
  std::ifstream file = open_text(path);
  bool is_list = false;
  const auto filter = [&](int depth, json::parse_event_t event, json& parsed) {
    if (depth == 0 && event == json::parse_event_t::array_start) is_list = true;
    if (depth != 1 || event != json::parse_event_t::object_end) return true;
    take(parsed);
    return false;
  };
  const json rest = json::parse(file, filter, false);
  if (!is_list)
    throw std::runtime_error(path.string() + ": no recorded game, expected a JSON list");
  return !rest.is_discarded();
}

void for_each_league_event(
    const std::filesystem::path& path,
    const std::function<void(std::int64_t ms, const std::string& words)>& take) {
  std::ifstream file = open_text(path);
  for (std::string line; std::getline(file, line);) {
    const std::int64_t ms = std::strtoll(line.c_str(), nullptr, 10);
    if (ms < 1'000'000'000'000) continue;  // who connected
    std::string words = line.substr(line.rfind(',') + 1);
    if (words.ends_with('\r')) words.pop_back();
    take(ms, words);
  }
}

}  // namespace teamsight::tools
