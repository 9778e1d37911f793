// monitor/what_if.cpp: see monitor/what_if.hpp.
#include "monitor/what_if.hpp"

#include <algorithm>
#include <chrono>

namespace teamsight::monitor {
namespace {

constexpr Duration kPlausible = std::chrono::seconds(1);

struct Moment {
  HostTime time;
  Duration sigma{0};
};

/// A robot's stamp in the leader's time; nothing: its clock is not known.
std::optional<Moment> in_leaders_time(const std::optional<bus::Explanation>& clocks,
                                      RobotId robot,
                                      PeerTime stamp,
                                      HostTime now) {
  if (clocks) {
    const auto known = std::ranges::find(clocks->robots, robot, &bus::ExplainedRobot::robot);
    if (known != clocks->robots.end() && known->clock_sigma > Duration{0}) {
      return Moment{to_host_time(stamp, known->clock_offset), known->clock_sigma};
    }
  }
  const HostTime same = to_host_time(stamp, Duration{0});
  const bool is_plausible = same <= now + kPlausible && same + kPlausible >= now;
  return is_plausible ? std::optional(Moment{same}) : std::nullopt;
}

}  // namespace

WhatIf::WhatIf(const fusion::Parameters& parameters, const FieldModel& field)
    : fresh_(parameters, field) {}

void WhatIf::ask(RobotId robot, HostTime until) {
  if (!fusion_ || robot != robot_) {
    fusion_ = fresh_;
    newest_ = {};
  }
  robot_ = robot;
  until_ = until;
}

void WhatIf::hear(const bus::Sample<bus::Sightings>& sample) {
  if (!sample.message || !fusion_ || !has_leader_) return;
  const bus::Sightings& seen = *sample.message;
  if (seen.id.robot == robot_) return;
  newest_ = std::max(newest_, leaders_time(sample.received));
  const auto exposure = in_leaders_time(clocks_, seen.id.robot, seen.exposure, newest_);
  if (!exposure) return;
  static_cast<void>(fusion_->insert(
      {seen.id, exposure->time, exposure->sigma, seen.posture, seen.balls, seen.obstacles},
      newest_));
}

void WhatIf::hear(const bus::Sample<bus::Explanation>& sample) {
  if (sample.message) clocks_ = sample.message;
}

void WhatIf::hear(const bus::Sample<WorldModel>& sample) {
  if (!sample.message) return;
  const HostTime stamp = to_host_time(sample.message->stamp, Duration{0});
  leader_minus_host_ = stamp - sample.received;
  has_leader_ = true;
  if (fusion_) fusion_->adopt_ids(*sample.message, stamp);
}

std::optional<WorldWithout> WhatIf::at(HostTime now) {
  if (now >= until_) fusion_.reset();
  if (!fusion_ || !has_leader_) return std::nullopt;
  newest_ = std::max(newest_, leaders_time(now));
  return WorldWithout{robot_, fusion_->world_at(newest_)};
}

}  // namespace teamsight::monitor
