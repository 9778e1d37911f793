// monitor/silence.cpp: see monitor/silence.hpp.
#include "monitor/silence.hpp"

#include "geometry/identity.hpp"

namespace teamsight::monitor {
namespace {

/// "Robot 3", "Robots 1, 3"; empty: none is alive.
std::string robots_alive(const Update& update) {
  std::string list;
  int count = 0;
  for (const RobotRow& row : update.robots) {
    if (!row.alive) continue;
    list += (list.empty() ? "" : ", ") + std::to_string(static_cast<unsigned>(row.robot));
    ++count;
  }
  if (count == 0) return {};
  return (count == 1 ? "Robot " : "Robots ") + list;
}

}  // namespace

std::string silence_of(const Update& update, const Surroundings& around) {
  if (update.world && update.world_age <= around.world_late_after) return {};
  if (const std::string heard = robots_alive(update); !heard.empty()) {
    if (update.world)
      return heard + " heard, but the leading fusion fell silent and none took over";
    return heard + " heard, but no fusion: is teamsight-fusion running?";
  }
  const std::string elsewhere =
      around.other_domains.empty() ? "" : ". This network carries " + around.other_domains;
  if (!update.robots.empty()) return "Every robot fell silent" + elsewhere;
  if (!around.other_versions.empty()) {
    return "On " + around.where + " somebody speaks " + around.other_versions + kNotHeardHere;
  }
  if (update.world) return "The world model is old, and no robot is heard";
  if (!update.rejected.empty()) {
    return "Samples arrive on " + around.where +
           ", but every one was dropped: " + update.rejected.front().name;
  }
  return "Nothing heard yet on " + around.where +
         ": are the robots on, in this domain, with this version?" + elsewhere;
}

}  // namespace teamsight::monitor
