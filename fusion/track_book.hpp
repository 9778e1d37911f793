// fusion/track_book.hpp: what is written down of every track, whatever it is of.
#pragma once

#include <array>
#include <cstdint>

#include <Eigen/Core>

#include "fusion/eyesight.hpp"
#include "fusion/inline_list.hpp"
#include "fusion/parameters.hpp"
#include "fusion/planar_filter.hpp"
#include "fusion/team_errors.hpp"
#include "geometry/identity.hpp"
#include "geometry/sighting.hpp"
#include "geometry/time.hpp"

namespace teamsight::fusion {

/// Earlier than every exposure: it has never happened.
inline constexpr HostTime kNever{std::chrono::hours(-1)};

/// A moment per robot, kNever at first; index is robot id - 1.
using RobotTimes = std::array<HostTime, kMaxRobotId>;

[[nodiscard]] constexpr RobotTimes no_robot_times() {
  RobotTimes times{};
  for (auto& time : times) time = kNever;
  return times;
}

/// Robots whose time lies within `window` before `now`.
[[nodiscard]] RobotMask robots_within(const RobotTimes& times, HostTime now, Duration window);

struct TrackBook {
  std::uint32_t key{0};       ///< made from the observation that began it: the same everywhere
  HostTime time{kNever};      ///< what the filter is predicted to
  HostTime born{kNever};      ///< exposure of its first observation
  HostTime last_hit{kNever};  ///< exposure of its last observation
  /// What each robot says of its existence, as log-odds; index is robot id - 1. However often it
  /// says so, a robot is one witness: what deceives it in one frame deceives it in the next.
  std::array<double, kMaxRobotId> votes{};
  /// Log-odds against it while one robot alone has seen it, by where it began (fusion/unseen.hpp).
  /// They fade while it lasts.
  double doubt{0.0};
  double proven{0.0};  ///< the most that its log-odds of existence ever were
  std::uint32_t hits{0};
  bool is_confirmed{false};
  double nis_sum{0.0};  ///< normalised innovations squared, per degree of freedom
  RobotTimes supported{no_robot_times()};  ///< last observation in it
  RobotTimes rejected{no_robot_times()};   ///< last time the robot saw only others of the kind
};

/// The sum of the votes.
[[nodiscard]] double votes_for(const TrackBook& book);

/// Log-odds of existence: the votes against the doubt.
[[nodiscard]] double log_odds_of(const TrackBook& book);

/// Goes on to `exposure`: votes fade when their robots look elsewhere.
void turn_page(TrackBook& book, HostTime exposure, const TrackParameters& parameters);

/// The robot did not report it, though it would have with this probability.
void write_miss(TrackBook& book,
                RobotId robot,
                double probability,
                const TrackParameters& parameters);

/// The robot is found to stand elsewhere than it says: nothing that it saw speaks for this track,
/// and it is worth what the others can have vouched for: nothing, if that robot went on to see it
/// after the last of them, for it was led away from what they saw. Done twice, it is done once.
void take_back(TrackBook& book, RobotId robot, const TrackParameters& parameters);

/// Probability that the track's thing is there at `now`.
[[nodiscard]] double existence_at(const TrackBook& book,
                                  HostTime now,
                                  const TrackParameters& parameters);

/// That a robot saw something.
struct Vote {
  RobotId robot{kNobody};
  HostTime exposure{kNever};
  double confidence{0.0};  ///< in [0, 1]
};

/// Begins the book of a track with its first observation.
[[nodiscard]] TrackBook first_page(std::uint32_t key,
                                   const Vote& vote,
                                   const TrackParameters& parameters);

/// Writes one more observation down.
///
/// @param nis  normalised innovation squared per degree of freedom
void write_hit(TrackBook& book, const Vote& vote, double nis, const TrackParameters& parameters);

/// Whether the track is to be dropped.
[[nodiscard]] bool is_over(const TrackBook& book,
                           HostTime exposure,
                           const TrackParameters& parameters);

/// A number for a track that every instance derives alike from the observation that began it.
///
/// @param index  of the candidate in its observation, different for balls and obstacles
/// @return never 0
[[nodiscard]] std::uint32_t track_key(const ObservationId& id, std::uint32_t index);

/// One thing that one frame shows, in F.
struct Candidate {
  PlanarMeasurement measurement;                         ///< with the errors' covariance in it
  Eigen::Matrix2d cov_own{Eigen::Matrix2d::Identity()};  ///< without remembered errors'; m^2
  double confidence{0.0};
  double radius{0.0};      ///< m
  double azimuth{0.0};     ///< from the observer, in F; rad
  double distance{0.0};    ///< from the observer; m
  double half_angle{0.0};  ///< it hides what is behind it within this angle; rad
  std::uint32_t key{0};    ///< of the track that it would begin
  std::uint32_t index{0};  ///< in the observation's list
  bool may_begin{true};    ///< whether a track may begin with it
  bool is_high{false};     ///< of a ball: in the air, where its size says; below it on the floor
  double doubt{0.0};       ///< of such a track, see TrackBook
};

inline constexpr std::size_t kMaxCandidates = 16;
using CandidateList = InlineList<Candidate, kMaxCandidates>;

/// Who looks, from where and when.
struct Glance {
  RobotId robot{kNobody};
  HostTime exposure{kNever};
  Duration sigma_exposure{0};
  PostureEstimate posture;  ///< of the observer, as it says

  [[nodiscard]] Eigen::Vector2d observer() const { return posture.X_FR.origin().vector(); }
};

/// What a frame is taken in with.
struct Scene {
  const Glance& glance;
  const TeamErrors& errors;
  const CandidateList& hiding;  ///< everything the frame shows that may hide a track
  const Sight& sight = kPlainSight;
};

/// That a robot which looks from there reports a thing at `p_F`: falls with the distance, 0 behind
/// what the frame shows nearer.
[[nodiscard]] double detection_probability(const Eigen::Vector2d& p_F,
                                           const Eigen::Vector2d& observer_F,
                                           const CandidateList& hiding,
                                           const TrackParameters& parameters);

/// Whether something that a frame shows nearer stands between a place and who looks from there.
[[nodiscard]] bool is_behind(const Eigen::Vector2d& p_F,
                             const Eigen::Vector2d& observer_F,
                             const CandidateList& hiding);

/// Whether something that the frame shows, or that is known to be there, stands between.
[[nodiscard]] bool is_hidden(const Eigen::Vector2d& p_F, const Scene& scene);

/// What it means that the frame does not show an obstacle at `p_F`: as `shown_probability`, but of
/// a frame that comes soon after the robot's last one only the share that tells something new.
[[nodiscard]] double missed_probability(const Eigen::Vector2d& p_F,
                                        const Scene& scene,
                                        const TrackParameters& parameters);

/// That the frame would show an obstacle at `p_F`, from what is known of its robot's eyes; 0 behind
/// something nearer.
[[nodiscard]] double shown_probability(const Eigen::Vector2d& p_F,
                                       const Scene& scene,
                                       const TrackParameters& parameters);

}  // namespace teamsight::fusion
