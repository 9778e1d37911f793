// sim/render/scene.hpp: what stands and lies around one robot at one moment.
#pragma once

#include <optional>
#include <vector>

#include "geometry/frames.hpp"
#include "geometry/pose.hpp"
#include "sim/render/ball_look.hpp"
#include "sim/render/paint.hpp"

namespace teamsight::sim {

/// Another robot: a black base, a shirt of its team's colour, a thin tower with a mirror.
struct SceneRobot {
  Point<Field> p_F;
  Velocity<Field> v_F;  ///< m/s
  double radius{0.25};  ///< m
  double height{0.8};   ///< m
  Paint shirt{40, 70, 200};
  std::optional<Paint> markers{};  ///< three patches of 0.1 m at the foot, towards the eye
};

struct SceneBall {
  Point3<Field> p_FB;     ///< its centre
  Velocity3<Field> v_FB;  ///< m/s
  double radius{0.11};    ///< m
  BallLook look{};
};

/// Somebody who stands there: two legs and a body.
struct ScenePerson {
  Point<Field> p_F;
  Paint trousers{36, 38, 54};
  Paint shirt{120, 60, 60};
};

/// Everything that moves. The velocities are those of the middle of the exposure.
struct Scene {
  Pose<Field, Robot> X_FR;  ///< of the robot that looks, in the middle of the exposure
  Velocity<Field> v_FR;     ///< m/s
  double omega{0.0};        ///< rad/s
  std::vector<SceneRobot> robots;
  std::vector<SceneBall> balls;
  std::vector<ScenePerson> people;
};

}  // namespace teamsight::sim
