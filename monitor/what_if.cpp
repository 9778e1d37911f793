// monitor/what_if.cpp: see monitor/what_if.hpp.
#include "monitor/what_if.hpp"

#include <algorithm>

namespace teamsight::monitor {

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
  if (!sample.message || !fusion_ || !clock_.is_known()) return;
  const bus::Sightings& seen = *sample.message;
  if (seen.id.robot == robot_) return;
  newest_ = std::max(newest_, clock_.at(sample.received));
  const auto exposure = clock_.moment_of(seen.id.robot, seen.exposure, newest_);
  if (!exposure) return;
  static_cast<void>(fusion_->insert(
      {seen.id, exposure->time, exposure->sigma, seen.posture, seen.balls, seen.obstacles},
      newest_));
}

void WhatIf::hear(const bus::Sample<bus::Explanation>& sample) {
  clock_.hear(sample);
}

void WhatIf::hear(const bus::Sample<WorldModel>& sample) {
  clock_.hear(sample);
  if (!sample.message || !fusion_) return;
  fusion_->adopt_ids(*sample.message, to_host_time(sample.message->stamp, Duration{0}));
}

std::optional<WorldWithout> WhatIf::at(HostTime now) {
  if (now >= until_) fusion_.reset();
  if (!fusion_ || !clock_.is_known()) return std::nullopt;
  newest_ = std::max(newest_, clock_.at(now));
  return WorldWithout{robot_, fusion_->world_at(newest_)};
}

}  // namespace teamsight::monitor
