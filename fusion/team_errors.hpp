// fusion/team_errors.hpp: how wrong each robot's posture and calibration are, estimated jointly.
#pragma once

#include <array>

#include <Eigen/Core>

#include "fusion/parameters.hpp"
#include "fusion/posture_jitter.hpp"
#include "geometry/identity.hpp"
#include "geometry/sighting.hpp"
#include "geometry/time.hpp"

namespace teamsight::fusion {

/// Of one robot: what lasts of (x, y, theta) of its reported posture minus the truth, in F, and the
/// share by which it sees things too far away.
inline constexpr int kErrorSize = 4;
/// Robots whose errors are remembered; those beyond are taken to err anew in each frame.
inline constexpr int kMaxErrorRobots = 8;
inline constexpr int kAllErrors = kErrorSize * kMaxErrorRobots;

using ErrorVector = Eigen::Matrix<double, kErrorSize, 1>;
using ErrorMatrix = Eigen::Matrix<double, kErrorSize, kErrorSize>;
using AllErrors = Eigen::Matrix<double, kAllErrors, 1>;
using AllErrorsMatrix = Eigen::Matrix<double, kAllErrors, kAllErrors>;

/// Place of a robot in the joint state; kNoPlace: not remembered.
using ErrorPlace = int;
inline constexpr ErrorPlace kNoPlace = -1;

/// What is known of a posture otherwise than from its robot.
struct PostureNews {
  bool is_new{
      false};  ///< it jumped, or another process speaks: what was known of its error is void
  /// m per axis: it is found to stand aside by about so much, beside what it says. 0: it is not.
  double sigma_bias{0.0};
};

/// The errors of all robots as one Gaussian. While the covariance that a robot says grows, it only
/// counts its wheels: the error is carried along. Else its error fades over `posture_memory`, and
/// as much as the said covariance shrinks, and is renewed so that its covariance is what the robot
/// says, without the part that is new in each frame (fusion/posture_jitter.hpp). Sightings of each
/// other tell of them; how they correlate with tracks is kept in the tracks [Schmidt66].
class TeamErrors {
 public:
  explicit TeamErrors(const TeammateParameters& parameters = {}) : parameters_(parameters) {}

  /// Takes a robot's next posture and its covariance into account.
  ///
  /// @return what became of its errors: e' = result * e + news. Whoever is correlated with them
  ///         follows (Considered::follow)
  ErrorMatrix report(RobotId robot,
                     const PostureEstimate& posture,
                     HostTime exposure,
                     const PostureNews& news);

  /// @return kNoPlace for a robot that is not remembered
  [[nodiscard]] ErrorPlace place_of(RobotId robot) const;

  /// How many entries of the joint state are in use; they come first.
  [[nodiscard]] int active() const { return kErrorSize * robots_; }

  /// Covariance of what a posture errs by beside the remembered errors, drawn anew in each frame:
  /// all that the posture says for a robot that is not remembered.
  [[nodiscard]] Eigen::Matrix3d fresh(ErrorPlace place, const PostureEstimate& posture) const;

  /// Covariance of what this posture's error differs by from that of the robot's last one: all that
  /// the posture says until it has been measured how much is new.
  [[nodiscard]] Eigen::Matrix3d shake(RobotId robot, const PostureEstimate& posture) const;

  [[nodiscard]] ErrorVector mean(ErrorPlace place) const;
  [[nodiscard]] ErrorMatrix cov(ErrorPlace place) const;

  /// Covariance of one robot's errors with everybody's.
  [[nodiscard]] Eigen::Matrix<double, kErrorSize, kAllErrors> cov_with_all(ErrorPlace place) const;

  /// A residual of two coordinates, linear in the errors of two robots, with covariance.
  struct Residual {
    Eigen::Vector2d value{Eigen::Vector2d::Zero()};    ///< measured minus expected
    Eigen::Matrix2d cov{Eigen::Matrix2d::Identity()};  ///< its own noise
    ErrorPlace observer{kNoPlace};
    Eigen::Matrix<double, 2, kErrorSize> slope_observer;
    ErrorPlace watched{kNoPlace};
    Eigen::Matrix<double, 2, kErrorSize> slope_watched;
  };

  /// What a residual says: multiply it by a covariance with the errors to learn of that.
  struct Lesson {
    Eigen::Matrix<double, kAllErrors, 2> cov_slope;  ///< covariance of all errors with the residual
    Eigen::Matrix<double, 2, kAllErrors> slope;
    Eigen::Matrix2d inverse;   ///< of the residual's covariance
    Eigen::Vector2d surprise;  ///< the residual beyond what the estimated errors explain
  };

  [[nodiscard]] Lesson lesson_of(const Residual& residual) const;

  void learn(const Lesson& lesson);

 private:
  struct Known {
    RobotId robot{kNobody};
    HostTime seen{};
    PostureEstimate said;
    PostureJitter jitter;
    double sigma_bias{0.0};  ///< m per axis
  };

  [[nodiscard]] ErrorPlace make_place(RobotId robot, HostTime exposure);
  void restart(ErrorPlace place, const Eigen::Matrix3d& cov_posture);
  ErrorMatrix carry(ErrorPlace place,
                    const PostureEstimate& posture,
                    const PostureJitter& jitter,
                    double sigma_bias,
                    double dt);

  TeammateParameters parameters_;
  std::array<Known, kMaxErrorRobots> known_{};
  int robots_{0};
  AllErrors mean_{AllErrors::Zero()};
  AllErrorsMatrix cov_{AllErrorsMatrix::Zero()};
};

/// d(place in F of something seen from there)/d(errors of the observer).
///
/// @param way_F  from the observer to the thing; m
[[nodiscard]] Eigen::Matrix<double, 2, kErrorSize> place_slope(const Eigen::Vector2d& way_F);

}  // namespace teamsight::fusion
