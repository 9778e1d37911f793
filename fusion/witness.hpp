// fusion/witness.hpp: whether what one frame shows fits what the other robots say is there.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "fusion/eyesight.hpp"
#include "fusion/parameters.hpp"
#include "fusion/track_book.hpp"
#include "fusion/trust.hpp"

namespace teamsight::fusion {

/// Something that other robots say is there.
struct Claim {
  Eigen::Vector2d p_F{Eigen::Vector2d::Zero()};      ///< m
  Eigen::Matrix2d cov{Eigen::Matrix2d::Identity()};  ///< m^2
  RobotMask claimants{0};                            ///< who says so
  bool is_ball{false};
};

inline constexpr std::size_t kMaxClaims = kMaxRobotId + 32;
using ClaimList = InlineList<Claim, kMaxClaims>;

/// What the eyes of several robots are like, beside one that is judged.
using Eyes = InlineList<Eyesight, kMaxRobotId>;

/// One frame's sightings, in F as its robot says.
struct Testimony {
  RobotId robot{kNobody};
  Eigen::Vector2d observer_F{Eigen::Vector2d::Zero()};
  const CandidateList& balls;
  const CandidateList& obstacles;
  /// Of the other robots: one that stands elsewhere than it says seems to see nothing, and must not
  /// be excused by that.
  const Eyes& eyes;
};

using EvidenceList = InlineList<PairEvidence, kMaxRobotId>;

/// For each claim that the robot should see from where it says, log-odds that it is there rather
/// than anywhere else; the same with everything turned to the mirror image. Shared out between
/// the claimants.
///
/// @param centre_F  about which the field is symmetric
[[nodiscard]] EvidenceList weigh(const Testimony& testimony,
                                 const ClaimList& claims,
                                 const Eigen::Vector2d& centre_F,
                                 const Parameters& parameters);

}  // namespace teamsight::fusion
