// examples/behaviour/attacker.cpp: see examples/behaviour/attacker.hpp.
#include "examples/behaviour/attacker.hpp"

#include <cmath>

#include "geometry/angle.hpp"

namespace behaviour {
namespace {

using teamsight::WorldTeammate;

constexpr double kSpeed = 3.0;     // m/s
constexpr double kTurnRate = 6.0;  // rad/s
constexpr double kLeastTrust = 0.5;
constexpr teamsight::Duration kOldest = std::chrono::milliseconds(500);

bool can_play(const WorldTeammate& mate) {
  return mate.trust >= kLeastTrust && mate.age <= kOldest;
}

double time_to(const teamsight::Point<teamsight::Field>& p_FB, const WorldTeammate& mate) {
  const Eigen::Vector2d way = p_FB.vector() - mate.X_FR.origin().vector();
  const double turn = teamsight::angle_difference(std::atan2(way.y(), way.x()), mate.X_FR.theta());
  return way.norm() / kSpeed + std::abs(turn) / kTurnRate;
}

}  // namespace

std::optional<Attacker> choose_attacker(const teamsight::WorldModel& world) {
  if (world.balls.empty()) return std::nullopt;
  const auto p_FB = world.balls.front().p_FB.on_floor();
  std::optional<Attacker> best;
  for (const WorldTeammate& mate : world.teammates) {
    if (!can_play(mate)) continue;
    const Attacker candidate{mate.robot, time_to(p_FB, mate)};
    const bool is_tie = best && candidate.time_to_ball == best->time_to_ball;
    const bool is_better = !best || candidate.time_to_ball < best->time_to_ball ||
                           (is_tie && candidate.robot < best->robot);
    if (is_better) best = candidate;
  }
  return best;
}

}  // namespace behaviour
