// bench/peers/ball_rules.cpp: see bench/peers/ball_rules.hpp.
#include "bench/peers/ball_rules.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

namespace teamsight::peers {
namespace {

constexpr double kFriction = 0.4;  // m/s^2

/// Where a ball rolls within `dt`.
BallGuess rolled(const BallGuess& from, double dt) {
  const double speed = from.v_F.norm();
  if (speed < 1e-6) return from;
  const double time = std::min(dt, speed / kFriction);
  const Eigen::Vector2d way = from.v_F / speed;
  return {from.p_F + way * (speed * time - 0.5 * kFriction * time * time),
          way * (speed - kFriction * time)};
}

/// Weighted mean of those within `radius` of one of them, for the one where most weight lies.
template <class Votes, class Weight>
std::optional<BallGuess> heaviest_cluster(const Votes& votes, double radius, Weight weight_of) {
  std::optional<BallGuess> best;
  double heaviest = 0.0;
  for (const auto& centre : votes) {
    BallGuess sum;
    double total = 0.0;
    for (const auto& vote : votes) {
      if ((vote.guess.p_F - centre.guess.p_F).norm() > radius) continue;
      const double weight = weight_of(vote);
      sum.p_F += weight * vote.guess.p_F;
      sum.v_F += weight * vote.guess.v_F;
      total += weight;
    }
    if (total <= heaviest) continue;
    heaviest = total;
    best = BallGuess{sum.p_F / total, sum.v_F / total};
  }
  return best;
}

template <class Votes, class Cost>
std::optional<BallGuess> cheapest(const Votes& votes, Cost cost_of) {
  const auto best = std::min_element(votes.begin(), votes.end(), [&](const auto& a, const auto& b) {
    return cost_of(a) < cost_of(b);
  });
  if (best == votes.end()) return std::nullopt;
  return best->guess;
}

/// Falcons: variance along the ray 0.01 + 0.30 d, across 0.01 + 0.02 d; grown with age.
template <class Vote>
Eigen::Matrix2d ray_covariance(const Vote& vote) {
  const Eigen::Vector2d way = vote.guess.p_F - vote.observer_F;
  const double angle = std::atan2(way.y(), way.x());
  const Eigen::Matrix2d turn =
      (Eigen::Matrix2d() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle))
          .finished();
  const Eigen::Vector2d var(0.01 + 0.30 * vote.distance, 0.01 + 0.02 * vote.distance);
  return turn * (var * (1.0 + vote.age)).asDiagonal() * turn.transpose();
}

template <class Votes>
std::optional<BallGuess> product(const Votes& votes) {
  constexpr double kGate = 7.8;  // exp(-gate / 2) = 0.02, the least overlap that is merged
  std::optional<BallGuess> best;
  std::size_t most = 0;
  for (const auto& centre : votes) {
    Eigen::Matrix2d info = Eigen::Matrix2d::Zero();
    Eigen::Vector2d info_mean = Eigen::Vector2d::Zero();
    Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
    std::size_t count = 0;
    for (const auto& vote : votes) {
      const Eigen::Matrix2d both = ray_covariance(centre) + ray_covariance(vote);
      const Eigen::Vector2d gap = vote.guess.p_F - centre.guess.p_F;
      if (gap.dot(both.inverse() * gap) > kGate) continue;
      const Eigen::Matrix2d weight = ray_covariance(vote).inverse();
      info += weight;
      info_mean += weight * vote.guess.p_F;
      velocity += vote.guess.v_F;
      ++count;
    }
    if (count <= most) continue;
    most = count;
    best = BallGuess{info.inverse() * info_mean, velocity / static_cast<double>(count)};
  }
  return best;
}

}  // namespace

std::string name_of(BallRule rule) {
  switch (rule) {
    case BallRule::kNearestObserver:
      return "nearest-observer";
    case BallRule::kVoteWithinAMetre:
      return "vote-1m";
    case BallRule::kLowestCovariance:
      return "lowest-covariance";
    case BallRule::kNewest:
      return "newest";
    case BallRule::kClusteredWeights:
      return "clustered-weights";
    case BallRule::kProductOfGaussians:
      return "product-of-gaussians";
  }
  return "";
}

void BallBook::take(const fusion::Observation& observation, double t) {
  solos_[static_cast<std::size_t>(observation.id.robot) - 1].take(observation, t, ball_radius_);
}

BallBook::Votes BallBook::votes_at(double now, double max_age) const {
  Votes votes;
  for (const SoloBall& solo : solos_) {
    const double age = now - solo.last_seen();
    if (!solo.has_ball() || age > max_age) continue;
    votes.push_back(
        {rolled(solo.guess(), age), solo.observer(), age, solo.distance(), solo.variance()});
  }
  return votes;
}

std::optional<BallGuess> BallBook::ball(BallRule rule, double now) const {
  using V = Vote;
  switch (rule) {
    case BallRule::kNearestObserver:
      return cheapest(votes_at(now, 0.66), [](const V& vote) { return vote.distance; });
    case BallRule::kVoteWithinAMetre:
      return heaviest_cluster(votes_at(now, 0.3), 1.0, [](const V&) { return 1.0; });
    case BallRule::kLowestCovariance:
      return cheapest(votes_at(now, 1.0), [](const V& vote) { return vote.variance; });
    case BallRule::kNewest:
      return cheapest(votes_at(now, 4.5), [](const V& vote) { return vote.age; });
    case BallRule::kClusteredWeights:
      // Falls with age over 15 s, and with what an error of the angle means at the distance.
      return heaviest_cluster(votes_at(now, 15.0), 0.777, [](const V& vote) {
        return (1.0 - vote.age / 15.0) / (0.1 + vote.distance);
      });
    case BallRule::kProductOfGaussians:
      return product(votes_at(now, 2.0));
  }
  return std::nullopt;
}

}  // namespace teamsight::peers
