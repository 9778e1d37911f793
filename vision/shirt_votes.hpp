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

/// By the rule of succession: each line is a look of its own, and any share of right ones is as
/// probable as another beforehand.
///
/// @return in (0, 1); 0.5 without votes
[[nodiscard]] double teammate_likelihood(const ShirtVotes& votes);

}  // namespace teamsight::vision
