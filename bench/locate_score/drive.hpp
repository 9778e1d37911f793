// bench/locate_score/drive.hpp: a robot that drives about, with what its wheels say of it.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "geometry/field_model.hpp"
#include "geometry/pose.hpp"
#include "vision/localisation/motion_log.hpp"

namespace teamsight::locate_score {

struct DriveParameters {
  double max_speed{2.0};         ///< m/s
  double max_acceleration{2.5};  ///< m/s^2
  double max_turn{2.5};          ///< rad/s
  double sigma_scale{0.02};      ///< of the wheels' constant scale factors
  double sigma_v{0.03};          ///< of one velocity reading; m/s
  double sigma_omega{0.03};      ///< rad/s
  double slips_per_second{0.0};  ///< bursts of half a second in which the wheels spin or block
  bool standing{false};          ///< stays where it is
};

/// Goes on in steps of 10 ms; the same seed gives the same drive.
class Drive {
 public:
  static constexpr double kStep = 0.01;  // s

  Drive(const FieldModel& field, const DriveParameters& parameters, std::uint32_t seed);

  /// Ten milliseconds on.
  /// @return what the wheels say at its end
  vision::WheelReading step();

  [[nodiscard]] const Pose<Field, Robot>& truth() const { return X_FR_; }

  [[nodiscard]] HostTime now() const { return now_; }

  /// Acceleration over the floor of the last step, in R; m/s^2.
  [[nodiscard]] const Eigen::Vector2d& acceleration() const { return acceleration_R_; }

  /// Lifted and put down somewhere else; the wheels do not notice.
  void kidnap(const Pose<Field, Robot>& X_FR);

 private:
  void steer();

  double half_length_;
  double half_width_;
  Point<Field> centre_;
  DriveParameters parameters_;
  std::mt19937 random_;
  double way_scale_;
  double turn_scale_;
  HostTime now_{std::chrono::seconds(100)};
  Pose<Field, Robot> X_FR_;
  Eigen::Vector2d v_F_{Eigen::Vector2d::Zero()};
  Eigen::Vector2d acceleration_R_{Eigen::Vector2d::Zero()};
  double omega_{0.0};
  Eigen::Vector2d target_F_{Eigen::Vector2d::Zero()};
  double heading_{0.0};
  int until_{0};      // steps until another target is drawn
  int slipping_{0};   // steps of slip to go
  double slip_{1.0};  // what the wheels count of the way while slipping
  Pose<teamsight::Drive, Robot> X_DR_;
};

}  // namespace teamsight::locate_score
