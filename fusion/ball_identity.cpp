// fusion/ball_identity.cpp: see fusion/ball_identity.hpp.
#include "fusion/ball_identity.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "fusion/ball_choice.hpp"

namespace teamsight::fusion {
namespace {

// Shorter than this a ball that is hidden for a moment is not lost.
constexpr Duration kShortestLoss = std::chrono::milliseconds(300);
// What a ball was before is asked for so long: each look may make it clear.
constexpr Duration kLongestDoubt = std::chrono::seconds(1);

bool contains(const BallKeys& keys, std::uint32_t key) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// Log-odds that `found` is real and what `lost` was, seen first after the other was seen last;
/// nothing where that cannot be.
std::optional<double> log_odds_same(const BallTrack& lost,
                                    const BallTrack& found,
                                    const Parameters& parameters) {
  if (!lost.book.is_confirmed || found.book.born - lost.book.last_hit < kShortestLoss) return {};
  return log_odds_found(found, parameters) + log_explained(lost, found, parameters.choice);
}

/// Whether another than `found` has turned up since `lost` was seen last, for which more than one
/// robot vouches: then that one is the game's ball, and what turns up later is none that was lost.
bool is_followed(const BallTrack& lost,
                 const BallTrack& found,
                 const BallList& balls,
                 const Parameters& parameters) {
  return std::any_of(balls.begin(), balls.end(), [&](const BallTrack& other) {
    return other.book.key != found.book.key && other.book.is_confirmed &&
           other.book.born > lost.book.last_hit &&
           log_odds_of(other.book) > parameters.ball.most_vote;
  });
}

/// A ball that another goes on from.
struct Forerunner {
  std::size_t place{0};  ///< the list's size if there is none
  double log_odds{0.0};  ///< that it is that one
};

Forerunner forerunner_of(const BallTrack& found,
                         const BallList& balls,
                         const Parameters& parameters) {
  constexpr double kClear = 3.0;  // log-odds over its being a false one: 95 %
  Forerunner latest{balls.size()};
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const auto odds = log_odds_same(balls[i], found, parameters);
    if (!odds || *odds < kClear || is_followed(balls[i], found, balls, parameters)) continue;
    const bool is_later =
        latest.place == balls.size() || balls[i].book.last_hit > balls[latest.place].book.last_hit;
    if (is_later) latest = {i, *odds};
  }
  return latest;
}

/// Key of the ball that `found` may be though both have been seen: in a tussle the false one is
/// taken for the known ball as soon as the true one is. 0: none.
std::uint32_t branch_of(const BallTrack& found,
                        const BallList& balls,
                        const Parameters& parameters) {
  for (const BallTrack& ball : balls) {
    const bool is_older = ball.book.is_confirmed && ball.book.born < found.book.born;
    const bool is_seen_too = ball.book.last_hit > found.book.born;
    if (!is_older || !is_seen_too) continue;
    if (log_foreseen(ball, found, parameters.choice) > 0.0) return ball.book.key;
  }
  return 0;
}

/// Writes down what speaks for a young ball going on from one that is not seen any more. Later the
/// other's possibilities say less of it: where this one is seen, they are not.
void note_origin(BallTrack& young, const BallList& balls, const Parameters& parameters) {
  if (young.book.time - young.book.born > kLongestDoubt) return;
  for (const BallTrack& old : balls) {
    if (!old.book.is_confirmed || old.book.last_hit >= young.book.born) continue;
    const double log_going_on = log_foreseen(old, young, parameters.choice);
    if (young.goes_on_from != 0 && log_going_on <= young.log_going_on) continue;
    young.goes_on_from = old.book.key;
    young.log_going_on = log_going_on;
  }
}

/// Whether it is not yet decided what a ball was.
bool is_in_doubt(const BallTrack& ball, const BallKeys& before) {
  if (!ball.book.is_confirmed || ball.is_known_again) return false;
  return !contains(before, ball.book.key) || ball.book.time - ball.book.born < kLongestDoubt;
}

/// The track that was given up last; 0: none ever.
std::uint32_t last_lost(std::uint32_t lost, const BallKeys& before, const BallKeys& after) {
  for (const std::uint32_t key : before) {
    if (!contains(after, key)) lost = key;
  }
  return lost;
}

}  // namespace

BallKeys confirmed_keys(const BallList& balls) {
  BallKeys keys;
  for (const BallTrack& ball : balls) {
    if (ball.book.is_confirmed) keys.push_back(ball.book.key);
  }
  return keys;
}

std::uint32_t recognise(BallList& balls,
                        const BallKeys& before,
                        std::uint32_t lost,
                        const Parameters& parameters) {
  const BallKeys after = confirmed_keys(balls);
  lost = last_lost(lost, before, after);
  for (BallTrack& ball : balls) note_origin(ball, balls, parameters);
  for (std::size_t i = balls.size(); i-- > 0;) {
    if (!is_in_doubt(balls[i], before)) continue;
    TrackBook& book = balls[i].book;
    if (!contains(before, book.key)) {
      balls[i].branched_from = branch_of(balls[i], balls, parameters);
    }
    const auto [old, log_odds] = forerunner_of(balls[i], balls, parameters);
    if (old < balls.size()) {
      book.key = balls[old].book.key;
      balls[i].is_known_again = true;
      // What proved the lost one proves this one as far as it is sure to be that one.
      book.proven = std::max(book.proven, std::min(balls[old].book.proven, log_odds));
      // It stands where the lost one stood: what came after that does not come before this.
      balls[old] = balls[i];
      balls.erase(i);
      return lost;
    }
    const bool is_alone = after.size() == 1;
    if (is_alone && lost != 0) {
      balls[i].is_known_again = true;
      book.key = std::exchange(lost, 0);
    }
  }
  return lost;
}

}  // namespace teamsight::fusion
