// fusion/eyesight.hpp: how completely a robot reports what it should see, and what stands in its
// way.
#pragma once

#include <array>

#include <Eigen/Core>

#include "fusion/inline_list.hpp"
#include "fusion/parameters.hpp"
#include "geometry/identity.hpp"
#include "geometry/time.hpp"

namespace teamsight::fusion {

/// How often one robot reports things that others know of and that nothing hides from it, by
/// distance. What a robot does not report speaks against a thing only as far as that robot reports
/// what is there: no two cameras are alike, and nobody tells fusion how good they are.
class Eyesight {
 public:
  static constexpr int kRings = 8;                       ///< of distances
  static constexpr double kRingWidth = 1.0;              ///< m
  static constexpr double kReach = kRings * kRingWidth;  ///< m; nothing is learned beyond

  /// Probability that the robot reports a thing at that distance (m) if nothing hides it. As given
  /// by `parameters` until it is known better.
  [[nodiscard]] double probability(double distance,
                                   const TrackParameters& parameters,
                                   const EyesightParameters& eyesight) const;

  /// Which share of a look a frame is, by how long after the last one it comes; in (0, 1].
  [[nodiscard]] double news_of(HostTime exposure, const EyesightParameters& parameters) const;

  /// Fades to `exposure`.
  void turn_to(HostTime exposure, const EyesightParameters& parameters);

  /// That something was there at this distance (m), and whether the frame showed it.
  void note(double distance, bool is_reported);

 private:
  struct Ring {
    float looked{0.0F};    ///< how often something was there
    float reported{0.0F};  ///< ... and was reported
  };

  HostTime time_{std::chrono::hours(-1)};
  std::array<Ring, kRings> rings_{};
};

/// Something that hides what is behind it, whether this frame shows it or not.
struct Shadow {
  double azimuth{0.0};     ///< from the observer, in F; rad
  double distance{0.0};    ///< from the observer; m
  double half_angle{0.0};  ///< rad
};

inline constexpr std::size_t kMaxShadows = kMaxRobotId + 32;
using ShadowList = InlineList<Shadow, kMaxShadows>;

/// The shadow of a body of this radius (m) at `p_F`.
[[nodiscard]] Shadow shadow_of(const Eigen::Vector2d& p_F,
                               double radius,
                               const Eigen::Vector2d& observer_F);

/// How well the observer of a frame sees.
struct Sight {
  Eyesight eyes;
  EyesightParameters parameters;
  double news{1.0};    ///< share of the frame that its robot's last one did not tell; in (0, 1]
  ShadowList shadows;  ///< of everything that is known, beside what the frame shows
};

/// Sight of an observer of whom nothing is known.
inline const Sight kPlainSight{};

}  // namespace teamsight::fusion
