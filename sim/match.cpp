// sim/match.cpp: see match.hpp.
#include "sim/match.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"
#include "geometry/expect.hpp"

namespace teamsight::sim {
namespace {

constexpr std::uint8_t kFirstOpponent = 17;
constexpr double kReach = 0.08;         // m between the bodies at which a ball can be kicked
constexpr double kBounce = 0.5;         // share of the speed a ball keeps at the edge of the carpet
constexpr double kArrived = 0.3;        // m
constexpr double kPersonalSpace = 0.9;  // m, from where on players give way
constexpr double kMargin = 0.5;         // m inside the lines that players keep

Eigen::Vector2d limited(const Eigen::Vector2d& vector, double longest) {
  const double length = vector.norm();
  return length > longest ? Eigen::Vector2d(vector * (longest / length)) : vector;
}

}  // namespace

Match::Match(const MatchParameters& parameters, const FieldModel& field)
    : parameters_(parameters),
      half_length_(field.length / 2.0),
      half_width_(field.width / 2.0),
      centre_(field.centre),
      random_(parameters.seed) {
  TEAMSIGHT_EXPECT(!parameters.own.empty());
  const auto place = [this](std::uint8_t number, double side) {
    const double x = centre_.x + side * uniform(0.1, 0.85) * (half_length_ - kMargin);
    const double y = centre_.y + uniform(-0.85, 0.85) * (half_width_ - kMargin);
    state_.players.push_back(
        {number, Pose<Field, Robot>(x, y, side < 0.0 ? 0.0 : std::acos(-1.0)), {}, 0.0});
  };
  for (const RobotId id : parameters.own) {
    place(id, -1.0);
  }
  for (std::uint32_t i = 0; i < parameters.opponents; ++i) {
    place(static_cast<std::uint8_t>(kFirstOpponent + i), 1.0);
  }
  plans_.resize(state_.players.size());
  state_.p_FB = {centre_.x, centre_.y, parameters.ball_radius};
  keep_apart();
}

// Not std::uniform_real_distribution: the standard does not say which numbers that gives.
double Match::uniform(double from, double to) {
  const double share = static_cast<double>(random_()) / 4294967296.0;
  return from + share * (to - from);
}

void Match::advance_to(double seconds) {
  while (time() + kStep <= seconds + 1e-9) {
    step();
  }
}

void Match::step() {
  const std::size_t own = parameters_.own.size();
  const std::size_t all = state_.players.size();
  const std::size_t own_hunter = nearest_to_ball(0, own);
  const std::size_t their_hunter = nearest_to_ball(own, all);
  for (std::size_t i = 0; i < all; ++i) {
    plan(i);
    const bool is_hunter = i == own_hunter || i == their_hunter;
    drive(i, is_hunter ? state_.p_FB.on_floor() : plans_[i].target);
    turn(state_.players[i]);
  }
  keep_apart();
  for (std::size_t i = 0; i < all; ++i) {
    meet_ball(i);
  }
  roll();
  ++steps_;
}

std::size_t Match::nearest_to_ball(std::size_t from, std::size_t to) const {
  std::size_t best = to;
  double best_distance = 1e9;
  for (std::size_t i = from; i < to; ++i) {
    const Eigen::Vector2d way =
        state_.p_FB.on_floor().vector() - state_.players[i].X_FR.origin().vector();
    if (way.norm() < best_distance) {
      best_distance = way.norm();
      best = i;
    }
  }
  return best;
}

void Match::plan(std::size_t player) {
  Plan& plan = plans_[player];
  const Eigen::Vector2d way = plan.target.vector() - state_.players[player].X_FR.origin().vector();
  if (time() < plan.until && way.norm() > kArrived) {
    return;
  }
  plan.target = {centre_.x + uniform(-1.0, 1.0) * (half_length_ - kMargin),
                 centre_.y + uniform(-1.0, 1.0) * (half_width_ - kMargin)};
  plan.until = time() + uniform(3.0, 8.0);
}

void Match::drive(std::size_t player, const Point<Field>& target) {
  Player& self = state_.players[player];
  const Eigen::Vector2d here = self.X_FR.origin().vector();
  const Eigen::Vector2d way = target.vector() - here;
  // The speed from which it can still stop at the target.
  const double braking = std::sqrt(2.0 * parameters_.max_acceleration * way.norm());
  Eigen::Vector2d wanted =
      way.norm() < 1e-6 ? Eigen::Vector2d(0.0, 0.0)
                        : Eigen::Vector2d(way.normalized() *
                                          std::min(0.7 * braking, 0.8 * parameters_.max_speed));
  for (std::size_t i = 0; i < state_.players.size(); ++i) {
    const Eigen::Vector2d away = here - state_.players[i].X_FR.origin().vector();
    const double distance = away.norm();
    if (i != player && distance < kPersonalSpace && distance > 1e-6) {
      wanted += away * (2.0 * (kPersonalSpace - distance) / distance);
    }
  }
  wanted = limited(wanted, parameters_.max_speed);
  const Eigen::Vector2d change =
      limited(wanted - self.v_FR.vector(), parameters_.max_acceleration * kStep);
  self.v_FR = Velocity<Field>::from(self.v_FR.vector() + change);
  const Eigen::Vector2d next = here + self.v_FR.vector() * kStep;
  self.X_FR = {next.x(), next.y(), self.X_FR.theta() + self.omega * kStep};
}

void Match::turn(Player& player) const {
  const Eigen::Vector2d way = state_.p_FB.on_floor().vector() - player.X_FR.origin().vector();
  const double error = angle_difference(std::atan2(way.y(), way.x()), player.X_FR.theta());
  const double wanted = std::clamp(2.0 * error, -parameters_.max_turn, parameters_.max_turn);
  const double most = parameters_.max_turn_acceleration * kStep;
  player.omega += std::clamp(wanted - player.omega, -most, most);
}

void Match::keep_apart() {
  for (std::size_t i = 0; i < state_.players.size(); ++i) {
    for (std::size_t j = i + 1; j < state_.players.size(); ++j) {
      push_apart(state_.players[i], state_.players[j]);
    }
  }
}

// Bodies that would overlap are pushed apart, and stop moving towards each other.
void Match::push_apart(Player& a, Player& b) const {
  const double least = 2.0 * parameters_.robot_radius + 0.02;
  const Eigen::Vector2d between = b.X_FR.origin().vector() - a.X_FR.origin().vector();
  const double distance = between.norm();
  if (distance >= least) {
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

void Match::meet_ball(std::size_t player) {
  const Player& self = state_.players[player];
  const Eigen::Vector2d way = state_.p_FB.on_floor().vector() - self.X_FR.origin().vector();
  const double touching = parameters_.robot_radius + parameters_.ball_radius;
  const double distance = way.norm();
  if (distance < touching + kReach && time() >= plans_[player].may_kick_at) {
    kick(player);
    return;
  }
  if (distance >= touching) {
    return;
  }
  const Eigen::Vector2d normal =
      distance > 1e-6 ? Eigen::Vector2d(way / distance) : Eigen::Vector2d(1.0, 0.0);
  const Eigen::Vector2d place = self.X_FR.origin().vector() + normal * touching;
  state_.p_FB.x = place.x();
  state_.p_FB.y = place.y();
  const Eigen::Vector2d v_ball(state_.v_FB.x, state_.v_FB.y);
  const double closing = (v_ball - self.v_FR.vector()).dot(normal);
  if (closing < 0.0) {
    const Eigen::Vector2d v = v_ball - normal * ((1.0 + kBounce) * closing);
    state_.v_FB = {v.x(), v.y(), 0.0};
  }
}

void Match::kick(std::size_t player) {
  plans_[player].may_kick_at = time() + 1.0;
  const Eigen::Vector2d target(centre_.x + uniform(-0.8, 0.8) * half_length_,
                               centre_.y + uniform(-0.8, 0.8) * half_width_);
  const Eigen::Vector2d way = target - state_.p_FB.on_floor().vector();
  const Eigen::Vector2d self = state_.players[player].X_FR.origin().vector();
  const Eigen::Vector2d outwards = (state_.p_FB.on_floor().vector() - self).normalized();
  // Never through the kicker's own body.
  const bool is_possible = way.norm() > 1e-6 && way.dot(outwards) > 0.0;
  const Eigen::Vector2d direction = is_possible ? way.normalized() : outwards;
  const Eigen::Vector2d v = direction * uniform(1.5, parameters_.max_kick);
  state_.v_FB = {v.x(), v.y(), 0.0};
}

void Match::roll() {
  Eigen::Vector2d v(state_.v_FB.x, state_.v_FB.y);
  const double speed = v.norm();
  if (speed > 0.0) {
    v *= std::max(speed - parameters_.ball_deceleration * kStep, 0.0) / speed;
  }
  Eigen::Vector2d p(state_.p_FB.x + v.x() * kStep, state_.p_FB.y + v.y() * kStep);
  const Eigen::Vector2d half(half_length_ + 0.3, half_width_ + 0.3);
  for (int axis = 0; axis < 2; ++axis) {
    const double middle = axis == 0 ? centre_.x : centre_.y;
    const double beyond = std::abs(p[axis] - middle) - half[axis];
    if (beyond > 0.0) {
      const double side = p[axis] > middle ? 1.0 : -1.0;
      p[axis] = middle + side * half[axis];
      v[axis] = -kBounce * side * std::abs(v[axis]);
    }
  }
  state_.p_FB = {p.x(), p.y(), parameters_.ball_radius};
  state_.v_FB = {v.x(), v.y(), 0.0};
}

}  // namespace teamsight::sim
