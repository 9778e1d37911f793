// tools/league_team.cpp: see tools/league_team.hpp.
#include "tools/league_team.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "tools/league_game.hpp"

namespace teamsight::tools {
namespace {

using nlohmann::json;

constexpr double kMaxAgeMs = 10'000.0;
constexpr std::int64_t kGapMs = 1'000;

/// The list under `key`; nothing if there is none.
const json* list_of(const json& item, const char* key) {
  const auto found = item.find(key);
  return found != item.end() && found->is_array() ? &*found : nullptr;
}

/// Reads one team's records in the order of the file.
class TeamReader {
 public:
  void take(const json& record) {
    ++team_.read;
    const json* state = state_of(record);
    if (state == nullptr) return drop("record_malformed");
    const double arrival = number(record, "timestamp", 0.0);
    const double age = number(*state, "ageMs", -1.0);
    if (arrival < 1e12 || arrival > 1e13 || age < 0.0 || age > kMaxAgeMs)
      return drop("record_without_time");
    score::LeagueRecord read;
    read.arrival_ms = static_cast<std::int64_t>(arrival);
    read.age_ms = static_cast<std::int64_t>(age);
    read.is_in_order = read.arrival_ms > newest_ms_;
    if (read.arrival_ms < newest_ms_) drop("stamp_backwards");
    if (read.arrival_ms == newest_ms_) drop("stamp_repeated");
    if (newest_ms_ > 0 && read.arrival_ms - newest_ms_ > kGapMs) ++team_.gaps;
    newest_ms_ = std::max(newest_ms_, read.arrival_ms);
    if (team_.name.empty() && record.value("teamName", json()).is_string())
      team_.name = record["teamName"];
    take_robots(*list_of(*state, "robots"), read);
    take_obstacles(*list_of(*state, "obstacles"), ids_in(*list_of(*state, "robots")), read);
    team_.records.push_back(std::move(read));
  }

  score::LeagueTeam finish() {
    std::ranges::stable_sort(team_.records, {}, &score::LeagueRecord::arrival_ms);
    return std::move(team_);
  }

 private:
  static const json* state_of(const json& record) {
    const auto state = record.find("worldstate");
    if (state == record.end() || !state->is_object()) return nullptr;
    const bool is_whole =
        list_of(*state, "robots") != nullptr && list_of(*state, "obstacles") != nullptr;
    return is_whole ? &*state : nullptr;
  }

  void drop(const char* reason) { ++team_.dropped[reason]; }

  void take_robots(const json& list, score::LeagueRecord& read) {
    for (const json& item : list) {
      const double id = item.is_object() ? number(item, "id", 0.0) : 0.0;
      const auto pose = item.is_object() ? numbers(item, "pose", 3) : std::nullopt;
      if (!pose) {
        drop("robot_without_pose");
      } else if (id < 1.0 || id > kMaxRobotId) {
        drop("robot_unknown");
      } else {
        add_robot(item, static_cast<RobotId>(id), *pose, read);
      }
    }
  }

  void add_robot(const json& item,
                 RobotId id,
                 const std::vector<double>& pose,
                 score::LeagueRecord& read) {
    if (!item.contains("targetPose") && item.contains("target pose")) drop("target_misspelled");
    score::LeagueRobot robot;
    robot.robot = id;
    robot.X_FR = {pose[1], -pose[0], pose[2]};
    const bool waits = item.value("intention", json()) == "Waiting for my turn";
    robot.plays = !waits && score::is_within_lines(robot.X_FR.origin());
    if (waits) drop("robot_waiting");
    if (!waits && !robot.plays) drop("robot_off_field");
    read.robots.push_back(robot);
  }

  /// Whose place each one in the list is; nobody's where it does not say.
  static std::vector<RobotId> ids_in(const json& list) {
    std::vector<RobotId> ids;
    for (const json& item : list) {
      const double id = item.is_object() ? number(item, "id", 0.0) : 0.0;
      ids.push_back(id < 1.0 || id > kMaxRobotId ? kNobody : static_cast<RobotId>(id));
    }
    return ids;
  }

  /// A place kept for each robot, null where it sees nothing, tells who saw what.
  void take_obstacles(const json& list,
                      const std::vector<RobotId>& ids,
                      score::LeagueRecord& read) {
    const bool names_places = list.size() == ids.size() && has_null(list);
    for (std::size_t i = 0; i < list.size(); ++i) {
      const auto at = list[i].is_object() ? numbers(list[i], "position", 2) : std::nullopt;
      if (!at) {
        drop("obstacle_null");
        continue;
      }
      const Point<Field> p_FO{(*at)[1], -(*at)[0]};
      if (!score::is_within_lines(p_FO)) drop("obstacle_off_field");
      read.obstacles.push_back({p_FO, names_places ? ids[i] : kNobody});
    }
  }

  static bool has_null(const json& list) {
    return std::any_of(list.begin(), list.end(), [](const json& item) {
      return item.is_object() && !numbers(item, "position", 2);
    });
  }

  score::LeagueTeam team_;
  std::int64_t newest_ms_{0};
};

}  // namespace

score::LeagueTeam read_league_team(const std::filesystem::path& path) {
  TeamReader reader;
  const bool is_whole =
      for_each_league_record(path, [&](const json& record) { reader.take(record); });
  if (!is_whole) throw std::runtime_error(path.string() + ": cut off, expected a whole JSON list");
  score::LeagueTeam team = reader.finish();
  if (team.records.empty())
    throw std::runtime_error(path.string() + ": no usable world state, expected the league's");
  return team;
}

std::vector<score::LeagueSpan> read_league_spans(const std::filesystem::path& path) {
  std::vector<score::LeagueSpan> spans;
  std::int64_t start = 0;
  for_each_league_event(path, [&](std::int64_t ms, const std::string& words) {
    if (words == "START") start = ms;
    if (words != "STOP" || start == 0) return;
    spans.push_back({start, ms});
    start = 0;
  });
  if (spans.empty())
    throw std::runtime_error(path.string() + ": no START and STOP, expected a game's events");
  return spans;
}

}  // namespace teamsight::tools
