// tests/fusion/scenario.hpp: robots that see a known world, with noise of known size.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include <Eigen/Core>

#include "fusion/observation.hpp"
#include "geometry/field_model.hpp"

namespace teamsight::fusion::test {

using Random = std::mt19937_64;

inline constexpr double kBallRadius = 0.11;
inline constexpr double kMirrorHeight = 0.8;

/// 22 x 14 m, no paint: fusion only asks how large it is.
[[nodiscard]] FieldModel plain_field();

/// Later than every window and lag after the clock's zero.
[[nodiscard]] constexpr HostTime at_second(double seconds) {
  return HostTime{std::chrono::seconds(100)} + from_seconds(seconds);
}

/// What a robot's eye gets wrong; standard deviations.
struct EyeNoise {
  double sigma_direction{0.005};  ///< rad, azimuth and elevation
  double sigma_foot{0.05};        ///< m, per coordinate
  double sigma_position{0.03};    ///< m, per coordinate of the posture
  double sigma_heading{0.01};     ///< rad
};

/// A draw from a normal distribution.
[[nodiscard]] double normal(Random& random, double sigma);

/// A robot that stands somewhere and says what it sees. With `random` null it errs nowhere, but
/// says that it might.
class Eye {
 public:
  Eye(RobotId robot, std::uint32_t boot, const EyeNoise& noise = {})
      : robot_(robot),
        boot_(boot),
        noise_(noise) {}

  /// Begins the next frame: where the robot says that it is.
  void look(const Pose<Field, Robot>& X_FR, HostTime exposure, Random* random = nullptr);

  void see_ball(const Point<Field>& p_FB, Random* random = nullptr);

  /// The foot nearest to the robot of a disc of 0.25 m radius around `p_FO`.
  void see_obstacle(const Point<Field>& p_FO, Random* random = nullptr);

  [[nodiscard]] Observation& frame() { return frame_; }

 private:
  RobotId robot_;
  std::uint32_t boot_;
  EyeNoise noise_;
  Pose<Field, Robot> truth_;
  Observation frame_;
};

}  // namespace teamsight::fusion::test
