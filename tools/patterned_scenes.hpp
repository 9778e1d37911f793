// tools/patterned_scenes.hpp: rendered scenes with a patterned ball, or with what may pass for one.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/field_model.hpp"
#include "sim/match/random.hpp"
#include "sim/render/renderer.hpp"
#include "tools/detection_score.hpp"
#include "vision/calibration/trait_training.hpp"
#include "vision/perception.hpp"

namespace teamsight::tools {

/// A ball as it is painted, and as a camera file says so.
struct PatternedBall {
  std::string_view name;
  sim::BallPattern pattern{sim::BallPattern::kFootball};
  sim::Paint paint;
  sim::Paint panels;
  std::array<vision::ColourClass, 2> classes{};
};

/// The balls that scenes are made with: white with black pentagons, in octants of white and black,
/// and in octants of white and orange.
[[nodiscard]] std::span<const PatternedBall> patterned_balls();

/// A scene, and where its patterned ball is.
struct PatternedScene {
  sim::Scene scene;
  /// From the middle of the robot; m. Nothing: there is none.
  std::optional<double> distance;
};

/// A robot somewhere on the field, turned anyhow, five others in shirts of both teams, white and
/// black, half of them with white markers at the foot, and two people. In half of the scenes a
/// patterned ball, turned anyhow, of all distances from 0.5 to 6 m alike: a third of these
/// anywhere, a third on a line, a third beside a robot. In a quarter a ball all of its first paint.
[[nodiscard]] PatternedScene patterned_scene(const FieldModel& field,
                                             const PatternedBall& ball,
                                             sim::Random& random);

/// Looks at many scenes through one camera.
class PatternedViews {
 public:
  /// @param camera  its colours get the ball's pattern
  PatternedViews(const vision::CameraParameters& camera,
                 const FieldModel& field,
                 const PatternedBall& ball,
                 const vision::PerceptionParameters& parameters);

  /// What was seen of one scene.
  struct View {
    std::optional<double> distance;                 ///< of the patterned ball; m
    ImageLabels labels;                             ///< that ball alone
    const vision::FrameObservation* seen{nullptr};  ///< valid until the next look
  };

  [[nodiscard]] View look(sim::Random& random);

 private:
  vision::CameraParameters camera_;
  const FieldModel& field_;
  PatternedBall ball_;
  vision::Perception perception_;
  sim::Renderer renderer_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace teamsight::tools
