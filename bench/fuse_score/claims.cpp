// bench/fuse_score/claims.cpp: see claims.hpp.
#include "bench/fuse_score/claims.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fusion/parameters.hpp"
#include "geometry/angle.hpp"
#include "geometry/uncertainty.hpp"

namespace teamsight::score {
namespace {

constexpr double kBallNear = 0.3;    // m
constexpr double kPlayerNear = 0.5;  // m

using Places = std::vector<Eigen::Vector3d>;  // in the true R; m

/// One frame beside its moment.
class Claims {
 public:
  Claims(const play::PlayLog& log, const play::Frame& frame, ClaimTally& tally)
      : frame_(frame),
        play_(log.scenario.play),
        tally_(tally) {
    const play::Moment& moment = log.at(frame.exposure);
    const auto robot = static_cast<std::size_t>(frame.observation.id.robot) - 1;
    X_FR_ = moment.players[robot].X_FR;
    const Pose<Robot, Field> X_RF = X_FR_.inverse();
    for (const play::TrueBall& ball : moment.balls) {
      balls_.push_back((X_RF * Point3<Field>::from(ball.p_F)).vector());
    }
    for (std::size_t i = 0; i < moment.players.size(); ++i) {
      if (i == robot) continue;
      const Eigen::Vector2d p_R = (X_RF * moment.players[i].X_FR.origin()).vector();
      players_.emplace_back(p_R.x(), p_R.y(), 0.0);
    }
  }

  void count() {
    count_posture();
    count_balls();
    count_obstacles();
  }

 private:
  void count_posture() {
    const PostureEstimate& posture = frame_.observation.posture;
    const Eigen::Vector3d error(posture.X_FR.x() - X_FR_.x(),
                                posture.X_FR.y() - X_FR_.y(),
                                angle_difference(posture.X_FR.theta(), X_FR_.theta()));
    tally_.posture.add(error.head<2>().squaredNorm());
    tally_.posture_nees.add(squared_mahalanobis(error, posture.cov) / 3.0);
  }

  void count_balls() {
    std::vector<bool> shown(balls_.size(), false);
    int false_ones = 0;
    for (const BallRay& ball : frame_.observation.balls) {
      if (ball.confidence < parameters_.ball.min_confidence) continue;
      const auto truth = ball_on(ball);
      if (truth) {
        shown[*truth] = true;
        count_ray(ball, balls_[*truth]);
      } else {
        ++false_ones;
      }
    }
    tally_.false_balls.add(false_ones);
    count_shown(balls_, shown, tally_.balls_shown);
  }

  [[nodiscard]] std::optional<std::size_t> ball_on(const BallRay& ball) const {
    std::optional<std::size_t> best;
    double nearest = kBallNear;
    for (std::size_t i = 0; i < balls_.size(); ++i) {
      const Eigen::Vector3d way = balls_[i] - ball.ray_R.origin.vector();
      const double along = way.dot(ball.ray_R.direction);
      const double aside = (way - along * ball.ray_R.direction).norm();
      if (along <= 0.0 || aside >= nearest) continue;
      nearest = aside;
      best = i;
    }
    return best;
  }

  void count_ray(const BallRay& ball, const Eigen::Vector3d& truth) {
    const Eigen::Vector3d way = truth - ball.ray_R.origin.vector();
    const Eigen::Vector3d& said = ball.ray_R.direction;
    const Eigen::Vector2d error(
        angle_difference(std::atan2(said.y(), said.x()), std::atan2(way.y(), way.x())),
        std::atan2(said.z(), said.head<2>().norm()) - std::atan2(way.z(), way.head<2>().norm()));
    tally_.ray_nees.add(squared_mahalanobis(error, ball.cov_direction) / 2.0);
    if (ball.sigma_angular_radius <= 0.0) return;
    const double radius = std::asin(std::min(1.0, play_.ball_radius / way.norm()));
    tally_.radius_nees.add(std::pow((ball.angular_radius - radius) / ball.sigma_angular_radius, 2));
  }

  void count_obstacles() {
    std::vector<bool> shown(players_.size(), false);
    int false_ones = 0;
    for (const ObstacleSighting& obstacle : frame_.observation.obstacles) {
      if (obstacle.confidence < parameters_.obstacle.min_confidence) continue;
      const auto truth = player_at(obstacle);
      if (!truth) {
        ++false_ones;
        continue;
      }
      shown[*truth] = true;
      const Eigen::Vector2d error = obstacle.p_RO.vector() - foot_of(*truth);
      tally_.obstacle.add(error.squaredNorm());
      tally_.obstacle_nees.add(squared_mahalanobis(error, obstacle.cov_R) / 2.0);
    }
    tally_.false_obstacles.add(false_ones);
    count_shown(players_, shown, tally_.players_shown);
  }

  [[nodiscard]] Eigen::Vector2d foot_of(std::size_t player) const {
    const Eigen::Vector2d axis = players_[player].head<2>();
    return axis * (1.0 - play_.robot_radius / axis.norm());
  }

  [[nodiscard]] std::optional<std::size_t> player_at(const ObstacleSighting& obstacle) const {
    std::optional<std::size_t> best;
    double nearest = kPlayerNear;
    for (std::size_t i = 0; i < players_.size(); ++i) {
      const double gap = (obstacle.p_RO.vector() - foot_of(i)).norm();
      if (gap >= nearest) continue;
      nearest = gap;
      best = i;
    }
    return best;
  }

  static void count_shown(const Places& truths,
                          const std::vector<bool>& shown,
                          std::array<MeanTally, ClaimTally::kRings.size()>& rings) {
    for (std::size_t i = 0; i < truths.size(); ++i) {
      const double distance = truths[i].head<2>().norm();
      const auto* const ring = std::ranges::upper_bound(ClaimTally::kRings, distance);
      if (ring == ClaimTally::kRings.end()) continue;
      rings[static_cast<std::size_t>(ring - ClaimTally::kRings.begin())].add(shown[i] ? 1.0 : 0.0);
    }
  }

  const play::Frame& frame_;
  const play::PlayParameters& play_;
  ClaimTally& tally_;
  fusion::Parameters parameters_;
  Pose<Field, Robot> X_FR_;
  Places balls_;
  Places players_;
};

}  // namespace

void ClaimTally::merge(const ClaimTally& other) {
  posture.merge(other.posture);
  posture_nees.merge(other.posture_nees);
  ray_nees.merge(other.ray_nees);
  radius_nees.merge(other.radius_nees);
  obstacle.merge(other.obstacle);
  obstacle_nees.merge(other.obstacle_nees);
  for (std::size_t i = 0; i < kRings.size(); ++i) {
    balls_shown[i].merge(other.balls_shown[i]);
    players_shown[i].merge(other.players_shown[i]);
  }
  false_balls.merge(other.false_balls);
  false_obstacles.merge(other.false_obstacles);
}

ClaimTally count_claims(const play::PlayLog& log) {
  ClaimTally tally;
  for (const play::Frame& frame : log.frames) {
    const fusion::Observation& seen = frame.observation;
    const bool is_faulty = std::ranges::any_of(
        log.scenario.faults, [&](const auto& plan) { return plan.robot == seen.id.robot; });
    if (is_faulty || seen.posture.status == PostureStatus::kLost) continue;
    Claims(log, frame, tally).count();
  }
  return tally;
}

}  // namespace teamsight::score
