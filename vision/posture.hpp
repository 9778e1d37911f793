// vision/posture.hpp: where the robot stands, from line points: tracking, global search, symmetry.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "geometry/pose.hpp"
#include "geometry/sighting.hpp"
#include "vision/line_map.hpp"
#include "vision/line_points.hpp"
#include "vision/posture_fit.hpp"
#include "vision/posture_search.hpp"

namespace teamsight::vision {

/// On which half of the field the robot starts, as its people say.
enum class StartSide : std::uint8_t { kUnknown, kOwnHalf, kOpponentHalf };

/// What is known of the posture before a frame is seen.
struct MotionPrior {
  std::optional<Pose<Field, Robot>> X_FR;            ///< nothing: the robot may be anywhere
  Eigen::Matrix3d cov{Eigen::Matrix3d::Identity()};  ///< of X_FR; m, m, rad
  /// Log-odds that X_FR is right rather than its mirror image; meaningless without X_FR.
  double half_log_odds{0.0};
  /// Used while no pose is known, and dropped once one is.
  StartSide start_side{StartSide::kUnknown};
};

/// The posture and how it was come by.
struct PostureResult {
  PostureEstimate estimate;
  double scale{1.0};  ///< see PostureFit; with it `is_inlier` judges single points
  Eigen::Vector2d tilt{Eigen::Vector2d::Zero()};  ///< of the head; roll, pitch; rad
  bool searched_globally{false};                  ///< found without, or against, the prior
};

/// Largest |half_log_odds| that line points, priors and start sides can give.
inline constexpr double kMaxHalfLogOdds = 5.0;

/// Finds the posture that explains line points.
///
/// With a prior: robust Gauss-Newton from there; its answer is taken if the lines support it, else
/// the whole carpet is searched. The prior only starts the iteration and decides between mirror
/// images: the estimate is what the frame alone says, so that estimates of different frames are
/// independent. Buffers are the only state. Thread rule: one thread per object.
class PostureEstimator {
 public:
  /// @param tilt    how far the head may lean in any frame
  /// @param shared  what the camera file may be wrong by; in every estimate's covariance
  explicit PostureEstimator(const FieldModel& field,
                            const HeadTilt& tilt = {},
                            const SharedError& shared = {});

  /// @param points line points in the order in which they were found (neighbours next to each
  ///               other: their correlation is measured from that)
  /// @return status kLost when the points support no posture or leave a direction open
  [[nodiscard]] PostureResult estimate(std::span<const LinePoint> points, const MotionPrior& prior);

  [[nodiscard]] const LineMap& map() const { return map_; }

 private:
  LineMap map_;
  HeadTilt tilt_;
  SharedError shared_;
  bool symmetric_;
  PostureFitter fitter_;
  PostureSearch search_;
};

/// Log-odds that `X_FR` is right rather than its mirror image, given a prior that may itself be the
/// mirror image. Falls to 0 when neither is near the prior: then the robot was carried.
///
/// @param centre the field's centre of symmetry in F
[[nodiscard]] double half_log_odds_from_prior(const Pose<Field, Robot>& X_FR,
                                              const MotionPrior& prior,
                                              const Point<Field>& centre);

/// The same from the side on which the robot starts; 0 near the centre line or when unknown.
///
/// @param sigma_x of X_FR along x; m
[[nodiscard]] double half_log_odds_from_side(const Pose<Field, Robot>& X_FR,
                                             double sigma_x,
                                             StartSide side,
                                             const Point<Field>& centre);

}  // namespace teamsight::vision
