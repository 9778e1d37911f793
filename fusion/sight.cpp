// fusion/sight.cpp: see fusion/sight.hpp.
#include "fusion/sight.hpp"

#include <algorithm>

namespace teamsight::fusion {
namespace {

bool is_known(const Eigen::Matrix2d& cov, const EyesightParameters& parameters) {
  return 0.5 * cov.trace() <= parameters.sigma * parameters.sigma;
}

/// A teammate of which it is known where it stands.
struct Standing {
  std::size_t index{0};  ///< in State::teammates
  Eigen::Vector2d p_F{Eigen::Vector2d::Zero()};
};

using StandingList = InlineList<Standing, kMaxRobotId>;

StandingList standing_mates(const State& state,
                            const Glance& glance,
                            const Parameters& parameters) {
  StandingList list;
  for (std::size_t i = 0; i < state.teammates.size(); ++i) {
    const Teammate& mate = state.teammates[i];
    if (mate.robot == glance.robot || mate.posture.time == kNever ||
        glance.exposure - mate.seen > parameters.eyesight.fresh ||
        quarantine_at(state, mate, glance.exposure, parameters) != Quarantine::kNone) {
      continue;
    }
    const auto carried = carried_to(mate.posture, glance.exposure, parameters.teammate);
    if (!is_known(carried.cov.topLeftCorner<2, 2>(), parameters.eyesight)) continue;
    list.push_back({i, carried.X_FR.origin().vector()});
  }
  return list;
}

/// Whether another robot than the observer has just seen it, and more than one ever did.
bool is_vouched_for(const Track& track, const Glance& glance, const Parameters& parameters) {
  if (!track.book.is_confirmed ||
      !is_known(track.state.cov.topLeftCorner<2, 2>(), parameters.eyesight)) {
    return false;
  }
  const RobotMask robots =
      robots_within(track.book.supported, glance.exposure, parameters.eyesight.fresh);
  return (robots & ~robot_bit(glance.robot)) != 0 &&
         log_odds_of(track.book) > parameters.obstacle.most_vote;
}

}  // namespace

Sight sight_of(const State& state,
               const Teammate& observer,
               const Glance& glance,
               const Parameters& parameters) {
  Sight sight{observer.eyes,
              parameters.eyesight,
              observer.eyes.news_of(glance.exposure, parameters.eyesight),
              {}};
  const Eigen::Vector2d from_F = glance.observer();
  for (const Standing& mate : standing_mates(state, glance, parameters)) {
    sight.shadows.push_back(shadow_of(mate.p_F, parameters.robot_radius, from_F));
  }
  for (const Track& track : state.obstacles) {
    if (sight.shadows.is_full()) break;
    if (!track.book.is_confirmed || log_odds_of(track.book) <= 0.0) continue;
    const PlanarMoments moments = moments_at(track, glance.exposure, parameters.obstacle);
    if (!is_known(moments.cov.topLeftCorner<2, 2>(), parameters.eyesight)) continue;
    sight.shadows.push_back(shadow_of(moments.mean.head<2>(), track.radius, from_F));
  }
  return sight;
}

void learn_eyesight(State& state,
                    Teammate& observer,
                    const MateSightings& mates,
                    const Scene& scene,
                    const Parameters& parameters) {
  const Glance& glance = scene.glance;
  observer.eyes.turn_to(glance.exposure, parameters.eyesight);
  const auto learn = [&](const Eigen::Vector2d& p_F, bool is_reported) {
    if (!is_reported && is_hidden(p_F, scene)) return;
    observer.eyes.note((p_F - glance.observer()).norm(), is_reported);
  };
  for (const Standing& mate : standing_mates(state, glance, parameters)) {
    const auto& of = mates.mate_of;
    learn(mate.p_F, std::find(of.begin(), of.end(), static_cast<int>(mate.index)) != of.end());
  }
  for (const Track& track : state.obstacles) {
    if (!is_vouched_for(track, glance, parameters)) continue;
    const std::size_t index = static_cast<std::size_t>(glance.robot) - 1U;
    learn(track.state.mean.head<2>(), track.book.supported[index] == glance.exposure);
  }
}

}  // namespace teamsight::fusion
