// sim/match/players.cpp: see players.hpp.
#include "sim/match/players.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"

namespace teamsight::sim {
namespace {

constexpr double kBodyBounce = 0.4;     // share of the closing speed that a body throws back
constexpr double kPersonalSpace = 0.9;  // m between axes, from where on players give way

Eigen::Vector2d limited(const Eigen::Vector2d& vector, double longest) {
  const double length = vector.norm();
  return length > longest ? Eigen::Vector2d(vector * (longest / length)) : vector;
}

void turn(Player& player, double heading, double seconds, const BodyParameters& parameters) {
  const double error = angle_difference(heading, player.X_FR.theta());
  // The turn from which it can still stop at the heading.
  const double braking = std::sqrt(2.0 * parameters.max_turn_acceleration * std::abs(error));
  const double most = std::min({parameters.max_turn, 4.0 * std::abs(error), 0.8 * braking});
  const double wanted = std::copysign(most, error);
  const double change = parameters.max_turn_acceleration * seconds;
  player.omega += std::clamp(wanted - player.omega, -change, change);
}

void push_apart(Player& a, Player& b, double least) {
  const Eigen::Vector2d between = b.X_FR.origin().vector() - a.X_FR.origin().vector();
  const double distance = between.norm();
  if (distance >= least || !a.on_field || !b.on_field) {
    return;
  }
  const Eigen::Vector2d normal =
      distance > 1e-6 ? Eigen::Vector2d(between / distance) : Eigen::Vector2d(1.0, 0.0);
  const Eigen::Vector2d shift = normal * ((least - distance) / 2.0);
  a.X_FR = {a.X_FR.x() - shift.x(), a.X_FR.y() - shift.y(), a.X_FR.theta()};
  b.X_FR = {b.X_FR.x() + shift.x(), b.X_FR.y() + shift.y(), b.X_FR.theta()};
  const double closing = (b.v_FR.vector() - a.v_FR.vector()).dot(normal);
  if (closing < 0.0) {
    a.v_FR = Velocity<Field>::from(a.v_FR.vector() + normal * (closing / 2.0));
    b.v_FR = Velocity<Field>::from(b.v_FR.vector() - normal * (closing / 2.0));
  }
}

}  // namespace

void drive(Player& player,
           const Intention& intention,
           double seconds,
           const BodyParameters& parameters) {
  const Eigen::Vector2d wanted = limited(intention.velocity_F, parameters.max_speed);
  const Eigen::Vector2d wheels = player.wheels_F.vector();
  const Eigen::Vector2d turned =
      wheels + limited(wanted - wheels, parameters.max_acceleration * seconds);
  player.wheels_F = Velocity<Field>::from(turned);
  const bool slips = player.slippery_for > 0.0;
  player.slippery_for = std::max(player.slippery_for - seconds, 0.0);
  const double grip = slips ? parameters.slippery_grip : parameters.grip;
  const Eigen::Vector2d body = player.v_FR.vector();
  player.v_FR = Velocity<Field>::from(body + limited(turned - body, grip * seconds));
  turn(player, intention.heading, seconds, parameters);
  const Eigen::Vector2d next = player.X_FR.origin().vector() + player.v_FR.vector() * seconds;
  player.X_FR = {next.x(), next.y(), player.X_FR.theta() + player.omega * seconds};
}

void keep_apart(std::vector<Player>& players, const BodyParameters& parameters) {
  const double least = 2.0 * parameters.radius + 0.02;
  for (std::size_t i = 0; i < players.size(); ++i) {
    for (std::size_t j = i + 1; j < players.size(); ++j) {
      push_apart(players[i], players[j], least);
    }
  }
}

Eigen::Vector2d velocity_to(const Point<Field>& target,
                            std::size_t player,
                            const std::vector<Player>& players,
                            const BodyParameters& parameters) {
  const Eigen::Vector2d here = players[player].X_FR.origin().vector();
  const Eigen::Vector2d way = target.vector() - here;
  // The speed from which it can still stop at the target.
  const double braking = std::sqrt(2.0 * parameters.max_acceleration * way.norm());
  const double speed = std::min(0.7 * braking, 0.9 * parameters.max_speed);
  Eigen::Vector2d wanted(0.0, 0.0);
  if (way.norm() > 1e-6) {
    wanted = way.normalized() * speed;
  }
  for (std::size_t i = 0; i < players.size(); ++i) {
    const Eigen::Vector2d away = here - players[i].X_FR.origin().vector();
    const double distance = away.norm();
    if (i != player && players[i].on_field && distance < kPersonalSpace && distance > 1e-6) {
      wanted += away * (2.0 * (kPersonalSpace - distance) / distance);
    }
  }
  return limited(wanted, parameters.max_speed);
}

void meet_players(Ball& ball,
                  const std::vector<Player>& players,
                  double ball_radius,
                  const BodyParameters& parameters) {
  const double touching = parameters.radius + ball_radius;
  for (const Player& player : players) {
    const Eigen::Vector2d way = ball.p_FB.on_floor().vector() - player.X_FR.origin().vector();
    const double distance = way.norm();
    const bool over = ball.p_FB.z - ball_radius > parameters.height;
    if (!player.on_field || over || distance >= touching) {
      continue;
    }
    const Eigen::Vector2d normal =
        distance > 1e-6 ? Eigen::Vector2d(way / distance) : Eigen::Vector2d(1.0, 0.0);
    const Eigen::Vector2d place = player.X_FR.origin().vector() + normal * touching;
    const Eigen::Vector2d v(ball.v_FB.x, ball.v_FB.y);
    const double closing = std::min((v - player.v_FR.vector()).dot(normal), 0.0);
    const Eigen::Vector2d bounced = v - normal * ((1.0 + kBodyBounce) * closing);
    ball.p_FB = {place.x(), place.y(), ball.p_FB.z};
    ball.v_FB = {bounced.x(), bounced.y(), ball.v_FB.z};
  }
}

}  // namespace teamsight::sim
