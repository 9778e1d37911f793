// tests/network/match.cpp: see match.hpp.
#include "tests/network/match.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace teamsight::network {
namespace {

double seconds_of(MatchTime time) {
  return std::fmod(to_seconds(time), 3600.0);
}

/// A point that goes round an ellipse, `period` seconds a turn.
Eigen::Vector2d around(const Eigen::Vector2d& home,
                       const Eigen::Vector2d& reach,
                       double period,
                       double t) {
  const double angle = 2.0 * std::numbers::pi * t / period;
  return home + Eigen::Vector2d(reach.x() * std::cos(angle), reach.y() * std::sin(angle));
}

}  // namespace

Point<Field> ball_at(MatchTime time) {
  return Point<Field>::from(around({0.0, 0.0}, {4.0, 2.5}, 16.0, seconds_of(time)));
}

Pose<Field, Robot> robot_at(RobotId robot, MatchTime time) {
  static const std::array<Eigen::Vector2d, kRobots> homes{Eigen::Vector2d{-8.0, 0.0},
                                                          Eigen::Vector2d{-4.0, 4.0},
                                                          Eigen::Vector2d{-4.0, -4.0},
                                                          Eigen::Vector2d{3.0, 5.0},
                                                          Eigen::Vector2d{3.0, -5.0},
                                                          Eigen::Vector2d{7.5, 0.5}};
  const Eigen::Vector2d home = homes.at(static_cast<std::size_t>(robot) - 1);
  const Eigen::Vector2d p = around(home, {0.8, 0.6}, 9.0 + robot, seconds_of(time) + robot);
  const Eigen::Vector2d to_ball = ball_at(time).vector() - p;
  return {p.x(), p.y(), std::atan2(to_ball.y(), to_ball.x())};
}

std::vector<Point<Field>> opponents_at(MatchTime time) {
  static const std::array<Eigen::Vector2d, 5> homes{Eigen::Vector2d{10.0, 0.2},
                                                    Eigen::Vector2d{6.0, 2.5},
                                                    Eigen::Vector2d{5.5, -2.5},
                                                    Eigen::Vector2d{-1.0, 4.5},
                                                    Eigen::Vector2d{-6.0, -1.5}};
  std::vector<Point<Field>> all;
  for (std::size_t i = 0; i < homes.size(); ++i) {
    const double period = 12.0 + static_cast<double>(i);
    all.push_back(Point<Field>::from(around(homes[i], {0.7, 0.6}, period, -seconds_of(time))));
  }
  return all;
}

}  // namespace teamsight::network
