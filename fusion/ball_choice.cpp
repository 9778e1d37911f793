// fusion/ball_choice.cpp: see fusion/ball_choice.hpp.
#include "fusion/ball_choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

#include "geometry/uncertainty.hpp"

namespace teamsight::fusion {
namespace {

/// Place and velocity on the floor.
using Motion = Eigen::Vector4d;
using MotionCov = Eigen::Matrix4d;
constexpr std::array<int, 4> kOnFloor{0, 1, 3, 4};

double log_density(const Motion& gap, const MotionCov& cov) {
  const Eigen::LLT<MotionCov> factor(cov);
  const double log_root = MotionCov(factor.matrixL()).diagonal().array().log().sum();
  return -0.5 * gap.dot(factor.solve(gap)) - log_root - 2.0 * std::log(2.0 * std::numbers::pi);
}

/// Log-odds that speak for a ball that was seen for so long: false ones do not last.
double for_lasting(const TrackBook& book, const ChoiceParameters& parameters) {
  const double watched = to_seconds(book.last_hit - book.born) / to_seconds(parameters.false_life);
  return std::min(watched, parameters.most_for_lasting);
}

/// Log-odds that it is a ball at all, as it is seen now.
double log_odds_real(const TrackBook& book, const ChoiceParameters& parameters) {
  return log_odds_of(book) + for_lasting(book, parameters);
}

/// ... and that it was one, wherever it may be now.
double log_odds_proven(const TrackBook& book, const ChoiceParameters& parameters) {
  return book.proven + for_lasting(book, parameters);
}

constexpr double kLeast = 1e-30;  // its log is no infinity

/// What was seen at the same time elsewhere is something else; but a ball that was just kicked may
/// still fit where it was.
bool is_seen_beside(const TrackBook& before, const TrackBook& after) {
  constexpr Duration kOverlap = std::chrono::milliseconds(100);
  return after.born + kOverlap < before.last_hit;
}

/// Log-odds that the one listed before is a ball, against another that is found. Where both are
/// seen at once, neither is the other hidden: one that a single robot has vouched for so far is
/// then no better founded than a new one. Where the other began as the ball that was known before
/// might have, and more than one robot vouches for it, either may be that ball: what counts is who
/// sees which of them now.
double log_odds_held(const TrackBook& before,
                     const BallTrack& found,
                     const Parameters& parameters) {
  const TrackBook& after = found.book;
  const double one_word = parameters.ball.most_vote;
  const bool goes_on = found.goes_on_from == before.key && found.log_going_on > 0.0;
  const bool may_be_before = found.branched_from == before.key || goes_on;
  if (may_be_before && after.proven > one_word) return log_odds_of(before);
  const double proven = log_odds_proven(before, parameters.choice);
  const bool is_as_new = is_seen_beside(before, after) && before.proven <= one_word;
  return is_as_new ? proven - one_word : proven;
}

/// Like log_explained, for what none of the possibilities foresees: then the ball may be anywhere
/// on the field, and as fast as a false one.
double log_lost(const TrackBook& before,
                const TrackBook& after,
                const ChoiceParameters& parameters) {
  if (is_seen_beside(before, after)) return std::log(kLeast);
  const double unseen = std::max(0.0, to_seconds(after.time - before.last_hit));
  const double lost = 1.0 - std::exp(-parameters.lost_rate * unseen);
  return std::log(std::max(lost * parameters.density_anywhere / parameters.false_density, kLeast));
}

/// log(sum of exponentials), of two.
double log_sum(double a, double b) {
  const double most = std::max(a, b);
  return most + std::log1p(std::exp(std::min(a, b) - most));
}

}  // namespace

double log_odds_found(const BallTrack& ball, const Parameters& parameters) {
  return log_odds_real(ball.book, parameters.choice) - parameters.ball.most_vote;
}

double log_explained(const BallTrack& before,
                     const BallTrack& after,
                     const ChoiceParameters& parameters) {
  if (is_seen_beside(before.book, after.book)) return std::log(kLeast);
  const double now = log_foreseen(before, after, parameters);
  return after.goes_on_from == before.book.key ? std::max(now, after.log_going_on) : now;
}

double log_foreseen(const BallTrack& before,
                    const BallTrack& after,
                    const ChoiceParameters& parameters) {
  const BallMoments found = moments_of(after.beliefs);
  const MotionCov found_cov = found.cov(kOnFloor, kOnFloor);
  double expected = 0.0;
  for (const BallBelief& belief : before.beliefs) {
    const Motion gap_F = (found.mean - belief.state.mean)(kOnFloor);
    const MotionCov cov = MotionCov(belief.state.cov(kOnFloor, kOnFloor)) + found_cov;
    expected += belief.probability * std::exp(log_density(gap_F, cov));
  }
  MotionCov of_false = found_cov;
  of_false.diagonal().tail<2>().array() += parameters.false_speed * parameters.false_speed;
  const Eigen::Vector2d v_F = found.mean.segment<2>(3);
  const Eigen::Matrix2d cov_v = of_false.bottomRightCorner<2, 2>();
  const double log_false = std::log(parameters.false_density) -
                           0.5 * squared_mahalanobis(v_F, cov_v) -
                           std::log(2.0 * std::numbers::pi * std::sqrt(cov_v.determinant()));
  return std::log(std::max(expected, kLeast)) - log_false;
}

BallOrder order_of_choice(const BallList& balls,
                          const HintedBall& hinted,
                          HostTime now,
                          const Parameters& parameters) {
  const auto hint = [&](const BallTrack& ball) {
    return parameters.ball.most_vote * weight_of(hinted, ball.book.key, now, parameters.hint);
  };
  BallOrder order;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    if (!balls[i].book.is_confirmed) continue;
    const double challenge = log_odds_found(balls[i], parameters) + hint(balls[i]);
    // From the end: it goes ahead of all that it beats.
    std::size_t place = order.size();
    while (place > 0) {
      const BallTrack& old = balls[order[place - 1]];
      const double real = log_odds_held(old.book, balls[i], parameters) + hint(old);
      // Odds against the old one being real add to those of its having been kicked there.
      const double kicked = log_explained(old, balls[i], parameters.choice);
      const double lost = log_lost(old.book, balls[i].book, parameters.choice);
      const double way = log_sum(log_sum(kicked, lost), -real);
      if (challenge + way <= 0.0) break;
      --place;
    }
    order.push_back(i);
    std::rotate(order.begin() + static_cast<std::ptrdiff_t>(place), order.end() - 1, order.end());
  }
  return order;
}

}  // namespace teamsight::fusion
