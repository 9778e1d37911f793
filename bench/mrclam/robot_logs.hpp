// bench/mrclam/robot_logs.hpp: real robots among landmarks, with truth from motion capture.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <vector>

#include <Eigen/Core>

#include "geometry/pose.hpp"

namespace teamsight::mrclam {

/// What the wheels say from `t` on.
struct Wheels {
  double t{0.0};      ///< s since the logs began
  double v{0.0};      ///< m/s, forward
  double omega{0.0};  ///< rad/s
};

/// A landmark or robot that the camera saw.
struct Seen {
  double t{0.0};        ///< s since the logs began
  int subject{0};       ///< 1 to 5: a robot; else a landmark; 0: its code is nobody's
  double range{0.0};    ///< m, from robot centre to subject centre
  double bearing{0.0};  ///< rad, from straight ahead to the left
};

/// Where motion capture saw a robot.
struct Truth {
  double t{0.0};  ///< s since the logs began
  Pose<Field, Robot> X_FR;
};

struct RobotLog {
  std::vector<Wheels> wheels;
  std::vector<Seen> seen;
  std::vector<Truth> truth;

  /// The one nearest in time. @pre truth is not empty
  [[nodiscard]] const Pose<Field, Robot>& truth_at(double t) const;
};

inline constexpr int kRobots = 5;

/// One data set of five robots, each in the order of its stamps.
struct RobotLogs {
  std::array<RobotLog, kRobots> robots;
  std::map<int, Eigen::Vector2d> landmarks;  ///< subject -> place in F; m
  double duration{0.0};                      ///< s that all logs cover
};

/// Reads a folder of the UTIAS Multi-Robot Cooperative Localization and Mapping data set
/// [Leung11]: Barcodes.dat, Landmark_Groundtruth.dat and, for robots 1 to 5, RobotN_Groundtruth,
/// RobotN_Odometry and RobotN_Measurement; each plain or with `.gz` behind.
///
/// @throws std::runtime_error in one line that names file, line, what was found and expected
[[nodiscard]] RobotLogs read_robot_logs(const std::filesystem::path& folder);

}  // namespace teamsight::mrclam
