// fusion/posture_jitter.cpp: see fusion/posture_jitter.hpp.
#include "fusion/posture_jitter.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/angle.hpp"

namespace teamsight::fusion {
namespace {

// Over a longer gap a robot may have done anything.
constexpr Duration kLongestGap = std::chrono::milliseconds(200);
// A jump that passed as none must not count for seconds: so many times what was expected.
constexpr double kMostSurprise = 9.0;

Eigen::Matrix3d scaled(const Eigen::Matrix3d& cov, const Eigen::Vector3d& by) {
  return by.asDiagonal() * cov * by.asDiagonal();
}

}  // namespace

PostureJitter::Shake PostureJitter::shake_of(const Said& now,
                                             const Eigen::Matrix3d& cov,
                                             const TeammateParameters& parameters) const {
  const double before = to_seconds(last_[1].time - last_[0].time);
  const double since = to_seconds(now.time - last_[1].time);
  const double ahead = since / before;
  Eigen::Vector3d step = last_[1].posture - last_[0].posture;
  step.z() = wrap_angle(step.z());
  Eigen::Vector3d gap = now.posture - last_[1].posture - ahead * step;
  gap.z() = wrap_angle(gap.z());
  // What a velocity that wanders adds.
  const double wandered = since * since * (before + since) / 3.0;
  const Eigen::Array2d by_moving(2.0 * parameters.acceleration_psd * wandered,
                                 parameters.angular_acceleration_psd * wandered);
  // Three errors, weighed as the line through the first two weighs them.
  const double all_new = 1.0 + (1.0 + ahead) * (1.0 + ahead) + ahead * ahead;
  Shake shake;
  shake.expected << all_new * cov.topLeftCorner<2, 2>().trace(), all_new * cov(2, 2);
  shake.squared << gap.head<2>().squaredNorm(), gap.z() * gap.z();
  shake.squared = (shake.squared - by_moving).min(kMostSurprise * shake.expected);
  return shake;
}

void PostureJitter::take(const Pose<Field, Robot>& X_FR,
                         const Eigen::Matrix3d& cov,
                         HostTime exposure,
                         const TeammateParameters& parameters) {
  const Said now{X_FR.vector(), exposure};
  if (known_ > 0 && exposure <= last_[1].time) return;
  const bool is_quick = known_ == 2 && last_[1].time - last_[0].time <= kLongestGap &&
                        exposure - last_[1].time <= kLongestGap;
  if (is_quick) {
    const Shake shake = shake_of(now, cov, parameters);
    const double keep =
        std::exp(-to_seconds(exposure - last_[1].time) / to_seconds(parameters.jitter_memory));
    shaken_ = keep * shaken_ + shake.squared;
    expected_ = keep * expected_ + shake.expected;
  }
  last_ = {last_[1], now};
  known_ = std::min(known_ + 1, 2);
}

Eigen::Array2d PostureJitter::shares() const {
  constexpr double kTiny = 1e-30;
  return (shaken_ / expected_.max(kTiny)).max(0.0).min(1.0);
}

Eigen::Vector3d PostureJitter::roots(const Eigen::Array2d& shares) {
  const Eigen::Array2d root = shares.sqrt();
  return {root(0), root(0), root(1)};
}

Eigen::Matrix3d PostureJitter::fresh(const Eigen::Matrix3d& cov) const {
  return scaled(cov, roots(shares()));
}

Eigen::Matrix3d PostureJitter::lasting(const Eigen::Matrix3d& cov) const {
  return scaled(cov, lasting_root());
}

}  // namespace teamsight::fusion
