// agent/locator.cpp: see locator.hpp.
#include "agent/locator.hpp"

#include <algorithm>
#include <utility>

namespace teamsight::agent {
namespace {

constexpr double kLongestCoast = 0.5;  // s; a velocity older than this is not known

}  // namespace

Locator::Locator(const FieldModel& field, const vision::LocalisationParameters& parameters)
    : localiser_(field, parameters),
      state_(localiser_.begin()),
      search_(std::make_unique<SearchThread>(field)) {}

vision::PostureResult Locator::see(const vision::Perception::Cues& cues, HostTime exposure) {
  goals_.clear();
  for (const vision::SeenGoal& goal : cues.goals) goals_.push_back(vision::bearing_of(goal));
  const vision::FrameEvidence frame{exposure, cues.line_points, goals_};
  const vision::Located located = localiser_.see(state_, frame);
  if (auto request = localiser_.wanted_search(state_, frame)) search_->ask(std::move(*request));
  vision::PostureResult result;
  result.estimate = located.posture;
  result.scale = located.scale;
  result.tilt = located.tilt;
  return result;
}

void Locator::place(const Pose<Field, Robot>& X_FR, const Eigen::Matrix3d& cov, HostTime when) {
  localiser_.place(state_, X_FR, cov, when);
}

void Locator::roll(const bus::Odometry& odometry) {
  const HostTime stamp = to_host_time(odometry.stamp, Duration{0});
  localiser_.roll(state_,
                  {stamp,
                   odometry.X_DR,
                   odometry.v_R,
                   odometry.omega,
                   odometry.sigma_v,
                   odometry.sigma_omega,
                   odometry.slipping});
  if (odometry.sigma_gyro > 0.0) {
    localiser_.turn(state_, {stamp, odometry.gyro, odometry.sigma_gyro});
  }
  if (odometry.sigma_heading > 0.0) {
    localiser_.point(state_, {stamp, odometry.heading, odometry.sigma_heading});
  }
}

void Locator::hear(const WorldModel& world, RobotId self, std::uint32_t sightings) {
  if (state_.counts.flips != flips_) {
    flips_ = state_.counts.flips;
    flipped_after_ = sightings;
  }
  const auto own = std::ranges::find(world.teammates, self, &WorldTeammate::robot);
  // Evidence about frames before the last flip speaks of the other image.
  if (own == world.teammates.end() || own->frame <= flipped_after_) return;
  localiser_.hear_team(state_, own->half_log_odds_team);
}

void Locator::take_answer() {
  if (const auto answer = search_->take()) localiser_.insert(state_, *answer);
}

std::optional<vision::Hypothesis> Locator::moving(HostTime when) const {
  if (to_seconds(when - state_.belief.at) > kLongestCoast) return std::nullopt;
  return localiser_.at(state_, when);
}

Velocity<Robot> Locator::velocity(HostTime when) const {
  if (const auto newest = state_.log.newest(when)) return newest->v_R;
  const auto hypothesis = moving(when);
  return hypothesis ? hypothesis->v_R : Velocity<Robot>{};
}

double Locator::omega(HostTime when) const {
  if (const auto newest = state_.log.newest(when)) return newest->omega;
  const auto hypothesis = moving(when);
  return hypothesis ? hypothesis->omega : 0.0;
}

}  // namespace teamsight::agent
