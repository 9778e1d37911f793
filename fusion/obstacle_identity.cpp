// fusion/obstacle_identity.cpp: see fusion/obstacle_identity.hpp.
#include "fusion/obstacle_identity.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/LU>

namespace teamsight::fusion {
namespace {

bool has_key(const KnownObstacles& known, std::uint32_t key) {
  return std::ranges::any_of(known, [key](const KnownObstacle& one) { return one.key == key; });
}

bool has_key(const TrackList& tracks, std::uint32_t key) {
  return std::ranges::any_of(tracks, [key](const Track& track) { return track.book.key == key; });
}

/// Whether it was dropped because another track covers it: that one is the obstacle then.
bool is_covered(const KnownObstacle& one, const TrackList& tracks, double distance) {
  return std::ranges::any_of(tracks, [&](const Track& track) {
    return (track.state.mean.head<2>() - one.moments.mean.head<2>()).norm() < distance;
  });
}

/// Density of the found track's place, of the lost one's that has moved on since; 1/m^2.
double density_of(const Track& found, const KnownObstacle& lost, const TrackParameters& obstacle) {
  const PlanarMoments moved = predicted(lost.moments,
                                        std::max(0.0, to_seconds(found.book.time - lost.time)),
                                        {obstacle.acceleration_psd, obstacle.velocity_decay});
  const Eigen::Vector2d gap = (found.state.mean - moved.mean).head<2>();
  const Eigen::Matrix2d cov = (found.state.cov + moved.cov).topLeftCorner<2, 2>();
  return std::exp(-0.5 * gap.dot(cov.inverse() * gap)) /
         (2.0 * std::numbers::pi * std::sqrt(cov.determinant()));
}

void remember(KnownObstacles& lost, const KnownObstacle& one) {
  if (lost.is_full()) lost.erase(0);
  lost.push_back(one);
}

void note_lost(const TrackList& tracks,
               const KnownObstacles& before,
               KnownObstacles& lost,
               const Parameters& parameters) {
  for (const KnownObstacle& one : before) {
    if (has_key(tracks, one.key) || one.proven <= 0.0) continue;
    if (!is_covered(one, tracks, parameters.obstacle.merge_distance)) remember(lost, one);
  }
}

/// Which of the lost ones the track is, or how many there are.
std::size_t forerunner_of(const Track& found,
                          const KnownObstacles& lost,
                          const Parameters& parameters) {
  std::size_t best = lost.size();
  double most = parameters.newcomer.density;
  for (std::size_t i = 0; i < lost.size(); ++i) {
    if (lost[i].last_hit > found.book.born) continue;
    const double density = density_of(found, lost[i], parameters.obstacle);
    if (density <= most) continue;
    most = density;
    best = i;
  }
  return best;
}

}  // namespace

KnownObstacles known_obstacles(const TrackList& tracks) {
  KnownObstacles known;
  for (const Track& track : tracks) {
    const TrackBook& book = track.book;
    if (!book.is_confirmed) continue;
    known.push_back(
        {book.key, book.last_hit, book.time, book.proven, {track.state.mean, track.state.cov}});
  }
  return known;
}

void recognise(TrackList& tracks,
               const KnownObstacles& before,
               KnownObstacles& lost,
               HostTime exposure,
               const Parameters& parameters) {
  note_lost(tracks, before, lost, parameters);
  for (std::size_t i = lost.size(); i-- > 0;) {
    if (exposure - lost[i].last_hit > parameters.newcomer.lost_memory) lost.erase(i);
  }
  for (Track& track : tracks) {
    if (!track.book.is_confirmed || has_key(before, track.book.key)) continue;
    const std::size_t old = forerunner_of(track, lost, parameters);
    if (old == lost.size()) continue;
    track.book.key = lost[old].key;
    if (lost[old].proven > parameters.obstacle.most_vote) track.book.doubt = 0.0;
    lost.erase(old);
  }
}

}  // namespace teamsight::fusion
