// vision/localisation/motion_log.hpp: how the robot moved lately, by its wheels and its gyro.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include "geometry/frames.hpp"
#include "geometry/pose.hpp"
#include "geometry/time.hpp"

namespace teamsight::vision {

/// What the wheels have counted at one moment.
struct WheelReading {
  HostTime stamp{};
  Pose<Drive, Robot> X_DR;
  Velocity<Robot> v_R;      ///< m/s
  double omega{0.0};        ///< rad/s
  double sigma_v{0.0};      ///< of v_R as the drive claims; m/s
  double sigma_omega{0.0};  ///< rad/s
  bool slipping{false};     ///< the drive itself noticed
};

/// How fast the robot turned at one moment.
struct GyroReading {
  HostTime stamp{};
  double omega{0.0};   ///< rad/s
  double sigma{0.01};  ///< rad/s, its bias included
};

/// Why a reading was not taken.
enum class InputReject : std::uint8_t { kNone, kNotFinite, kBackwards };

/// How far wheels and gyro may be believed.
struct MotionParameters {
  double sigma_wheel{0.03};                        ///< least sigma of a velocity; m/s
  double sigma_wheel_turn{0.03};                   ///< rad/s
  double sigma_scale{0.02};                        ///< of the way and turn counted; dimensionless
  double sigma_slip{1.0};                          ///< of the velocity while slipping; m/s
  double sigma_slip_turn{1.5};                     ///< rad/s
  double correlation_time{0.1};                    ///< of the wheels' errors; s
  double standing{1e-4};                           ///< m or rad of a step: less is no motion
  double standing_share{0.1};                      ///< of the sigmas above, while the wheels stand
  Duration stale{std::chrono::milliseconds(100)};  ///< a newest reading older than this is none
};

/// A step of the robot between two moments.
struct Walk {
  Pose<Robot, Robot> step;
  Eigen::Matrix3d cov{Eigen::Matrix3d::Zero()};  ///< of the step's x, y, theta; m, m, rad
};

/// The last second of readings. A value; never allocates.
class MotionLog {
 public:
  explicit MotionLog(const MotionParameters& parameters = {}) : parameters_(parameters) {}

  /// Takes a reading. Not finite or not newer than the last one: dropped. Twenty stamps running
  /// backwards in a row mean that the drive's clock began again: so does the log.
  InputReject roll(const WheelReading& reading);
  InputReject turn(const GyroReading& reading);

  /// The step from one moment to a later one.
  ///
  /// @param slipping  the wheels are known to slip
  /// @return nothing if no wheels are known for all of it
  [[nodiscard]] std::optional<Walk> walk(HostTime from, HostTime to, bool slipping) const;

  /// The newest reading if it is fresh at `when`.
  [[nodiscard]] std::optional<WheelReading> newest(HostTime when) const;

  /// Change of velocity per second over the last twentieth of a second, in R; nothing if not known.
  [[nodiscard]] std::optional<Eigen::Vector2d> acceleration(HostTime when) const;

 private:
  static constexpr std::size_t kReadings = 192;
  static constexpr int kRestart = 20;

  struct Heading {
    HostTime stamp{};
    double angle{0.0};  // integrated, not wrapped
    GyroReading reading;
  };

  [[nodiscard]] std::optional<Pose<Drive, Robot>> wheels_at(HostTime when) const;
  [[nodiscard]] std::optional<double> heading_at(HostTime when) const;
  [[nodiscard]] const WheelReading& wheel(std::size_t age) const;  // 0: newest
  [[nodiscard]] const Heading& heading(std::size_t age) const;

  [[nodiscard]] std::size_t wheels_kept() const { return std::min(wheel_count_, kReadings); }

  [[nodiscard]] std::size_t headings_kept() const { return std::min(heading_count_, kReadings); }

  MotionParameters parameters_;
  std::array<WheelReading, kReadings> wheels_{};
  std::array<Heading, kReadings> headings_{};
  std::size_t wheel_count_{0};
  std::size_t heading_count_{0};
  int wheels_backwards_{0};
  int headings_backwards_{0};
};

}  // namespace teamsight::vision
