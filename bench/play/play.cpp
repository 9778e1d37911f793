// bench/play/play.cpp: see bench/play/play.hpp.
#include "bench/play/play.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"

namespace teamsight::play {
namespace {

constexpr double kFriction = 0.45;     // m/s^2
constexpr double kGravity = 9.81;      // m/s^2
constexpr double kDrag = 0.012;        // 1/m
constexpr double kLowestBounce = 0.4;  // m/s; slower falls end on the floor
constexpr double kMaxSpeed = 2.5;      // m/s, of a player
constexpr double kMaxAcceleration = 2.5;
constexpr double kReach = 0.08;       // m beyond contact
constexpr double kCrowdRadius = 3.0;  // m

Eigen::Vector2d limited(const Eigen::Vector2d& v, double most) {
  const double length = v.norm();
  return length > most ? Eigen::Vector2d(v * (most / length)) : v;
}

}  // namespace

double uniform(Random& random, double from, double to) {
  return from + (to - from) * (static_cast<double>(random() >> 11U) / 9007199254740992.0);
}

double normal(Random& random, double sigma) {
  return std::normal_distribution<double>(0.0, sigma)(random);
}

Play::Play(const PlayParameters& parameters, const FieldModel& field, std::uint64_t seed)
    : parameters_(parameters),
      half_(0.5 * field.length, 0.5 * field.width),
      wall_(half_.array() + field.surround),
      random_(seed) {
  const int all = parameters.own + parameters.opponents;
  for (int i = 0; i < all; ++i) {
    TruePlayer player;
    const bool is_own = i < parameters.own;
    player.robot = is_own ? static_cast<RobotId>(i + 1) : kNobody;
    const double side = is_own ? -1.0 : 1.0;
    player.X_FR = {side * uniform(random_, 0.5, 0.8 * half_.x()),
                   uniform(random_, -0.8, 0.8) * half_.y(),
                   is_own ? 0.0 : 3.0};
    moment_.players.push_back(player);
    targets_.push_back(player.X_FR.origin().vector());
    next_target_.push_back(0.0);
    may_kick_.push_back(0.5);
  }
  for (int i = 0; i < parameters.balls; ++i) {
    TrueBall ball;
    ball.p_F = {4.0 * i, 1.0 * i, parameters.ball_radius};
    moment_.balls.push_back(ball);
  }
  keep_apart();
}

std::size_t Play::hunter(std::size_t from, std::size_t to) const {
  std::size_t best = from;
  double nearest = 1e9;
  for (std::size_t i = from; i < to; ++i) {
    const double distance =
        (moment_.players[i].X_FR.origin().vector() - moment_.balls[0].p_F.head<2>()).norm();
    if (distance >= nearest) continue;
    nearest = distance;
    best = i;
  }
  return best;
}

void Play::choose_target(std::size_t player) {
  if (moment_.t < next_target_[player]) return;
  next_target_[player] = moment_.t + uniform(random_, 2.0, 6.0);
  Eigen::Vector2d target(uniform(random_, -0.9, 0.9) * half_.x(),
                         uniform(random_, -0.9, 0.9) * half_.y());
  if (parameters_.is_crowd) {
    const double angle = uniform(random_, -3.14, 3.14);
    target = moment_.balls[0].p_F.head<2>() + uniform(random_, 0.6, kCrowdRadius) *
                                                  Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  targets_[player] = target.cwiseMax(-0.95 * half_).cwiseMin(0.95 * half_);
}

void Play::drive(std::size_t player, const Eigen::Vector2d& target) {
  TruePlayer& self = moment_.players[player];
  const Eigen::Vector2d here = self.X_FR.origin().vector();
  const Eigen::Vector2d way = target - here;
  const double braking = 0.7 * std::sqrt(2.0 * kMaxAcceleration * way.norm());
  Eigen::Vector2d wanted = way.norm() < 1e-6
                               ? Eigen::Vector2d(0.0, 0.0)
                               : Eigen::Vector2d(way.normalized() * std::min(braking, 2.0));
  for (std::size_t i = 0; i < moment_.players.size(); ++i) {
    const Eigen::Vector2d away = here - moment_.players[i].X_FR.origin().vector();
    const double distance = away.norm();
    if (i == player || distance > 0.9 || distance < 1e-6) continue;
    wanted += away * (2.0 * (0.9 - distance) / distance);
  }
  self.v_F += limited(limited(wanted, kMaxSpeed) - self.v_F, kMaxAcceleration * kStep);
  const Eigen::Vector2d to_ball = moment_.balls[0].p_F.head<2>() - here;
  const double turn = angle_difference(std::atan2(to_ball.y(), to_ball.x()), self.X_FR.theta());
  const double omega = std::clamp(2.0 * turn, -2.5, 2.5);
  self.omega += std::clamp(omega - self.omega, -6.0 * kStep, 6.0 * kStep);
  const Eigen::Vector2d next = here + self.v_F * kStep;
  self.X_FR = {next.x(), next.y(), self.X_FR.theta() + self.omega * kStep};
}

void Play::keep_apart() {
  const double least = 2.0 * parameters_.robot_radius + 0.02;
  for (std::size_t i = 0; i < moment_.players.size(); ++i) {
    for (std::size_t j = i + 1; j < moment_.players.size(); ++j) {
      TruePlayer& a = moment_.players[i];
      TruePlayer& b = moment_.players[j];
      Eigen::Vector2d between = b.X_FR.origin().vector() - a.X_FR.origin().vector();
      const double distance = std::max(1e-6, between.norm());
      if (distance >= least) continue;
      const Eigen::Vector2d shift = between * (0.5 * (least - distance) / distance);
      a.X_FR = {a.X_FR.x() - shift.x(), a.X_FR.y() - shift.y(), a.X_FR.theta()};
      b.X_FR = {b.X_FR.x() + shift.x(), b.X_FR.y() + shift.y(), b.X_FR.theta()};
    }
  }
}

void Play::kick_if_reached(std::size_t player) {
  if (moment_.t < may_kick_[player]) return;
  const double touching = parameters_.robot_radius + parameters_.ball_radius + kReach;
  const Eigen::Vector2d self = moment_.players[player].X_FR.origin().vector();
  for (TrueBall& ball : moment_.balls) {
    const Eigen::Vector2d away = ball.p_F.head<2>() - self;
    if (ball.p_F.z() > 0.5 || away.norm() > touching) continue;
    kick(ball, away.normalized());
    may_kick_[player] = moment_.t + 1.0;
    return;
  }
}

void Play::kick(TrueBall& ball, const Eigen::Vector2d& away) {
  const Eigen::Vector2d target(uniform(random_, -0.8, 0.8) * half_.x(),
                               uniform(random_, -0.8, 0.8) * half_.y());
  const Eigen::Vector2d way = target - ball.p_F.head<2>();
  // Never through the kicker's own body.
  const Eigen::Vector2d direction = way.dot(away) > 0.0 ? way.normalized() : away;
  const double speed = uniform(random_, parameters_.min_kick, parameters_.max_kick);
  const bool is_high = uniform(random_, 0.0, 1.0) < parameters_.high_share;
  const double climb = is_high ? uniform(random_, 0.5, 0.8) : 0.0;  // rad
  ball.v_F << direction * (speed * std::cos(climb)), speed * std::sin(climb);
  ball.is_flying = is_high;
  ++ball.kicks;
}

void Play::move(TrueBall& ball) const {
  if (ball.is_flying) {
    ball.v_F.z() -= kGravity * kStep;
    ball.v_F -= ball.v_F * (kDrag * ball.v_F.norm() * kStep);
  } else {
    const double speed = ball.v_F.norm();
    if (speed > 0.0) ball.v_F *= std::max(speed - kFriction * kStep, 0.0) / speed;
  }
  ball.p_F += ball.v_F * kStep;
  if (ball.is_flying && ball.p_F.z() < parameters_.ball_radius && ball.v_F.z() < 0.0) {
    ball.p_F.z() = parameters_.ball_radius;
    ball.v_F.z() *= -kClimbKept;
    ball.v_F.head<2>() *= kSpeedKept;
    ball.is_flying = ball.v_F.z() > kLowestBounce;
    if (!ball.is_flying) ball.v_F.z() = 0.0;
    ++ball.bounces;
  }
  for (int axis = 0; axis < 2; ++axis) {
    if (std::abs(ball.p_F(axis)) <= wall_(axis) || ball.p_F(axis) * ball.v_F(axis) < 0.0) continue;
    ball.v_F(axis) *= -0.5;
    ++ball.kicks;
  }
}

void Play::step() {
  const auto own = static_cast<std::size_t>(parameters_.own);
  const std::size_t all = moment_.players.size();
  const std::size_t ours = hunter(0, own);
  const std::size_t theirs = hunter(own, all);
  for (std::size_t i = 0; i < all; ++i) {
    choose_target(i);
    const bool is_hunter = i == ours || (i == theirs && all > own);
    drive(i, is_hunter ? Eigen::Vector2d(moment_.balls[0].p_F.head<2>()) : targets_[i]);
  }
  keep_apart();
  for (std::size_t i = 0; i < all; ++i) kick_if_reached(i);
  for (TrueBall& ball : moment_.balls) move(ball);
  moment_.t += kStep;
}

}  // namespace teamsight::play
