// sim/robot_camera.cpp: see robot_camera.hpp.
#include "sim/robot_camera.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/expect.hpp"

namespace teamsight::sim {
namespace {

constexpr std::uint32_t kWheelSeed = 1000;
constexpr std::uint32_t kNoiseSeed = 2000;

}  // namespace

RobotCamera::RobotCamera(
    std::size_t player, const CameraClock& clock, Match match, Eye eye, FramePipe& pipe)
    : player_(player),
      clock_(clock),
      match_(std::move(match)),
      renderer_(std::move(eye.renderer)),
      bodies_(std::move(eye.bodies)),
      pipe_(&pipe),
      wheels_({}, kWheelSeed + static_cast<std::uint32_t>(player)),
      noise_(kNoiseSeed + static_cast<std::uint32_t>(player)) {
  TEAMSIGHT_EXPECT(player < match_.state().players.size());
}

void RobotCamera::advance_to(HostTime now) {
  const double seconds = to_seconds(now - clock_.start) - kBeforeKickOff;
  while (match_.time() + Match::kStep <= seconds) {
    match_.advance_to(match_.time() + Match::kStep);
    wheels_.roll(match_.state().players[player_], Match::kStep);
  }
  // Before kick-off the match's first moment stands for the present.
  moment_ = std::min(now, clock_.start + from_seconds(kBeforeKickOff + match_.time()));
}

void RobotCamera::tick(HostTime now) {
  pipe_->flush();
  const double due = to_seconds(now - clock_.start) * clock_.frame_rate_hz - clock_.phase;
  if (due < static_cast<double>(frame_ + 1)) {
    return;
  }
  const std::uint64_t before = frame_;
  frame_ = static_cast<std::uint64_t>(due);  // frames that should have been before now are lost
  advance_to(now);
  const bool is_free = pipe_->is_free();
  frames_.due += pipe_->is_read() ? frame_ - before : 0;
  if (is_free) {
    ++frames_.taken;
    look();
  }
}

void RobotCamera::look() {
  show(match_.state(), player_, bodies_, scene_);
  renderer_.draw(scene_, noise_, picture_);
  const vision::CameraParameters& camera = renderer_.camera();
  pipe_->send({camera.width_px, camera.height_px, camera.format, moment_, frame_}, picture_);
}

RobotCamera::Count RobotCamera::count(HostTime now) {
  advance_to(now);
  return {moment_, wheels_.pose(), wheels_.velocity(), wheels_.omega()};
}

}  // namespace teamsight::sim
