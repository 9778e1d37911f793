// bench/play/perception.cpp: see bench/play/perception.hpp.
#include "bench/play/perception.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"

namespace teamsight::play {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kConfidence = 0.9;

/// Whether the line of sight from `from` to `to` passes through another player's body.
bool is_hidden(const Moment& moment,
               const Eigen::Vector2d& from,
               const Eigen::Vector2d& to,
               double body,
               const TruePlayer* watched) {
  const Eigen::Vector2d way = to - from;
  const double distance = way.norm();
  for (const TruePlayer& player : moment.players) {
    const Eigen::Vector2d at = player.X_FR.origin().vector() - from;
    if (&player == watched || at.norm() < 1e-9) continue;
    const double along = at.dot(way) / distance;
    const double aside = std::abs(at.x() * way.y() - at.y() * way.x()) / distance;
    if (along > 0.0 && along < distance - body && aside < 0.9 * body) return true;
  }
  return false;
}

/// Falls from 0.95 near by to 0.3 at the end of the range.
double detection_probability(double distance, double range) {
  if (distance >= range) return 0.0;
  const double far = distance / range;
  return 0.95 - 0.65 * far * far;
}

}  // namespace

Perception::Perception(const PerceptionParameters& parameters, RobotId robot, std::uint64_t seed)
    : parameters_(parameters),
      robot_(robot),
      random_(seed) {
  slow_.scale = normal(random_, parameters.sigma_scale);
  slow_.azimuth_offset = normal(random_, parameters.sigma_azimuth_offset);
  const double p = parameters.sigma_posture_position;
  slow_.posture << normal(random_, p), normal(random_, p),
      normal(random_, parameters.sigma_posture_heading);
  claim_ = std::exp(uniform(random_, -0.2, 0.2));
}

double Perception::heavy(double sigma) {
  return sigma * std::student_t_distribution<double>(4.0)(random_);
}

void Perception::age(double since) {
  const double keep = std::exp(-since / parameters_.posture_memory);
  const double fresh = std::sqrt(1.0 - keep * keep);
  const double p = parameters_.sigma_posture_position * fresh;
  const Eigen::Vector3d news(normal(random_, p),
                             normal(random_, p),
                             normal(random_, parameters_.sigma_posture_heading * fresh));
  slow_.posture = keep * slow_.posture + news;
  const double keep_d = std::exp(-since / parameters_.direction_memory);
  const double d = parameters_.sigma_direction_slow * std::sqrt(1.0 - keep_d * keep_d);
  slow_.direction =
      keep_d * slow_.direction + Eigen::Vector2d(normal(random_, d), normal(random_, d));
}

void Perception::set_fault(Fault fault, const Moment& moment) {
  fault_ = fault;
  fault_offset_.setZero();
  if (fault == Fault::kBiased) {
    const double angle = uniform(random_, -kPi, kPi);
    fault_offset_ << 0.5 * std::cos(angle), 0.5 * std::sin(angle), 0.0;
  }
  if (fault != Fault::kKidnapped) return;
  // It was carried away and does not know: its posture stays wrong by the way it was carried.
  const Pose<Field, Robot>& true_X = moment.players[static_cast<std::size_t>(robot_) - 1].X_FR;
  fault_offset_ << uniform(random_, -8.0, 8.0) - true_X.x(),
      uniform(random_, -5.0, 5.0) - true_X.y(), uniform(random_, 1.0, 5.0);
}

PostureEstimate Perception::claimed_posture(const TruePlayer& self) const {
  PostureEstimate posture;
  posture.status = PostureStatus::kOk;
  posture.half_log_odds = 6.0;
  const Eigen::Vector3d at = self.X_FR.vector() + slow_.posture + fault_offset_;
  posture.X_FR = {at.x(), at.y(), at.z()};
  if (fault_ == Fault::kMirrored) posture.X_FR = mirrored(posture.X_FR);
  const double p = claim_ * parameters_.sigma_posture_position;
  const double h = claim_ * parameters_.sigma_posture_heading;
  posture.cov = Eigen::Vector3d(p * p, p * p, h * h).asDiagonal();
  posture.inlier_ratio = 0.9;
  posture.line_points = 80;
  return posture;
}

void Perception::see_ball(const Eigen::Vector3d& p_RB, double radius, fusion::Observation& frame) {
  const double range = p_RB.head<2>().norm() * (1.0 + slow_.scale);
  const double drop = kMirrorHeight - p_RB.z();
  const double azimuth = std::atan2(p_RB.y(), p_RB.x()) + slow_.azimuth_offset +
                         slow_.direction.x() + heavy(parameters_.sigma_direction);
  const double elevation =
      -std::atan2(drop, range) + slow_.direction.y() + heavy(parameters_.sigma_direction);
  BallRay ray;
  ray.ray_R.origin = {0.0, 0.0, kMirrorHeight};
  ray.ray_R.direction << std::cos(elevation) * std::cos(azimuth),
      std::cos(elevation) * std::sin(azimuth), std::sin(elevation);
  // Student's t with 4 degrees has twice its scale's variance.
  const double var = claim_ * claim_ *
                     (2.0 * std::pow(parameters_.sigma_direction, 2) +
                      std::pow(parameters_.sigma_direction_slow, 2));
  ray.cov_direction = var * Eigen::Matrix2d::Identity();
  const double angular = std::asin(std::min(0.9, radius / std::hypot(p_RB.head<2>().norm(), drop)));
  ray.sigma_angular_radius = parameters_.share_radius * angular;
  ray.angular_radius = std::max(1e-4, angular + normal(random_, ray.sigma_angular_radius));
  ray.confidence = kConfidence;
  if (frame.balls.size() < kMaxBallRays) frame.balls.push_back(ray);
}

void Perception::see_obstacle(const Eigen::Vector2d& p_RO,
                              double radius,
                              fusion::Observation& frame) {
  const double distance = std::max(0.1, p_RO.norm() - radius);
  const double sigma_along = 0.03 + 0.012 * distance * distance;
  const double sigma_across = 0.015 + 0.006 * distance;
  const double azimuth =
      std::atan2(p_RO.y(), p_RO.x()) + slow_.azimuth_offset + heavy(0.7 * sigma_across) / distance;
  const double range = std::max(0.05, distance * (1.0 + slow_.scale) + heavy(0.7 * sigma_along));
  const Eigen::Matrix2d turn = (Eigen::Matrix2d() << std::cos(azimuth),
                                -std::sin(azimuth),
                                std::sin(azimuth),
                                std::cos(azimuth))
                                   .finished();
  ObstacleSighting sighting;
  sighting.p_RO = {range * std::cos(azimuth), range * std::sin(azimuth)};
  const Eigen::Vector2d var(std::pow(claim_ * sigma_along, 2), std::pow(claim_ * sigma_across, 2));
  sighting.cov_R = turn * var.asDiagonal() * turn.transpose();
  sighting.width = std::max(0.1, 2.0 * radius + normal(random_, 0.05));
  sighting.confidence = kConfidence;
  if (frame.obstacles.size() < kMaxObstacleSightings) frame.obstacles.push_back(sighting);
}

void Perception::see_balls(const Moment& moment,
                           const TruePlayer& self,
                           const PlayParameters& play,
                           fusion::Observation& frame) {
  seen_balls_ = 0;
  const Eigen::Vector2d here = self.X_FR.origin().vector();
  for (std::size_t i = 0; i < moment.balls.size(); ++i) {
    const Eigen::Vector3d& p_F = moment.balls[i].p_F;
    const double distance = (p_F.head<2>() - here).norm();
    const bool is_low = p_F.z() < 0.4;
    if (is_low && is_hidden(moment, here, p_F.head<2>(), play.robot_radius, nullptr)) continue;
    const double probability = detection_probability(distance, parameters_.ball_range);
    if (uniform(random_, 0.0, 1.0) >= probability) continue;
    const Point3<Robot> p_RB = self.X_FR.inverse() * Point3<Field>::from(p_F);
    see_ball(p_RB.vector(), play.ball_radius, frame);
    seen_balls_ |= 1U << i;
  }
}

void Perception::see_players(const Moment& moment,
                             const TruePlayer& self,
                             const PlayParameters& play,
                             fusion::Observation& frame) {
  seen_players_ = 0;
  const Eigen::Vector2d here = self.X_FR.origin().vector();
  for (std::size_t i = 0; i < moment.players.size(); ++i) {
    const TruePlayer& player = moment.players[i];
    if (&player == &self) continue;
    const Eigen::Vector2d there = player.X_FR.origin().vector();
    if (is_hidden(moment, here, there, play.robot_radius, &player)) continue;
    const double probability =
        detection_probability((there - here).norm(), parameters_.obstacle_range);
    if (uniform(random_, 0.0, 1.0) >= probability) continue;
    see_obstacle(
        (self.X_FR.inverse() * Point<Field>::from(there)).vector(), play.robot_radius, frame);
    seen_players_ |= std::uint64_t{1} << i;
  }
}

void Perception::see_phantoms(double since,
                              const PlayParameters& play,
                              fusion::Observation& frame) {
  for (const bool is_ball : {true, false}) {
    const double rate = is_ball ? parameters_.false_balls : parameters_.false_obstacles;
    const double draw = uniform(random_, 0.0, 1.0);
    const double lasting = parameters_.phantoms * since / 60.0;
    if (draw >= rate + lasting) continue;
    const double angle = uniform(random_, -kPi, kPi);
    const double distance = uniform(random_, 1.0, 6.0);
    const double stays = draw < lasting ? 1.0 : 0.0;
    phantoms_.push_back({{distance * std::cos(angle), distance * std::sin(angle)}, stays, is_ball});
  }
  for (Phantom& phantom : phantoms_) {
    if (phantom.is_ball) {
      see_ball({phantom.p_R.x(), phantom.p_R.y(), play.ball_radius}, play.ball_radius, frame);
    } else {
      see_obstacle(phantom.p_R, play.robot_radius, frame);
    }
    phantom.left -= since;
  }
  std::erase_if(phantoms_, [](const Phantom& phantom) { return phantom.left <= 0.0; });
}

fusion::Observation Perception::look(const Moment& moment,
                                     double since,
                                     const PlayParameters& play) {
  age(since);
  const TruePlayer& self = moment.players[static_cast<std::size_t>(robot_) - 1];
  fusion::Observation frame;
  frame.id = {robot_, 1000U + robot_, ++sequence_};
  frame.posture = claimed_posture(self);
  see_balls(moment, self, play, frame);
  see_players(moment, self, play, frame);
  see_phantoms(since, play, frame);
  return frame;
}

}  // namespace teamsight::play
