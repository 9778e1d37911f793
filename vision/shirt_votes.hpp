// vision/shirt_votes.hpp: whose robot an obstacle is, by the colour above its foot.
#pragma once

#include <cstddef>

#include "vision/obstacle_traits.hpp"
#include "vision/team_shirts.hpp"

namespace teamsight::vision {

/// How many of an obstacle's lines of sight show a team's colour above its foot.
struct ShirtVotes {
  std::size_t own{0};
  std::size_t theirs{0};

  friend bool operator==(const ShirtVotes&, const ShirtVotes&) = default;
};

/// Each line that stands votes once, for the team whose colour it shows in more samples. Where only
/// the own colour is known, any other strong one is the others'.
[[nodiscard]] ShirtVotes shirt_votes(const FootGroup& group,
                                     const TraitSource& source,
                                     const TeamShirts& shirts);

/// How far the lines of one shirt may be believed. They are no looks of their own: light, fabric
/// and what stands before a shirt mislead them together.
struct VoteModel {
  double wrong{0.05};       ///< share of all lines that show the other team's colour
  double correlation{0.6};  ///< of two lines of one shirt, in (0, 1)
};

/// Shirts differ in how large a share of their lines shows the wrong colour (a beta distribution
/// with that mean and correlation, alike for both teams), so the first line says most and
/// further ones that agree say little. The model's numbers lie among those that `teamsight score
/// shirts --fit` finds in other lights and paints: see README.md.
///
/// @return in (0, 1), if either team is as probable beforehand; 0.5 without votes
[[nodiscard]] double teammate_likelihood(const ShirtVotes& votes, const VoteModel& model = {});

}  // namespace teamsight::vision
