// vision/perception.hpp: one frame in, everything it says out.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "geometry/field_model.hpp"
#include "geometry/frames.hpp"
#include "geometry/pose.hpp"
#include "geometry/result.hpp"
#include "geometry/sighting.hpp"
#include "vision/ball_detector.hpp"
#include "vision/ball_range.hpp"
#include "vision/camera_model.hpp"
#include "vision/camera_parameters.hpp"
#include "vision/carpet.hpp"
#include "vision/goal_detector.hpp"
#include "vision/image.hpp"
#include "vision/light.hpp"
#include "vision/light_gains.hpp"
#include "vision/line_drift.hpp"
#include "vision/line_points.hpp"
#include "vision/obstacle_detector.hpp"
#include "vision/posture.hpp"
#include "vision/virtual_sensors.hpp"

namespace teamsight::vision {

/// Why a frame says nothing at all.
enum class FrameReject : std::uint8_t {
  kWrongSize,    ///< another width or height than the camera file's
  kWrongFormat,  ///< another pixel format than the camera file's
  kTruncated,    ///< fewer or more bytes than the format and size need
};

/// What was decided before the match and never changes from frame to frame.
struct PerceptionParameters {
  double ball_radius{0.11};   ///< m
  double robot_radius{0.25};  ///< m
  ObstacleModel obstacles{trained_obstacle_model()};
  BallModel balls{trained_ball_model()};
  PatternModel patterned{trained_pattern_model()};  ///< balls, where the camera file says so
  std::size_t most_balls{kMaxBallRays};             ///< reported, of one frame
  TeamShirts shirts{};
};

/// Everything one frame says.
struct FrameObservation {
  PostureEstimate posture;
  std::vector<BallRay> balls;                   ///< best first, at most `most_balls`
  std::vector<BallPixels> ball_pixels;          ///< of the ball with the same index
  std::vector<BallRange> ball_ranges;           ///< of the ball with the same index
  std::vector<ObstacleSighting> obstacles;      ///< nearest first, at most kMaxObstacleSightings
  std::vector<ObstaclePixels> obstacle_pixels;  ///< of the obstacle with the same index
  std::size_t obstacles_left_out{0};            ///< farther ones on the field, beyond that bound
  std::vector<FreeSpace> free_space;            ///< by image direction; nothing under the mask
  std::vector<SeenGoal> goals;
  std::vector<SensorValue> sensors;  ///< in the order of the camera file
  std::vector<LinePoint> line_points;
  /// Signed distances of the line points from the paint under `posture`; m. Empty when lost.
  std::vector<double> line_residuals;
  /// Whether each line point counted as an inlier, given its own uncertainty. Empty when lost.
  std::vector<bool> line_fits;
  DriftEvidence drift;            ///< for a DriftWatch; without points when lost
  bool searched_globally{false};  ///< the posture was found without, or against, the prior
  Light light{Light::kUnknown};
  Carpet carpet;  ///< as this frame shows it
};

/// One robot's eye: frames in, observations out.
///
/// All tables are made by the constructor (some 100 ms); `see` allocates nothing once its buffers
/// have grown. The only state is buffers: what is known from earlier frames comes in as a
/// MotionPrior and by `adapt`, so the same frame, prior and light always give the same observation.
/// Thread rule: one thread per object.
class Perception {
 public:
  /// @pre the parameters were checked by `settings::load_camera` and `settings::load_field`
  Perception(const CameraParameters& camera,
             const FieldModel& field,
             const PerceptionParameters& parameters = {});
  ~Perception();
  Perception(const Perception&) = delete;
  Perception& operator=(const Perception&) = delete;
  Perception(Perception&&) noexcept;
  Perception& operator=(Perception&&) noexcept;

  /// Looks at one frame.
  ///
  /// @param image  must have the camera's size and format
  /// @param prior  where the robot may be at the exposure, before this frame
  /// @return the observation, never null, valid until the next call; the reason if the frame
  ///         cannot be a frame of this camera. Status kLost inside means: the frame was looked at
  ///         and its lines support no posture.
  [[nodiscard]] Result<const FrameObservation*, FrameReject> see(const ImageView& image,
                                                                 const MotionPrior& prior);

  /// What a frame shows that may tell where the robot is.
  struct Cues {
    std::span<const LinePoint> line_points;
    std::span<const SeenGoal> goals;
  };

  /// Tells where the robot is, given the cues of the frame being looked at.
  using PostureSource = std::function<PostureResult(const Cues&)>;

  /// The same for whoever follows the robot over time: `posture_of` is asked once, between the
  /// lines and goals and what stands on the field.
  [[nodiscard]] Result<const FrameObservation*, FrameReject> see_with(
      const ImageView& image, const PostureSource& posture_of);

  /// The colours of the carpet and the paint in a frame, whatever the classes say; takes some
  /// 0.2 ms.
  ///
  /// @param image  must have the camera's size and format
  /// @return nothing if they do not stand out, or if it is no frame of this camera
  [[nodiscard]] std::optional<FieldColours> field_colours(const ImageView& image);

  /// From the next frame on the light is this one: colours are taken back to the camera file's
  /// before they are judged.
  ///
  /// @pre all gains are positive
  void adapt(const LightGains& gains);

  /// What the field looked like when this camera's colour classes were chosen; nothing: nobody has
  /// said so.
  [[nodiscard]] const std::optional<FieldColours>& light() const;

  /// Where this camera looks from, and how far its head may lean against the camera file.
  [[nodiscard]] const HeadTilt& head() const;

 private:
  struct Tables;
  std::unique_ptr<Tables> tables_;
};

/// The prior for the next frame when nothing is known of the motion in between but its limits.
///
/// @param posture    of the last frame
/// @param elapsed_s  since then; s, not negative
/// @param start_side passed on
/// @return no pose when `posture` is lost; else its pose with the covariance grown by what a robot
///         can do in that time (3 m/s, 3 rad/s, two sigma)
[[nodiscard]] MotionPrior prior_after(const PostureEstimate& posture,
                                      double elapsed_s,
                                      StartSide start_side);

}  // namespace teamsight::vision
