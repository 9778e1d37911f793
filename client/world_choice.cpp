// client/world_choice.cpp: see client/world_choice.hpp.
#include "client/world_choice.hpp"

#include <algorithm>

namespace teamsight {
namespace {

constexpr Duration kWindow = std::chrono::minutes(1);

}  // namespace

void RelativeAge::heard(const ObservationId& maker, PeerTime stamp, HostTime now) {
  if (maker.robot != robot_ || maker.boot != boot_) {
    *this = RelativeAge{};
    robot_ = maker.robot;
    boot_ = maker.boot;
    begun_ = now;
  }
  if (now - begun_ > kWindow) {
    older_ = newer_;
    newer_.reset();
    begun_ = now;
  }
  const Duration delay = now.time_since_epoch() - stamp.time_since_epoch();
  newer_ = newer_ ? std::min(*newer_, delay) : delay;
}

Duration RelativeAge::age_of(PeerTime stamp, HostTime now) const {
  const Duration quickest =
      std::min(newer_.value_or(Duration::max()), older_.value_or(Duration::max()));
  return now.time_since_epoch() - stamp.time_since_epoch() - quickest;
}

void WorldChoice::heard_leader(const WorldModel& model, HostTime now) {
  leader_clock_.heard(model.id, model.stamp, now);
  leader_ = model;
}

void WorldChoice::heard_own_host(const WorldModel& model) {
  own_host_ = model;
}

World WorldChoice::freshest(HostTime now) const {
  if (leader_) {
    const Duration age = leader_clock_.age_of(leader_->stamp, now);
    if (age <= parameters_.leader) return {Source::kLeader, *leader_, age};
  }
  if (own_host_) {
    const Duration age = now - to_host_time(own_host_->stamp, Duration{0});
    if (age <= parameters_.own_host) return {Source::kOwnHost, *own_host_, age};
  }
  return {};
}

}  // namespace teamsight
