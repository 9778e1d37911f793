// sim/match/ball.cpp: see ball.hpp.
#include "sim/match/ball.hpp"

#include <algorithm>
#include <cmath>

namespace teamsight::sim {
namespace {

constexpr double kGravity = 9.81;     // m/s^2
constexpr double kFlightStep = 1e-3;  // s

void roll(Ball& ball, double seconds, const BallParameters& parameters) {
  Eigen::Vector2d v(ball.v_FB.x, ball.v_FB.y);
  const double speed = v.norm();
  if (speed > 0.0) {
    const double lost = (parameters.deceleration + parameters.drag * speed * speed) * seconds;
    v *= std::max(speed - lost, 0.0) / speed;
  }
  ball.p_FB = {ball.p_FB.x + v.x() * seconds, ball.p_FB.y + v.y() * seconds, parameters.radius};
  ball.v_FB = {v.x(), v.y(), 0.0};
}

void fly(Ball& ball, double seconds, const BallParameters& parameters) {
  Eigen::Vector3d v = ball.v_FB.vector();
  v -= parameters.drag * v.norm() * seconds * v;
  v.z() -= kGravity * seconds;
  Eigen::Vector3d p = ball.p_FB.vector() + v * seconds;
  if (p.z() < parameters.radius && v.z() < 0.0) {
    p.z() = parameters.radius;
    v.head<2>() *= parameters.grip;
    const double up = -parameters.bounce * v.z();
    v.z() = up < parameters.least_bounce ? 0.0 : up;
  }
  ball.p_FB = Point3<Field>::from(p);
  ball.v_FB = {v.x(), v.y(), v.z()};
}

}  // namespace

bool is_flying(const Ball& ball, const BallParameters& parameters) {
  return ball.p_FB.z > parameters.radius + 1e-9 || ball.v_FB.z > 0.0;
}

Eigen::Quaterniond rolled(const Ball& ball,
                          const Point3<Field>& before,
                          const BallParameters& parameters) {
  const Eigen::Vector2d way = ball.p_FB.on_floor().vector() - before.on_floor().vector();
  const double length = way.norm();
  if (length < 1e-12) return ball.turn_F;
  const Eigen::Vector3d axis(-way.y() / length, way.x() / length, 0.0);
  return (Eigen::AngleAxisd(length / parameters.radius, axis) * ball.turn_F).normalized();
}

Ball moved(Ball ball, double seconds, const BallParameters& parameters) {
  double left = seconds;
  while (left > 1e-12 && is_flying(ball, parameters)) {
    const double step = std::min(left, kFlightStep);
    fly(ball, step, parameters);
    left -= step;
  }
  if (left > 1e-12) {
    roll(ball, left, parameters);
  }
  return ball;
}

}  // namespace teamsight::sim
