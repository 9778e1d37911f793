// sim/robot_camera.hpp: one simulated robot: its camera into a FIFO, its wheels onto its own
// domain.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/time.hpp"
#include "sim/frame_pipe.hpp"
#include "sim/frame_rate.hpp"
#include "sim/match/match.hpp"
#include "sim/match/wheels.hpp"
#include "sim/render/renderer.hpp"
#include "sim/setup.hpp"

namespace teamsight::sim {

/// How long everybody stands before kick-off: agents that start with the match find themselves in
/// the half that their robot file says.
inline constexpr double kBeforeKickOff = 6.0;  // s

/// When the match began and how often this robot's camera exposes.
struct CameraClock {
  HostTime start{};
  double frame_rate_hz{15.0};
  double phase{0.0};  ///< of the exposures in one frame period, in [0, 1)
};

/// Plays the match along, draws what the robot sees and counts its wheels.
class RobotCamera {
 public:
  /// @param player  index in the match's players
  RobotCamera(std::size_t player, const CameraClock& clock, Match match, Eye eye, FramePipe& pipe);

  /// Exposes when it is time for it; called every few milliseconds.
  void tick(HostTime now);

  /// Of all ticks until now.
  [[nodiscard]] const FrameCount& frames() const { return frames_; }

  /// What the wheels have counted.
  struct Count {
    HostTime stamp{};
    Pose<Drive, Robot> X_DR;
    Velocity<Robot> v_R;  ///< m/s
    double omega{0.0};    ///< rad/s
  };

  /// The count at the last step of the match up to now.
  [[nodiscard]] Count count(HostTime now);

 private:
  void advance_to(HostTime now);
  void look();

  std::size_t player_;
  HostTime moment_{};  // what the match's state stands for
  CameraClock clock_;
  Match match_;
  Renderer renderer_;
  Bodies bodies_;
  FramePipe* pipe_;
  Wheels wheels_;
  Random noise_;
  Scene scene_;
  std::vector<std::uint8_t> picture_;
  std::uint64_t frame_{0};
  FrameCount frames_;
};

}  // namespace teamsight::sim
