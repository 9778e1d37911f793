// bench/mrclam/score.cpp: see bench/mrclam/score.hpp.
#include "bench/mrclam/score.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "fusion/fusion.hpp"
#include "geometry/angle.hpp"
#include "geometry/uncertainty.hpp"

namespace teamsight::mrclam {
namespace {

constexpr double kPeriod = 0.1;        // s between two comparisons
constexpr double kSettled = 10.0;      // s until what is known at the start is used up
constexpr double kRobotRadius = 0.17;  // m
constexpr double kMargin = 1.5;        // m beyond the landmarks that robots may go
// That a robot right beside it reports another: cameras look ahead only, and read codes now and
// then.
constexpr double kDetection = 0.05;

using Landmarks = std::map<int, Eigen::Vector2d>;

HostTime host_time(double t) {
  return HostTime{} + std::chrono::hours(1) + from_seconds(t);
}

/// The ground that the landmarks stand on.
FieldModel ground_of(const RobotLogs& logs) {
  Eigen::Vector2d least = Eigen::Vector2d::Constant(1e9);
  Eigen::Vector2d most = -least;
  for (const auto& [subject, p_F] : logs.landmarks) {
    least = least.cwiseMin(p_F);
    most = most.cwiseMax(p_F);
  }
  FieldModel field;
  field.centre = Point<Field>::from(0.5 * (least + most));
  field.length = most.x() - least.x();
  field.width = most.y() - least.y();
  field.surround = kMargin;
  return field;
}

/// One robot: its log, its filter, and what it tells the team.
class Mate {
 public:
  Mate(RobotId robot, const RobotLog& log, const SenseErrors& errors)
      : robot_(robot),
        log_(log),
        errors_(errors),
        filter_(errors, log.truth_at(0.0)) {}

  /// Goes on to `t` and looks at what was seen until then.
  ///
  /// @param landmarks  that it may look at
  /// @return one observation for each moment with a sighting, or one at `t` if there was none
  [[nodiscard]] std::vector<fusion::Observation> go_to(double t, const Landmarks& landmarks) {
    std::vector<fusion::Observation> told;
    while (next_seen_ < log_.seen.size() && log_.seen[next_seen_].t <= t) {
      const double at = log_.seen[next_seen_].t;
      roll_to(at);
      const std::vector<Seen> robots = look_at_moment(at, landmarks);
      if (at >= 0.0) told.push_back(tell(at, robots));
    }
    roll_to(t);
    if (told.empty()) told.push_back(tell(t, {}));
    return told;
  }

  [[nodiscard]] const LandmarkFilter& filter() const { return filter_; }

 private:
  /// Takes in all that was seen at `t`. @return the robots among it
  [[nodiscard]] std::vector<Seen> look_at_moment(double t, const Landmarks& landmarks) {
    std::vector<Seen> robots;
    for (; next_seen_ < log_.seen.size() && log_.seen[next_seen_].t == t; ++next_seen_) {
      const Seen& seen = log_.seen[next_seen_];
      const auto landmark = landmarks.find(seen.subject);
      if (landmark != landmarks.end()) filter_.look(seen, landmark->second);
      if (seen.subject >= 1 && seen.subject <= kRobots) robots.push_back(seen);
    }
    return robots;
  }

  /// With what the wheels said last, as they say it.
  void roll_to(double t) {
    while (now_ < t) {
      const bool has_next = next_wheels_ < log_.wheels.size() && log_.wheels[next_wheels_].t <= t;
      const double until = has_next ? std::max(now_, log_.wheels[next_wheels_].t) : t;
      if (next_wheels_ > 0) filter_.roll(log_.wheels[next_wheels_ - 1], until - now_);
      now_ = until;
      if (has_next) ++next_wheels_;
    }
  }

  [[nodiscard]] fusion::Observation tell(double t, const std::vector<Seen>& robots) {
    fusion::Observation observation;
    observation.id = {robot_, 1000U + robot_, ++sequence_};
    observation.exposure = host_time(t);
    PostureEstimate& posture = observation.posture;
    posture.status = PostureStatus::kOk;
    posture.half_log_odds = 6.0;
    const Eigen::Vector3d& mean = filter_.mean();
    posture.X_FR = {mean.x(), mean.y(), mean.z()};
    posture.cov = filter_.cov();
    for (const Seen& seen : robots) observation.obstacles.push_back(sighting_of(seen));
    return observation;
  }

  [[nodiscard]] ObstacleSighting sighting_of(const Seen& seen) const {
    const double c = std::cos(seen.bearing);
    const double s = std::sin(seen.bearing);
    const double foot = seen.range - kRobotRadius;
    ObstacleSighting sighting;
    sighting.p_RO = {c * foot, s * foot};
    Eigen::Matrix2d turn;
    turn << c, -s, s, c;
    const Eigen::Vector2d sigma(errors_.sigma_range, seen.range * errors_.sigma_bearing);
    sighting.cov_R = turn * sigma.cwiseAbs2().asDiagonal() * turn.transpose();
    sighting.width = 2.0 * kRobotRadius;
    sighting.confidence = 0.9;
    sighting.teammate_likelihood = 0.9;
    return sighting;
  }

  RobotId robot_;
  const RobotLog& log_;
  SenseErrors errors_;
  LandmarkFilter filter_;
  double now_{0.0};
  std::size_t next_wheels_{0};
  std::size_t next_seen_{0};
  std::uint32_t sequence_{0};
};

struct Errors {
  Eigen::Vector3d gap;
  double nees{0.0};  // per degree of freedom
};

Errors errors_of(const Eigen::Vector3d& said,
                 const Eigen::Matrix3d& cov,
                 const Pose<Field, Robot>& truth) {
  Errors errors;
  errors.gap = said - truth.vector();
  errors.gap(2) = angle_difference(said(2), truth.theta());
  errors.nees = squared_mahalanobis(errors.gap, cov) / 3.0;
  return errors;
}

void compare(const Mate& mate,
             const WorldTeammate& known,
             const Pose<Field, Robot>& truth,
             PostureScore& score) {
  const Errors alone = errors_of(mate.filter().mean(), mate.filter().cov(), truth);
  const Errors team = errors_of(known.X_FR.vector(), known.cov, truth);
  score.alone.add(alone.gap.head<2>().squaredNorm());
  score.team.add(team.gap.head<2>().squaredNorm());
  score.heading_alone.add(alone.gap(2) * alone.gap(2));
  score.heading_team.add(team.gap(2) * team.gap(2));
  score.nees_alone.add(alone.nees);
  score.nees_team.add(team.nees);
  if (known.quarantine != Quarantine::kNone) ++score.quarantined;
}

/// All robots, and the fusion that hears them without loss or delay.
class Team {
 public:
  Team(const RobotLogs& logs, std::optional<RobotId> blind)
      : logs_(logs),
        blind_(blind),
        fusion_(parameters(), ground_of(logs)) {
    for (std::size_t i = 0; i < kRobots; ++i) {
      mates_.emplace_back(static_cast<RobotId>(i + 1), logs.robots[i], SenseErrors{});
    }
  }

  void go_to(double t) {
    const Landmarks none;
    for (std::size_t i = 0; i < kRobots; ++i) {
      const bool is_blind = blind_ && i + 1 == *blind_ && t > kSettled;
      for (const auto& observation : mates_[i].go_to(t, is_blind ? none : logs_.landmarks)) {
        static_cast<void>(fusion_.insert(observation, host_time(t)));
      }
    }
  }

  void compare_at(double t, PostureScores& scores) const {
    for (const WorldTeammate& known : fusion_.world_at(host_time(t)).teammates) {
      const auto i = static_cast<std::size_t>(known.robot) - 1;
      compare(mates_[i], known, logs_.robots[i].truth_at(t), scores[i]);
    }
  }

 private:
  static fusion::Parameters parameters() {
    fusion::Parameters parameters;
    parameters.robot_radius = kRobotRadius;
    parameters.obstacle.detection_probability = kDetection;
    return parameters;
  }

  const RobotLogs& logs_;
  std::optional<RobotId> blind_;
  fusion::Fusion fusion_;
  std::vector<Mate> mates_;
};

}  // namespace

PostureScores score_postures(const RobotLogs& logs, std::optional<RobotId> blind) {
  Team team(logs, blind);
  PostureScores scores;
  const auto count = static_cast<int>(logs.duration / kPeriod);
  for (int i = 1; i < count; ++i) {
    const double t = i * kPeriod;
    team.go_to(t);
    if (t >= kSettled) team.compare_at(t, scores);
  }
  return scores;
}

}  // namespace teamsight::mrclam
