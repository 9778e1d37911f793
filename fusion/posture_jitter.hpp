// fusion/posture_jitter.hpp: how much of what a robot's posture errs by is new in each frame.
#pragma once

#include <array>

#include <Eigen/Core>

#include "fusion/parameters.hpp"
#include "geometry/pose.hpp"
#include "geometry/time.hpp"

namespace teamsight::fusion {

/// Splits the covariance that a robot says of its posture into a part that lasts, and that may be
/// learned from what is seen, and a part that is drawn anew for each frame.
///
/// The second part is measured: no robot can move as a posture shakes. Three postures in a row lie
/// on a straight line but for the robot's acceleration and three new errors; the mean square of
/// what is left over the last seconds, as a share of what the said covariance would make if all of
/// it were new, is the share that is. Place and heading each have their own.
class PostureJitter {
 public:
  /// Takes the next posture in. One that is not later than the last is left out.
  void take(const Pose<Field, Robot>& X_FR,
            const Eigen::Matrix3d& cov,
            HostTime exposure,
            const TeammateParameters& parameters);

  /// The next posture follows from none before: it jumped, or another process speaks.
  void interrupt() { known_ = 0; }

  /// Whether three postures were seen.
  [[nodiscard]] bool is_measured() const { return expected_.minCoeff() > 0.0; }

  /// Of the variances of place and heading, the share that is new in each frame. In [0, 1]; 0
  /// before three postures were seen.
  [[nodiscard]] Eigen::Array2d shares() const;

  /// Of a said covariance of (x, y, theta), the part that is new in each frame.
  [[nodiscard]] Eigen::Matrix3d fresh(const Eigen::Matrix3d& cov) const;

  /// The other part; the diagonals of both add up to the said one's.
  [[nodiscard]] Eigen::Matrix3d lasting(const Eigen::Matrix3d& cov) const;

  /// Of the standard deviations of (x, y, theta), the share that lasts.
  [[nodiscard]] Eigen::Vector3d lasting_root() const { return roots(1.0 - shares()); }

 private:
  struct Said {
    Eigen::Vector3d posture{Eigen::Vector3d::Zero()};  ///< (x, y, theta); m, m, rad
    HostTime time{};
  };

  /// Of what a third posture adds to the two before.
  struct Shake {
    Eigen::Array2d squared{Eigen::Array2d::Zero()};
    Eigen::Array2d expected{Eigen::Array2d::Zero()};  ///< of `squared`, if all errors were new
  };

  [[nodiscard]] Shake shake_of(const Said& now,
                               const Eigen::Matrix3d& cov,
                               const TeammateParameters& parameters) const;
  [[nodiscard]] static Eigen::Vector3d roots(const Eigen::Array2d& shares);

  std::array<Said, 2> last_{};  // the older one first
  int known_{0};                // how many of them
  // Sums of squares over the memory: place (m^2), heading (rad^2).
  Eigen::Array2d shaken_{Eigen::Array2d::Zero()};
  Eigen::Array2d expected_{Eigen::Array2d::Zero()};
};

}  // namespace teamsight::fusion
