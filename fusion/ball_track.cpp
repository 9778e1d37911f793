// fusion/ball_track.cpp: see fusion/ball_track.hpp.
#include "fusion/ball_track.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "fusion/ball_birth.hpp"
#include "fusion/measurement.hpp"
#include "fusion/track.hpp"
#include "fusion/turn.hpp"

namespace teamsight::fusion {
namespace {

/// What is special about balls.
class BallKind {
 public:
  using Track = BallTrack;

  BallKind(const BallSightings& sightings, const Scene& scene, const BallSetting& setting)
      : rays_(sightings.rays),
        kickers_(sightings.kickers),
        kicks_(sightings.kicks),
        glance_(scene.glance),
        errors_(scene.errors),
        hiding_(scene.hiding),
        setting_(setting) {
    observer_.posture = glance_.posture;
    observer_.place = errors_.place_of(glance_.robot);
    observer_.cov_fresh = errors_.fresh(observer_.place, glance_.posture);
    if (observer_.place != kNoPlace) observer_.errors = errors_.mean(observer_.place);
    observer_.sigma_exposure = to_seconds(glance_.sigma_exposure);
    observer_.ball_radius = setting.motion.radius;
  }

  void predict(BallTrack& track, double dt) const {
    advance(track.beliefs, dt, setting_.motion);
    // Who knows when: often enough to tell instants apart, not so often that they crowd out others.
    constexpr double kShortest = 0.02;  // s
    track.since_split += dt;
    track.since_counted += dt;
    if (track.since_split < kShortest) return;
    constexpr double kSilence = 0.3;  // s
    if (dt > kSilence) {
      Kickers anybody = kickers_;
      anybody.is_silence = true;
      return think_of_kicks(track, anybody);
    }
    think_of_kicks(track, kickers_);
  }

  void think_of_kicks(BallTrack& track, const Kickers& kickers) const {
    track.high_share = setting_.motion.high_share;
    track.kick_rate = kick_rate(track.beliefs, kickers, setting_.motion);
    split_off_kicks(track.beliefs, track.since_split, kickers, setting_.motion);
    track.since_split = 0.0;
  }

  [[nodiscard]] Eigen::Vector2d place(const BallTrack& track) const {
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    for (const BallBelief& belief : track.beliefs) {
      place += belief.probability * belief.state.mean.head<2>();
    }
    return place;
  }

  /// A flying ball's ray meets the floor far behind it: the gate decides.
  [[nodiscard]] double farthest(const BallTrack& /*track*/) const { return 1e9; }

  [[nodiscard]] Gap gap(const BallTrack& track, const Candidate& candidate) const {
    Gap best;
    best.squared_distance = 1e12;
    for (const BallBelief& belief : track.beliefs) {
      if (is_anywhere(belief)) continue;
      const Look look = look_at(belief, candidate);
      // A possibility that is not believed must fit the better.
      const double squared = look.squared - 2.0 * std::log(belief.probability) * kUnlikely;
      if (squared >= best.squared_distance) continue;
      best = {squared, look.degrees, look.log_determinant};
    }
    return best;
  }

  /// Each possibility is one of two now: that what was seen is the ball, and that it is not.
  Gap hit(BallTrack& track, const Candidate& candidate) const {
    const BallBeliefs before = track.beliefs;
    const double log_false = log_of_false(candidate);
    Gap mean{0.0, 2, 0.0, 0.0};
    Logs hits{};
    Logs misses{};
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Look look = look_at(before[i], candidate);
      mean.degrees = look.degrees;
      mean.squared_distance += before[i].probability * look.squared;
      // What is seen can be seen, whatever is said of range and bodies in the way.
      constexpr double kLeast = 0.05;
      const double seen = std::max(kLeast, seen_probability(before[i]));
      const double log_prior = std::log(before[i].probability);
      hits[i] = log_prior + std::log(seen) + absorb(track.beliefs[i], look, candidate);
      misses[i] = log_prior + std::log(kept_unseen(before[i], seen)) + log_false;
    }
    const auto end = static_cast<std::ptrdiff_t>(before.size());
    const double best = std::max(*std::max_element(hits.begin(), hits.begin() + end),
                                 *std::max_element(misses.begin(), misses.begin() + end));
    double all_false = 0.0;
    BallBeliefs others = before;
    for (std::size_t i = 0; i < before.size(); ++i) {
      track.beliefs[i].probability = std::exp(hits[i] - best);
      mean.probability += track.beliefs[i].probability;
      others[i].probability = std::exp(misses[i] - best);
      all_false += others[i].probability;
    }
    mean.probability /= mean.probability + all_false;
    // Most looks leave no doubt.
    constexpr double kNegligible = -10.0;
    if (std::log(all_false) > kNegligible) add_others(track.beliefs, others);
    tidy(track.beliefs);
    if (track.book.is_confirmed) count_clear_kick(track);
    if (is_no_lamp(track)) track.book.doubt = 0.0;
    return mean;
  }

  /// Where the ball would have been seen, it is less probable now.
  double missed(BallTrack& track) const {
    double expected = 0.0;
    for (BallBelief& belief : track.beliefs) {
      const double seen = seen_probability(belief);
      expected += belief.probability * seen;
      belief.probability *= kept_unseen(belief, seen);
    }
    tidy(track.beliefs);
    return expected;
  }

  /// Two balls that pass each other stay two.
  [[nodiscard]] bool may_be_one(const BallTrack& a, const BallTrack& b) const {
    constexpr double kSure = 0.999;
    const BallMoments in_a = moments_of(a.beliefs);
    const BallMoments in_b = moments_of(b.beliefs);
    const Eigen::Vector2d gap_v = (in_a.mean - in_b.mean).segment<2>(3);
    const Eigen::Matrix2d cov_v = in_a.cov.block<2, 2>(3, 3) + in_b.cov.block<2, 2>(3, 3);
    return squared_mahalanobis(gap_v, cov_v) < chi_square_gate(2, kSure);
  }

  [[nodiscard]] std::optional<BallTrack> begin(const Candidate& candidate) const {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(candidate.measurement.cov_F,
                                                              Eigen::EigenvaluesOnly);
    if (std::sqrt(axes.eigenvalues().maxCoeff()) > setting_.track.max_sigma_at_birth) {
      return std::nullopt;
    }
    BallTrack track;
    track.book = first_page(
        candidate.key, {glance_.robot, glance_.exposure, candidate.confidence}, setting_.track);
    track.book.doubt = candidate.doubt;
    track.beliefs = beliefs_at_birth({candidate,
                                      rays_[candidate.index],
                                      observer_,
                                      errors_,
                                      setting_.motion,
                                      setting_.track.sigma_speed_at_birth},
                                     glance_.robot,
                                     glance_.exposure);
    return track;
  }

 private:
  using Logs = std::array<double, kMaxBallBeliefs>;

  // Of the log of its probability, how much counts against a possibility in the gate.
  static constexpr double kUnlikely = 0.5;
  // What hides a ball from a robot in one frame hides it in the next: each frame without it counts
  // for so much of one that tells something new.
  static constexpr double kIndependent = 0.3;

  /// Whether what began in the air is no more to be doubted: it has come down, or has been followed
  /// for so long as no thing that hangs there can be.
  [[nodiscard]] bool is_no_lamp(const BallTrack& track) const {
    constexpr Duration kLongEnough = std::chrono::seconds(1);
    if (glance_.exposure - track.book.born > kLongEnough) return true;
    double height = 0.0;
    for (const BallBelief& belief : track.beliefs) {
      height += belief.probability * belief.state.mean(2);
    }
    return height < setting_.motion.foot_height;
  }

  /// Counts the ball's last kick once there is no doubt of it, and of its kind.
  void count_clear_kick(BallTrack& track) const {
    constexpr double kClear = 0.95;
    constexpr double kSoonest = 0.2;  // s after it; and instants so near are one kick's
    const auto is_clear = [&](const BallBelief& belief) {
      return belief.probability > kClear && belief.since_kick > kSoonest &&
             belief.since_kick + kSoonest < track.since_counted;
    };
    const auto told = std::find_if(track.beliefs.begin(), track.beliefs.end(), is_clear);
    if (told == track.beliefs.end() || std::isinf(told->since_kick)) return;
    count_kick(kicks_, told->kicked_into, setting_.motion);
    track.since_counted = told->since_kick;
  }

  /// Whether this robot saw that ball a moment ago.
  [[nodiscard]] bool is_just_seen(const BallBelief& belief) const {
    constexpr Duration kMoment = std::chrono::milliseconds(300);
    return belief.seen_by == glance_.robot && glance_.exposure - belief.seen < kMoment;
  }

  /// That this frame would show the ball if it were there: for one that may be here or metres
  /// away, the mean over four places around (a cubature of third degree).
  [[nodiscard]] double seen_probability(const BallBelief& belief) const {
    constexpr double kPlaced = 0.25;  // m^2
    const Eigen::Vector2d p_F = belief.state.mean.head<2>();
    const Eigen::Matrix2d cov = belief.state.cov.topLeftCorner<2, 2>();
    if (cov.trace() < kPlaced) return seen_probability(p_F);
    const Eigen::Matrix2d root =
        std::sqrt(2.0) * Eigen::Matrix2d(Eigen::LLT<Eigen::Matrix2d>(cov).matrixL());
    double sum = 0.0;
    for (int axis = 0; axis < 2; ++axis) {
      sum += seen_probability(p_F + root.col(axis)) + seen_probability(p_F - root.col(axis));
    }
    return 0.25 * sum;
  }

  [[nodiscard]] double seen_probability(const Eigen::Vector2d& p_F) const {
    return detection_probability(p_F, glance_.observer(), hiding_, setting_.track);
  }

  /// Share of its probability that a possibility keeps when the frame does not show the ball.
  [[nodiscard]] double kept_unseen(const BallBelief& belief, double seen) const {
    constexpr double kAgain = 0.3;  // what was seen a moment ago, and nothing hides
    if (seen <= 0.0) return 1.0;
    return is_just_seen(belief) ? 1.0 - std::max(seen, kAgain) : std::pow(1.0 - seen, kIndependent);
  }

  /// Log-likelihood of what was seen if it is not the ball, as `absorb` has it: false ones lie on
  /// the floor, as densely everywhere, and look as large as a ball within a factor of about two.
  [[nodiscard]] double log_of_false(const Candidate& candidate) const {
    constexpr double kFarthest = 10.0;  // m
    const BallRay& ray = rays_[candidate.index];
    const double height = ray.ray_R.origin.z - setting_.motion.radius;
    const double range = std::clamp(candidate.distance, height, kFarthest);
    const double per_direction =
        setting_.track.false_density * range * range_slope(height, std::atan2(height, range));
    const bool has_size = degrees_of(ray) == 3;
    const double per_size = has_size ? 1.0 / ray.angular_radius : 1.0 / std::sqrt(kSizeNotMeasured);
    return std::log(per_direction * per_size) - log_peak_of_tails(degrees_of(ray));
  }

  /// Too uncertain to say that something seen is this ball: whatever is seen would fit, and what
  /// is false with it. If it is the ball, a track of its own will soon say so.
  static bool is_anywhere(const BallBelief& belief) {
    constexpr double kMostVariance = 1.0;  // m^2, of both floor coordinates together
    return belief.state.cov(0, 0) + belief.state.cov(1, 1) > kMostVariance;
  }

  struct Look {
    ConsideredView<6, 3> view;
    Eigen::Matrix3d cov;
    double squared{0.0};
    double log_determinant{0.0};
    int degrees{2};
  };

  [[nodiscard]] Look look_at(const BallBelief& belief, const Candidate& candidate) const {
    const BallRay& ray = rays_[candidate.index];
    Look look;
    look.view = view_of_ball(belief.state.mean, ray, observer_);
    look.cov = gap_covariance(belief.state, look.view, errors_);
    const Eigen::LLT<Eigen::Matrix3d> factor(look.cov);
    look.squared = look.view.gap.dot(factor.solve(look.view.gap));
    look.log_determinant = 2.0 * Eigen::Matrix3d(factor.matrixL()).diagonal().array().log().sum();
    look.degrees = degrees_of(ray);
    return look;
  }

  static int degrees_of(const BallRay& ray) {
    return ray.angular_radius > 0.0 && ray.sigma_angular_radius > 0.0 ? 3 : 2;
  }

  /// Log of the density of Student's t with 5 degrees of freedom at its middle.
  static double log_peak_of_tails(int degrees) {
    return degrees == 3 ? std::log(0.0725) : std::log(0.159);
  }

  /// Takes what was seen for the ball.
  ///
  /// @return how likely that look was, as a log; up to log_peak_of_tails
  double absorb(BallBelief& belief, const Look& look, const Candidate& candidate) const {
    take_look(belief.state, look, tail_factor(look.squared, look.degrees), rays_[candidate.index]);
    const double fast = too_fast(belief.state.mean);
    if (belief.mode != BallMode::kFlying) settle(belief.state);
    belief.seen_by = glance_.robot;
    belief.seen = glance_.exposure;
    return -0.5 * look.log_determinant -
           0.5 * (5.0 + look.degrees) * std::log1p(look.squared / 5.0) - fast;
  }

  /// What speaks against a ball that is faster than any, as a log of probability.
  [[nodiscard]] double too_fast(const BallVector& ball) const {
    constexpr double kSigma = 1.0;  // m/s
    const double beyond = std::max(0.0, ball.tail<3>().norm() - setting_.motion.fastest) / kSigma;
    return 0.5 * beyond * beyond;
  }

  /// Takes a look in, its noise widened by the tail factor. A ray is no straight function of a
  /// place: where the ball turns out to be far from where it was expected, the look is linearised
  /// there.
  void take_look(Considered<6>& state, Look look, double tail, const BallRay& ray) const {
    constexpr double kStraight = 0.1;  // m
    look.cov += (tail - 1.0) * look.view.cov;
    const Considered<6> before = state;
    take_view(state, look.view, errors_, look.cov);
    const BallVector moved = state.mean - before.mean;
    if (moved.head<3>().norm() < kStraight) return;
    look.view = view_of_ball(state.mean, ray, observer_);
    look.view.gap += look.view.slope * moved;
    look.view.cov *= tail;
    state = before;
    take_view(state, look.view, errors_, gap_covariance(state, look.view, errors_));
  }

  /// An observation moves no ball off the floor that rolls.
  void settle(Considered<6>& state) const {
    state.mean(2) = setting_.motion.radius;
    state.mean(5) = 0.0;
  }

  const std::vector<BallRay>& rays_;
  const Kickers& kickers_;
  KickTally& kicks_;
  const Glance& glance_;
  const TeamErrors& errors_;
  const CandidateList& hiding_;
  const BallSetting& setting_;
  BallObserver observer_;
};

}  // namespace

std::uint32_t take_in(BallList& tracks,
                      const BallSightings& sightings,
                      const Scene& scene,
                      const BallSetting& setting) {
  const BallKind kind(sightings, scene, setting);
  return Turn<BallKind, BallList>(kind, tracks, sightings.candidates, scene, setting.track).take();
}

BallMoments moments_at(const BallTrack& track, HostTime now, const BallMotion& all_games) {
  BallMotion motion = all_games;
  motion.high_share = track.high_share;
  BallBeliefs beliefs = track.beliefs;
  // In steps, so that friction and bounces come in time.
  constexpr double kLongestStep = 0.05;  // s
  const double ahead = to_seconds(now - track.book.time);
  double left = ahead;
  while (left > 1e-9) {
    advance(beliefs, std::min(left, kLongestStep), motion);
    left -= kLongestStep;
  }
  BallMoments moments = moments_of(beliefs);
  // What has been seen is in the possibilities already; only the time since then is open.
  doubt_kicks(moments, std::max(0.0, ahead), track.kick_rate, motion);
  return moments;
}

}  // namespace teamsight::fusion
