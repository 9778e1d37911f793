// monitor/referee/world_state.cpp: see monitor/referee/world_state.hpp.
#include "monitor/referee/world_state.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <string_view>

#include <nlohmann/json.hpp>

namespace teamsight::monitor {
namespace {

using Json = nlohmann::ordered_json;

double to_milli(double value) {
  return std::round(value * 1e3) / 1e3 + 0.0;  // no negative zero
}

Json list(std::initializer_list<double> values) {
  Json out = Json::array();
  for (const double value : values) out.push_back(to_milli(value));
  return out;
}

/// The one place where F becomes the box's frame: x_box = -y_F, y_box = x_F.
template <class Vector>
Json in_box_frame(const Vector& v_F) {
  return list({-v_F.y, v_F.x});
}

template <class Vector>
Json in_box_frame3(const Vector& v_F) {
  return list({-v_F.y, v_F.x, v_F.z});
}

Json pose_in_box_frame(const Pose<Field, Robot>& X_FR) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const double heading = X_FR.theta() < 0.0 ? X_FR.theta() + kTurn : X_FR.theta();
  return list({-X_FR.y(), X_FR.x(), heading});
}

Json robot(const WorldTeammate& mate, const bus::RobotState* state) {
  const Json unknown = {nullptr, nullptr, nullptr};
  const bool is_placed = mate.status != PostureStatus::kLost;
  Json out;
  out["id"] = mate.robot;
  out["pose"] = is_placed ? pose_in_box_frame(mate.X_FR) : unknown;
  out["targetPose"] = unknown;  // the behaviour's, which is not on the bus
  out["velocity"] = unknown;
  if (is_placed && state != nullptr) {
    out["velocity"] = list({-mate.v_FR.y, mate.v_FR.x, state->omega});
  }
  out["intention"] = "";
  if (state != nullptr) out["ballEngaged"] = state->has_ball ? 1 : 0;
  return out;
}

Json ball(const WorldBall& from) {
  return {{"position", in_box_frame3(from.p_FB)},
          {"velocity", in_box_frame3(from.v_FB)},
          {"confidence", to_milli(from.existence)}};
}

Json obstacle(const WorldObstacle& from) {
  return {{"position", in_box_frame(from.p_FO)},
          {"velocity", in_box_frame(from.v_FO)},
          {"radius", to_milli(from.radius)},
          {"confidence", to_milli(from.existence)}};
}

// ---- the schema's rules
// --------------------------------------------------------------------------

struct Rule {
  std::string_view key;
  bool is_vector;  ///< numbers or nulls; else a number
};

constexpr std::array kRobotRules{Rule{"id", false},
                                 Rule{"pose", true},
                                 Rule{"targetPose", true},
                                 Rule{"velocity", true},
                                 Rule{"batteryLevel", false},
                                 Rule{"ballEngaged", false}};
constexpr std::array kBallRules{
    Rule{"position", true}, Rule{"velocity", true}, Rule{"confidence", false}};
constexpr std::array kObstacleRules{Rule{"position", true},
                                    Rule{"velocity", true},
                                    Rule{"radius", false},
                                    Rule{"confidence", false}};

bool holds(const Rule& rule, const Json& item) {
  const auto found = item.find(rule.key);
  if (found == item.end()) return true;
  if (!rule.is_vector) return found->is_number();
  return found->is_array() && std::ranges::all_of(*found, [](const Json& number) {
           return number.is_number() || number.is_null();
         });
}

template <class Rules>
std::optional<std::string> fault_of_list(const Json& world,
                                         const std::string& key,
                                         const Rules& rules) {
  const auto found = world.find(key);
  if (found == world.end() || !found->is_array()) return key + ": expected a list";
  for (const Json& item : *found) {
    if (!item.is_object()) return key + ": expected objects";
    for (const Rule& rule : rules) {
      if (!holds(rule, item)) return key + "." + std::string(rule.key) + ": wrong type";
    }
  }
  return std::nullopt;
}

bool says_intention_as_text(const Json& robot) {
  const auto intention = robot.find("intention");
  return intention == robot.end() || intention->is_string();
}

}  // namespace

std::string world_state(const WorldStateInput& input) {
  Json out;
  out["type"] = "worldstate";
  out["teamName"] = input.team;
  out["intention"] = input.intention;
  out["robots"] = Json::array();
  out["balls"] = Json::array();
  out["obstacles"] = Json::array();
  for (const WorldTeammate& mate : input.world->teammates) {
    const auto state = std::ranges::find_if(
        input.robots, [&](const auto* one) { return one->id.robot == mate.robot; });
    out["robots"].push_back(robot(mate, state == input.robots.end() ? nullptr : *state));
  }
  for (const WorldBall& one : input.world->balls) out["balls"].push_back(ball(one));
  for (const WorldObstacle& one : input.world->obstacles) out["obstacles"].push_back(obstacle(one));
  out["ageMs"] = std::llround(1e3 * to_seconds(input.age));
  // The box decodes bytes as they arrive, so that only ASCII is safe from being torn.
  return out.dump(-1, ' ', true, Json::error_handler_t::replace);
}

std::optional<std::string> fault_of_world_state(const std::string& json) {
  const Json world = Json::parse(json, nullptr, false);
  if (world.is_discarded() || !world.is_object()) return "no JSON object";
  for (const char* key : {"type", "teamName", "intention"}) {
    const auto found = world.find(key);
    if (found == world.end() || !found->is_string()) return std::string(key) + ": expected a text";
  }
  if (world["type"] != "worldstate") return "type: expected worldstate";
  const auto age = world.find("ageMs");
  if (age == world.end() || !age->is_number_integer()) return "ageMs: expected a whole number";
  if (auto fault = fault_of_list(world, "robots", kRobotRules)) return fault;
  if (!std::ranges::all_of(world["robots"], says_intention_as_text)) {
    return "robots.intention: expected a text";
  }
  if (auto fault = fault_of_list(world, "balls", kBallRules)) return fault;
  return fault_of_list(world, "obstacles", kObstacleRules);
}

}  // namespace teamsight::monitor
