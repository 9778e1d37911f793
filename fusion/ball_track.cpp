// fusion/ball_track.cpp: see fusion/ball_track.hpp.
#include "fusion/ball_track.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "fusion/track.hpp"
#include "fusion/turn.hpp"

namespace teamsight::fusion {
namespace {

using Beliefs = std::array<BallBelief, kBallModes>;

// No way of moving is ever excluded: what is not expected may still happen.
constexpr double kLeastProbability = 1e-4;

std::size_t at(BallMode mode) {
  return static_cast<std::size_t>(mode);
}

/// What going over into another mode does to the velocity.
BallMatrix change_of_velocity(std::size_t from, std::size_t to, const BallMotion& motion) {
  BallMatrix change = BallMatrix::Zero();
  if (from == to) return change;
  const double kick = motion.sigma_kick * motion.sigma_kick;
  const double climb = motion.sigma_climb * motion.sigma_climb;
  if (from == at(BallMode::kRolling)) change(3, 3) = change(4, 4) = kick;
  if (to == at(BallMode::kFlying)) change(5, 5) = climb;
  return change;
}

/// On the floor: height and climb are known, whatever was thought before.
void lay_down(Considered<6>& state, const BallMotion& motion) {
  const double var = motion.sigma_floor * motion.sigma_floor;
  for (const int fixed : {2, 5}) {
    state.cov.row(fixed).setZero();
    state.cov.col(fixed).setZero();
    state.cov(fixed, fixed) = var;
    state.cross.row(fixed).setZero();
  }
  state.mean(2) = motion.radius;
  state.mean(5) = 0.0;
}

/// One belief as the mixture of what all others would have become of it.
BallBelief mixed(const Beliefs& before,
                 const Eigen::Matrix3d& transitions,
                 std::size_t to,
                 const BallMotion& motion) {
  BallBelief belief;
  belief.state.mean.setZero();
  belief.state.cov.setZero();
  std::array<double, kBallModes> share{};
  for (std::size_t from = 0; from < before.size(); ++from) {
    share[from] = before[from].probability *
                  transitions(static_cast<Eigen::Index>(from), static_cast<Eigen::Index>(to));
    belief.probability += share[from];
  }
  for (std::size_t from = 0; from < before.size(); ++from) {
    share[from] /= belief.probability;
    belief.state.mean += share[from] * before[from].state.mean;
    belief.state.cross += share[from] * before[from].state.cross;
  }
  for (std::size_t from = 0; from < before.size(); ++from) {
    const BallVector gap = before[from].state.mean - belief.state.mean;
    belief.state.cov += share[from] * (before[from].state.cov + gap * gap.transpose() +
                                       change_of_velocity(from, to, motion));
  }
  if (to != at(BallMode::kFlying)) lay_down(belief.state, motion);
  return belief;
}

BallStep step_of(std::size_t mode, const BallVector& mean, double dt, const BallMotion& motion) {
  if (mode == at(BallMode::kFlying)) return step_flying(mean, dt, motion);
  const double psd = mode == at(BallMode::kRolling) ? motion.rolling_psd : motion.kicked_psd;
  return step_rolling(mean, dt, psd, motion);
}

BallMoments moments_of(const Beliefs& beliefs) {
  BallMoments moments;
  moments.mean.setZero();
  moments.cov.setZero();
  for (const BallBelief& belief : beliefs) {
    moments.mean += belief.probability * belief.state.mean;
  }
  for (const BallBelief& belief : beliefs) {
    const BallVector gap = belief.state.mean - moments.mean;
    moments.cov += belief.probability * (belief.state.cov + gap * gap.transpose());
  }
  return moments;
}

void normalise(Beliefs& beliefs) {
  double sum = 0.0;
  for (BallBelief& belief : beliefs) {
    belief.probability = std::max(belief.probability, kLeastProbability);
    sum += belief.probability;
  }
  for (BallBelief& belief : beliefs) belief.probability /= sum;
}

void advance_beliefs(Beliefs& beliefs, double dt, const BallMotion& motion) {
  const Eigen::Matrix3d transitions = mode_transitions(dt, motion);
  const Beliefs before = beliefs;
  for (std::size_t mode = 0; mode < beliefs.size(); ++mode) {
    beliefs[mode] = mixed(before, transitions, mode, motion);
    const BallStep step = step_of(mode, beliefs[mode].state.mean, dt, motion);
    beliefs[mode].state.predict(step.transition, step.mean, step.disturbance);
  }
}

/// What is special about balls.
class BallKind {
 public:
  using Track = BallTrack;

  BallKind(const std::vector<BallRay>& rays, const Scene& scene, const BallSetting& setting)
      : rays_(rays),
        glance_(scene.glance),
        errors_(scene.errors),
        setting_(setting) {
    observer_.posture = glance_.posture;
    observer_.place = errors_.place_of(glance_.robot);
    if (observer_.place != kNoPlace) observer_.errors = errors_.mean(observer_.place);
    observer_.sigma_exposure = to_seconds(glance_.sigma_exposure);
    observer_.ball_radius = setting.motion.radius;
  }

  void predict(BallTrack& track, double dt) const {
    advance_beliefs(track.beliefs, dt, setting_.motion);
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
      const Look look = look_at(belief, candidate);
      // A way of moving that is not believed must fit the better.
      const double squared = look.squared - 2.0 * std::log(belief.probability) * kUnlikely;
      if (squared >= best.squared_distance) continue;
      best = {squared, look.degrees, look.log_determinant};
    }
    return best;
  }

  Gap hit(BallTrack& track, const Candidate& candidate) const {
    Gap mean{0.0, 2, 0.0};
    std::array<double, kBallModes> logs{};
    for (std::size_t mode = 0; mode < track.beliefs.size(); ++mode) {
      BallBelief& belief = track.beliefs[mode];
      Look look = look_at(belief, candidate);
      mean.degrees = look.degrees;
      mean.squared_distance += belief.probability * look.squared;
      const double tail = tail_factor(look.squared, look.degrees);
      // Student's t with 5 degrees of freedom, up to what is alike in all modes.
      logs[mode] =
          -0.5 * look.log_determinant - 0.5 * (5.0 + look.degrees) * std::log1p(look.squared / 5.0);
      look.cov += (tail - 1.0) * look.view.cov;
      take_view(belief.state, look.view, errors_, look.cov);
      if (mode != at(BallMode::kFlying)) settle(belief.state);
    }
    const double best = *std::max_element(logs.begin(), logs.end());
    for (std::size_t mode = 0; mode < track.beliefs.size(); ++mode) {
      track.beliefs[mode].probability *= std::exp(logs[mode] - best);
    }
    normalise(track.beliefs);
    return mean;
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
    const Considered<6> state = on_floor(candidate);
    track.beliefs[at(BallMode::kRolling)] = {state, 0.7};
    track.beliefs[at(BallMode::kKicked)] = {state, 0.2};
    track.beliefs[at(BallMode::kFlying)] = {lifted(state, candidate), 0.1};
    return track;
  }

 private:
  // Of the log of its probability, how much counts against a way of moving in the gate.
  static constexpr double kUnlikely = 0.5;

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
    look.degrees = ray.angular_radius > 0.0 && ray.sigma_angular_radius > 0.0 ? 3 : 2;
    return look;
  }

  /// An observation moves no ball off the floor that rolls.
  void settle(Considered<6>& state) const {
    state.mean(2) = setting_.motion.radius;
    state.mean(5) = 0.0;
  }

  [[nodiscard]] Considered<6> on_floor(const Candidate& candidate) const {
    Considered<6> state;
    const double speed = setting_.track.sigma_speed_at_birth;
    state.mean << candidate.measurement.p_F, setting_.motion.radius, 0.0, 0.0, 0.0;
    state.cov.setZero();
    state.cov.diagonal().segment<2>(3).setConstant(speed * speed);
    state.cov.topLeftCorner<2, 2>() = candidate.measurement.cov_F;
    if (observer_.place != kNoPlace) {
      const Eigen::Vector2d way_F = candidate.measurement.p_F - glance_.observer();
      const auto slope = place_slope(way_F);
      state.mean.head<2>() -= slope * observer_.errors;
      state.cov.topLeftCorner<2, 2>() =
          candidate.cov_own + slope * errors_.cov(observer_.place) * slope.transpose();
      state.cross.topRows<2>() = -slope * errors_.cov_with_all(observer_.place);
    }
    lay_down(state, setting_.motion);
    return state;
  }

  /// Somewhere along the ray, up to a robot's height or so.
  [[nodiscard]] Considered<6> lifted(const Considered<6>& floor, const Candidate& candidate) const {
    constexpr double kHeight = 0.4;       // m above the floor, and how uncertain that is
    constexpr double kSigmaHeight = 0.3;  // m
    const Point3<Robot>& origin = rays_[candidate.index].ray_R.origin;
    const double drop = std::max(0.1, origin.z - setting_.motion.radius);
    const Eigen::Vector2d way_F = candidate.measurement.p_F - glance_.observer();
    Eigen::Vector3d up;
    up << -way_F / drop, 1.0;
    Considered<6> state = floor;
    state.mean.head<3>() += kHeight * up;
    state.cov.topLeftCorner<3, 3>() += kSigmaHeight * kSigmaHeight * up * up.transpose();
    state.cov(5, 5) = setting_.motion.sigma_climb * setting_.motion.sigma_climb;
    return state;
  }

  const std::vector<BallRay>& rays_;
  const Glance& glance_;
  const TeamErrors& errors_;
  const BallSetting& setting_;
  BallObserver observer_;
};

}  // namespace

std::uint32_t take_in(BallList& tracks,
                      const BallSightings& sightings,
                      const Scene& scene,
                      const BallSetting& setting) {
  const BallKind kind(sightings.rays, scene, setting);
  return Turn<BallKind, BallList>(kind, tracks, sightings.candidates, scene, setting.track).take();
}

BallMoments moments_at(const BallTrack& track, HostTime now, const BallMotion& motion) {
  Beliefs beliefs = track.beliefs;
  // In steps, so that friction and bounces come in time.
  constexpr double kLongestStep = 0.05;  // s
  double left = to_seconds(now - track.book.time);
  while (left > 1e-9) {
    advance_beliefs(beliefs, std::min(left, kLongestStep), motion);
    left -= kLongestStep;
  }
  return moments_of(beliefs);
}

}  // namespace teamsight::fusion
