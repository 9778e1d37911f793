// fusion/track.cpp: see fusion/track.hpp.
#include "fusion/track.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "fusion/assignment.hpp"
#include "geometry/angle.hpp"
#include "geometry/uncertainty.hpp"

namespace teamsight::fusion {
namespace {

using MomentList = std::array<PlanarMoments, kMaxTracks>;
static_assert(kMaxCandidates <= static_cast<std::size_t>(kMaxAssignmentRows));
static_assert(kMaxTracks <= static_cast<std::size_t>(kMaxAssignmentColumns));

// Dearer than any pair within the gate, so that as many pairs as possible are made.
constexpr double kAlonePrice = 1e4;
// An established track is preferred to one that is just beginning.
constexpr double kTentativePenalty = 6.0;

PlanarMotion motion_of(const TrackParameters& parameters) {
  return {parameters.acceleration_psd, parameters.velocity_decay};
}

std::size_t index_of(RobotId robot) {
  return static_cast<std::size_t>(robot) - 1U;
}

/// The measurement as wide as it is for this track: an uncertain stamp moves a fast thing.
PlanarMeasurement widened(const PlanarMeasurement& measurement,
                          const PlanarMoments& moments,
                          Duration sigma_exposure) {
  PlanarMeasurement wide = measurement;
  const Eigen::Vector2d way = moments.mean.tail<2>() * to_seconds(sigma_exposure);
  wide.cov_F += way * way.transpose();
  return wide;
}

/// One frame's work on the tracks of one kind.
class Turn {
 public:
  Turn(TrackList& tracks,
       const CandidateList& candidates,
       const Glance& glance,
       const TrackParameters& parameters)
      : tracks_(tracks),
        candidates_(candidates),
        glance_(glance),
        parameters_(parameters) {}

  void predict() {
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
      Track& track = tracks_[i];
      track.filter.predict(to_seconds(glance_.exposure - track.time), motion_of(parameters_));
      track.time = std::max(track.time, glance_.exposure);
      moments_[i] = track.filter.moments();
    }
  }

  void associate() {
    const double gate = chi_square_gate(2, parameters_.gate_probability);
    CostMatrix cost(static_cast<Eigen::Index>(candidates_.size()),
                    static_cast<Eigen::Index>(tracks_.size()));
    for (std::size_t row = 0; row < candidates_.size(); ++row) {
      for (std::size_t column = 0; column < tracks_.size(); ++column) {
        cost(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
            pair_cost(candidates_[row], column, gate);
      }
    }
    column_of_ = assign(cost, kAlonePrice);
  }

  void update() {
    for (std::size_t row = 0; row < candidates_.size(); ++row) {
      if (column_of_[row] == kUnassigned) continue;
      const auto column = static_cast<std::size_t>(column_of_[row]);
      is_hit_[column] = true;
      hit(tracks_[column], moments_[column], candidates_[row]);
    }
  }

  void count_misses(const CandidateList& hiding) {
    for (std::size_t i = 0; i < tracks_.size(); ++i) {
      if (is_hit_[i]) continue;
      if (!candidates_.empty()) tracks_[i].rejected[index_of(glance_.robot)] = glance_.exposure;
      const double probability = detection_probability(moments_[i].mean.head<2>(), hiding);
      tracks_[i].log_odds += std::log1p(-probability);
    }
  }

  std::uint32_t begin_tracks() {
    std::uint32_t unused = 0;
    for (std::size_t row = 0; row < candidates_.size(); ++row) {
      if (column_of_[row] != kUnassigned) continue;
      if (!begin(candidates_[row])) ++unused;
    }
    return unused;
  }

  void drop_and_merge() {
    for (std::size_t i = tracks_.size(); i-- > 0;) {
      if (is_dead(tracks_[i]) || is_doubled(i)) tracks_.erase(i);
    }
  }

 private:
  [[nodiscard]] double pair_cost(const Candidate& candidate,
                                 std::size_t column,
                                 double gate) const {
    const auto gap = innovation(
        moments_[column], widened(candidate.measurement, moments_[column], glance_.sigma_exposure));
    if (!(gap.squared_distance <= gate)) return kForbidden;
    return gap.squared_distance + gap.log_determinant +
           (tracks_[column].is_confirmed ? 0.0 : kTentativePenalty);
  }

  void hit(Track& track, const PlanarMoments& moments, const Candidate& candidate) const {
    const auto measurement = widened(candidate.measurement, moments, glance_.sigma_exposure);
    track.nis_sum += innovation(moments, measurement).squared_distance;
    track.filter.update(measurement);
    track.last_hit = std::max(track.last_hit, glance_.exposure);
    track.supported[index_of(glance_.robot)] = glance_.exposure;
    track.log_odds = std::min(track.log_odds + evidence(candidate), parameters_.max_log_odds);
    ++track.hits;
    // A running mean that never gets too slow to learn.
    track.radius += (candidate.radius - track.radius) / std::min(track.hits, 20U);
    const bool is_quick = glance_.exposure - track.born <= parameters_.birth_window;
    if (is_quick && track.hits >= static_cast<std::uint32_t>(parameters_.birth_hits)) {
      track.is_confirmed = true;
    }
  }

  /// Log-odds that a candidate of this confidence adds.
  static double evidence(const Candidate& candidate) {
    constexpr double kDoubt = 0.05;  // no single frame is believed beyond this
    return std::log((candidate.confidence + kDoubt) / (1.0 - candidate.confidence + kDoubt));
  }

  [[nodiscard]] double detection_probability(const Eigen::Vector2d& p_F,
                                             const CandidateList& hiding) const {
    const Eigen::Vector2d way = p_F - glance_.p_FR;
    const double distance = way.norm();
    if (distance >= parameters_.detection_range) return 0.0;
    const double azimuth = std::atan2(way.y(), way.x());
    for (const Candidate& candidate : hiding) {
      const double aside = std::abs(angle_difference(azimuth, candidate.azimuth));
      if (candidate.distance < distance && aside < candidate.half_angle) return 0.0;
    }
    return parameters_.detection_probability * (1.0 - distance / parameters_.detection_range);
  }

  bool begin(const Candidate& candidate) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(candidate.measurement.cov_F,
                                                              Eigen::EigenvaluesOnly);
    const double widest = std::sqrt(axes.eigenvalues().maxCoeff());
    if (tracks_.is_full() || widest > parameters_.max_sigma_at_birth) return false;
    Track track;
    track.key = candidate.key;
    PlanarMoments moments;
    moments.mean << candidate.measurement.p_F, 0.0, 0.0;
    moments.cov.setZero();
    moments.cov.topLeftCorner<2, 2>() = candidate.measurement.cov_F;
    moments.cov.bottomRightCorner<2, 2>() =
        std::pow(parameters_.sigma_speed_at_birth, 2) * Eigen::Matrix2d::Identity();
    track.filter = PlanarFilter::from(moments);
    track.time = track.born = track.last_hit = glance_.exposure;
    track.supported[index_of(glance_.robot)] = glance_.exposure;
    track.log_odds = evidence(candidate);
    track.radius = candidate.radius;
    track.hits = 1;
    track.is_confirmed = parameters_.birth_hits <= 1;
    tracks_.push_back(track);
    return true;
  }

  [[nodiscard]] bool is_dead(const Track& track) const {
    const bool is_late = glance_.exposure - track.born > parameters_.birth_window;
    return track.log_odds < parameters_.death_log_odds ||
           glance_.exposure - track.last_hit > parameters_.death_age ||
           (!track.is_confirmed && is_late);
  }

  /// Whether an older track (they stand in order of birth) covers this one.
  [[nodiscard]] bool is_doubled(std::size_t index) const {
    const Eigen::Vector2d p_F = tracks_[index].filter.moments().mean.head<2>();
    for (std::size_t i = 0; i < index; ++i) {
      const Eigen::Vector2d other_F = tracks_[i].filter.moments().mean.head<2>();
      if ((p_F - other_F).norm() < parameters_.merge_distance) return true;
    }
    return false;
  }

  TrackList& tracks_;
  const CandidateList& candidates_;
  const Glance& glance_;
  const TrackParameters& parameters_;
  MomentList moments_;
  std::array<bool, kMaxTracks> is_hit_{};
  Assignment column_of_{};
};

}  // namespace

std::uint32_t take_in(TrackList& tracks,
                      const CandidateList& candidates,
                      const Glance& glance,
                      const CandidateList& hiding,
                      const TrackParameters& parameters) {
  Turn turn(tracks, candidates, glance, parameters);
  turn.predict();
  turn.associate();
  turn.update();
  turn.count_misses(hiding);
  const std::uint32_t unused = turn.begin_tracks();
  turn.drop_and_merge();
  return unused;
}

PlanarMoments moments_at(const Track& track, HostTime now, const TrackParameters& parameters) {
  return predicted(track.filter.moments(), to_seconds(now - track.time), motion_of(parameters));
}

double existence_at(const Track& track, HostTime now, const TrackParameters& parameters) {
  const double unseen = std::max(0.0, to_seconds(now - track.last_hit));
  // Things leave: half of those that nobody sees are gone after half the time to forget them.
  const double half_life = 0.5 * to_seconds(parameters.death_age);
  return std::exp2(-unseen / half_life) / (1.0 + std::exp(-track.log_odds));
}

RobotMask robots_within(const RobotTimes& times, HostTime now, Duration window) {
  unsigned mask = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (times[i] != kNever && now - times[i] <= window) mask |= 1U << i;
  }
  return static_cast<RobotMask>(mask);
}

std::uint32_t track_key(const ObservationId& id, std::uint32_t index) {
  // FNV-1a over the numbers' bytes: short, and the same on every machine.
  std::uint32_t hash = 2166136261U;
  for (std::uint32_t number : {std::uint32_t{id.robot}, id.boot, id.sequence, index}) {
    for (int i = 0; i < 4; ++i) {
      hash = (hash ^ (number & 0xFFU)) * 16777619U;
      number >>= 8U;
    }
  }
  return hash == 0 ? 1 : hash;
}

}  // namespace teamsight::fusion
