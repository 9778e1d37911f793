// vision/shirt_votes.cpp: see vision/shirt_votes.hpp.
#include "vision/shirt_votes.hpp"

#include <algorithm>

namespace teamsight::vision {

namespace {

constexpr std::size_t kAboveFoot = 60;  // samples that may show a shirt
constexpr std::size_t kFewest = 3;      // samples of a line that show one

/// Samples of one line.
struct Tally {
  std::size_t own{0};
  std::size_t theirs{0};
};

bool is_own(ColourClass colour, const TeamShirts& shirts) {
  return shirts.own != ColourClass::kNone && colour == shirts.own;
}

bool is_theirs(ColourClass colour, const TeamShirts& shirts) {
  if (shirts.theirs != ColourClass::kNone) return colour == shirts.theirs;
  return colour == ColourClass::kRed || colour == ColourClass::kBlue ||
         colour == ColourClass::kMagenta || colour == ColourClass::kCyan;
}

Tally tally_of(const Foot& foot, const TraitSource& source, const TeamShirts& shirts) {
  const ScanRange& range = source.lines.radial()[foot.index];
  const auto classes = source.scan.classes(range);
  const std::size_t end = std::min(classes.size(), foot.sample + kAboveFoot);
  Tally tally;
  for (std::size_t i = foot.sample; i < end; ++i) {
    if (is_own(classes[i], shirts)) {
      ++tally.own;
    } else if (is_theirs(classes[i], shirts)) {
      ++tally.theirs;
    }
  }
  return tally;
}

}  // namespace

ShirtVotes shirt_votes(const FootGroup& group,
                       const TraitSource& source,
                       const TeamShirts& shirts) {
  ShirtVotes votes;
  if (shirts == TeamShirts{}) return votes;
  for (std::size_t i = group.first; i <= group.last; ++i) {
    const Foot& foot = source.feet[i];
    if (!foot.stands) continue;
    const Tally tally = tally_of(foot, source, shirts);
    if (std::max(tally.own, tally.theirs) < kFewest || tally.own == tally.theirs) continue;
    ++(tally.own > tally.theirs ? votes.own : votes.theirs);
  }
  return votes;
}

double teammate_likelihood(const ShirtVotes& votes, const VoteModel& model) {
  // Both teams' chances of just these votes, one over the other: of their gamma functions all but
  // these factors cancel.
  const double sum = 1.0 / model.correlation - 1.0;
  const double right = sum * (1.0 - model.wrong);
  const double wrong = sum * model.wrong;
  double odds = 1.0;
  for (std::size_t i = 0; i < votes.own; ++i) {
    odds *= (right + static_cast<double>(i)) / (wrong + static_cast<double>(i));
  }
  for (std::size_t i = 0; i < votes.theirs; ++i) {
    odds *= (wrong + static_cast<double>(i)) / (right + static_cast<double>(i));
  }
  return 1.0 / (1.0 + 1.0 / odds);  // also of odds beyond any number
}

}  // namespace teamsight::vision
