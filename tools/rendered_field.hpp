// tools/rendered_field.hpp: scenes on a field, drawn at random, and what an eye should say of them.
#pragma once

#include <vector>

#include "geometry/field_model.hpp"
#include "sim/match/random.hpp"
#include "sim/render/renderer.hpp"
#include "tools/detection_score.hpp"
#include "vision/perception.hpp"

namespace teamsight::tools {

/// Things beyond are neither asked for nor blamed.
struct Reach {
  double ball{6.0};   ///< m
  double robot{5.0};  ///< m, to its middle
};

/// A robot somewhere on the field, turned anyhow; a ball in three scenes of four, five other robots
/// in either team's shirt, and two people. Nothing stands in anything else.
[[nodiscard]] sim::Scene random_scene(const FieldModel& field, sim::Random& random);

/// What is to be seen, in pixels. What something nearer hides in part, or is beyond reach, does
/// not count.
[[nodiscard]] ImageLabels labels_of(const sim::Scene& scene,
                                    const sim::Renderer& renderer,
                                    const Reach& reach);

/// How far from the truth what was found lies on the floor; m.
struct FloorErrors {
  std::vector<double> balls;   ///< of the place that the ray and the ball's radius give
  std::vector<double> robots;  ///< of the foot nearest to the eye
};

/// Adds those of balls and robots that count and are found: nearest to the truth, within 0.5 m.
void add_floor_errors(const sim::Scene& scene,
                      const ImageLabels& labels,
                      const vision::FrameObservation& seen,
                      FloorErrors& errors);

}  // namespace teamsight::tools
