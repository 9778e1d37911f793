// vision/posture_fit.hpp: robust Gauss-Newton of line points onto the painted lines.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "geometry/pose.hpp"
#include "vision/line_map.hpp"
#include "vision/line_points.hpp"

namespace teamsight::vision {

/// How one line point disagrees with the painted field.
struct LineResidual {
  double distance{0.0};           ///< signed, to the nearest paint; m
  Eigen::Vector3d jacobian;       ///< d distance / d (x, y, theta)
  Eigen::Vector2d tilt_jacobian;  ///< d distance / d (roll, pitch); m/rad
  double var{1.0};                ///< of the point across that paint, as its detector claims; m^2
};

/// How far the head leans against the calibrated camera, about R's x (roll) and y (pitch) axes.
///
/// The robot leans about its foot, so a floor point that the calibrated camera puts at p lies at
/// p / (1 - (roll p_y - pitch p_x) / eye_height). The first order alone would be 20 mm wrong at 6 m
/// under half a degree.
struct HeadTilt {
  double eye_height{0.8};                          ///< of the viewpoint over the floor; m
  Eigen::Vector2d mean{Eigen::Vector2d::Zero()};   ///< expected (roll, pitch); rad
  Eigen::Vector2d sigma{Eigen::Vector2d::Zero()};  ///< of the expectation; 0: known; rad
};

/// Residuals of many points under one posture [Lauer05, with exact distances] and a tilt (roll,
/// pitch; rad): its rotation is worked out once.
class PostureResiduals {
 public:
  /// @param map  outlives this
  PostureResiduals(const LineMap& map,
                   const Pose<Field, Robot>& X_FR,
                   const Eigen::Vector2d& tilt,
                   double eye_height)
      : map_(&map),
        R_FR_(X_FR.rotation()),
        p_FR_(X_FR.origin().vector()),
        tilt_(tilt),
        eye_height_(eye_height) {}

  [[nodiscard]] LineResidual of(const LinePoint& point) const;

 private:
  const LineMap* map_;
  Eigen::Matrix2d R_FR_;
  Eigen::Vector2d p_FR_;
  Eigen::Vector2d tilt_;
  double eye_height_;
};

/// The residual of one point.
[[nodiscard]] LineResidual line_residual(const LineMap& map,
                                         const Pose<Field, Robot>& X_FR,
                                         const LinePoint& point,
                                         const Eigen::Vector2d& tilt = Eigen::Vector2d::Zero(),
                                         double eye_height = 0.8);

/// Whether a point lies on the paint, as far as its uncertainty lets one tell: within three sigma,
/// but at least 50 mm (a line is wider) and at most 250 mm.
///
/// @param scale true sigma of the points over the claimed one, see PostureFit
[[nodiscard]] bool is_inlier(const LineResidual& residual, double scale);

/// What a fit found.
struct PostureFit {
  Pose<Field, Robot> X_FR;
  /// m, m, rad. A direction that the points leave open has a sigma of kOpenSigma.
  Eigen::Matrix3d cov{Eigen::Matrix3d::Identity()};
  bool observable{false};  ///< the lines hold the robot in all three directions
  double scale{1.0};       ///< true sigma of the points over the claimed one
  double inlier_ratio{0.0};
  double support{0.0};  ///< sum of soft votes, at most the number of points; ranks candidates
  /// Variance of the errors of whole sectors of the image over that of independent points:
  /// N / N_eff as this frame alone says. Above 1 where the camera's map is wrong; `cov` is inflated
  /// by it, drawn towards 1, or by what FitStart knows better.
  double correlation{1.0};
  /// What `cov` would have to grow by if the claimed sigma of the points were one error that they
  /// all share: the picture aside, turned, larger, or pulled out of round, as a wrong camera file
  /// makes it. Grows with the square of the share that is taken to be so; see SharedError.
  Eigen::Matrix3d cov_shared{Eigen::Matrix3d::Zero()};
  /// The part of `cov` that says that a stretch of points may lie on other paint than it seems to:
  /// nothing while many stretches hold the robot, much where one alone does.
  Eigen::Matrix3d cov_doubtful{Eigen::Matrix3d::Zero()};
  Eigen::Vector2d tilt{Eigen::Vector2d::Zero()};      ///< roll, pitch; rad
  Eigen::Vector2d var_tilt{Eigen::Vector2d::Zero()};  ///< rad^2
};

/// What one frame makes of a posture's covariance without what the points of a sector share.
[[nodiscard]] inline Eigen::Matrix3d independent_part(const PostureFit& fit, double correlation) {
  return (fit.cov - fit.cov_doubtful) / std::max(1.0, correlation) + fit.cov_doubtful;
}

/// What all points of all frames err by together, because the camera file does. It never averages
/// out.
struct SharedError {
  double share{0.2};             ///< of the points' claimed sigma
  double sigma_place{0.002};     ///< of the robot in its own picture; m
  double sigma_heading{0.0008};  ///< rad
};

/// What a shared error makes of the covariance of a posture, beside the fit's own.
[[nodiscard]] Eigen::Matrix3d shared_part(const PostureFit& fit, const SharedError& error);

/// The sigma of a direction that the points leave open; m or rad.
inline constexpr double kOpenSigma = 10.0;

/// How a fit begins.
struct FitStart {
  Pose<Field, Robot> X_FR;
  double width{0.25};  ///< of the first kernel: how far from the paint a point may start; m
  HeadTilt tilt{};
  /// N / N_eff as known from earlier frames; 0: measured from this one alone.
  double correlation{0.0};
  /// Where the iteration begins, from the expected tilt; rad.
  Eigen::Vector2d lean{Eigen::Vector2d::Zero()};
};

/// Moves a posture until the line points lie on the lines.
///
/// Geman-McClure weights, their width annealed to max(20 mm, 3 sigma), sigma measured from the
/// residuals; the last steps are Newton's, on residuals carried on by their derivatives. The head's
/// tilt is fitted too, held by its expectation. The covariance is the M-estimator's (a sandwich),
/// the tilt marginalised, inflated by the correlation of points in the same sector, and by what
/// each stretch of points being wrong would mean. Buffers are the only state.
class PostureFitter {
 public:
  /// @param start near the answer: within some 0.3 m and 10 degrees for a width of 0.25 m
  /// @pre points is not empty
  [[nodiscard]] PostureFit fit(const LineMap& map,
                               std::span<const LinePoint> points,
                               const FitStart& start);

 private:
  using Information = Eigen::Matrix<double, 5, 5>;

  static constexpr std::size_t kSectors = 8;  // whose errors are compared with those of points
  /// Points of one sector whose paint runs more along x, or more along y.
  static constexpr std::size_t kStretches = 2 * kSectors;

  struct Stretch {
    // Sums of products, lower half, in units of the claimed sigma; its first five are information.
    Eigen::Matrix<double, 6, 6> squares{Eigen::Matrix<double, 6, 6>::Zero()};
    double weight{0.0};  // sum of its points' weights
  };

  struct Step {
    Eigen::Matrix<double, 5, 1> change{Eigen::Matrix<double, 5, 1>::Zero()};  // m, m, rad; tilt
    double way{0.0};                // how far it moves line points, about; m
    bool is_less_than_noise{true};  // of the answer
  };

  /// How each way to err together pulls at (x, y, theta, roll, pitch).
  using Pulls = Eigen::Matrix<double, 5, 6>;

  [[nodiscard]] double measure_scale();
  /// Residuals of every `stride`-th point.
  void look(const LineMap& map,
            std::span<const LinePoint> points,
            std::size_t stride,
            const PostureFit& fit);
  [[nodiscard]] Step next_step(const PostureFit& fit, double width) const;
  /// Moves the posture, and by their derivatives the residuals.
  /// @return how far it moved the point that it moved most; m
  double take(const Step& step, PostureFit& fit);
  void judge(std::span<const LinePoint> points, PostureFit& fit);
  /// Of the residuals of the last look, weighted as `judge` weighs them.
  [[nodiscard]] Pulls measure_pulls(std::span<const LinePoint> points, const PostureFit& fit) const;
  /// Sets the covariances. @param info of the inliers, in units of the claimed sigma
  void spread(const Information& info, double variance, PostureFit& fit) const;
  [[nodiscard]] double measure_correlation(const PostureFit& fit) const;
  /// Adds what wrong stretches would mean to `cov`. @param info  of all stretches
  void doubt_stretches(const Information& info, double variance, PostureFit& fit) const;

  HeadTilt tilt_;
  double known_correlation_{0.0};
  Pulls pulls_;
  std::array<Stretch, kStretches> stretches_;
  std::vector<std::size_t> stretch_of_;  // each residual
  std::vector<LineResidual> residuals_;
  std::vector<double> squares_;
};

}  // namespace teamsight::vision
