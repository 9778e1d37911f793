// bench/ping_bus.cpp: the ping of ping.hpp through bus/, as our processes read and write.
#include <poll.h>

#include "bench/ping.hpp"
#include "bus/clock.hpp"
#include "bus/messages.hpp"
#include "bus/participant.hpp"
#include "bus/reader.hpp"
#include "bus/writer.hpp"

namespace teamsight::bench {
namespace {

bus::Sightings typical_sightings(RobotId robot) {
  bus::Sightings sightings;
  sightings.id = {robot, 1, 0};
  sightings.posture.status = PostureStatus::kOk;
  sightings.posture.X_FR = {1.0, 2.0, 0.5};
  sightings.posture.cov = Eigen::Vector3d(1e-4, 1e-4, 1e-5).asDiagonal();
  sightings.posture.inlier_ratio = 0.8;
  sightings.posture.line_points = 150;
  BallRay ball;
  ball.ray_R = {{0.0, 0.0, 0.6}, Eigen::Vector3d(0.8, 0.0, -0.6)};
  ball.cov_direction = Eigen::Matrix2d::Identity() * 1e-5;
  ball.confidence = 0.9;
  sightings.balls.assign(kPingBalls, ball);
  ObstacleSighting obstacle;
  obstacle.p_RO = {2.0, 1.0};
  obstacle.cov_R = Eigen::Matrix2d::Identity() * 1e-2;
  obstacle.width = 0.5;
  obstacle.confidence = 0.7;
  sightings.obstacles.assign(kPingObstacles, obstacle);
  return sightings;
}

class Node {
 public:
  Node(const PingPlan& plan, RobotId robot)
      : participant_(bus::Participant::join({plan.domain_id, plan.profile_path, "bench"})),
        reader_(participant_),
        writer_(participant_),
        sightings_(typical_sightings(robot)) {}

  void write() {
    ++sightings_.id.sequence;
    sightings_.exposure = sightings_.published = stamp_of(bus::host_now());
    writer_.write(sightings_);
  }

  // Waits for a valid sample and takes it; false if none came in time.
  [[nodiscard]] bool wait_and_take() {
    const HostTime until = bus::host_now() + kAnswerWithin;
    bool any = false;
    while (!any) {
      const auto left =
          std::chrono::ceil<std::chrono::milliseconds>(until - bus::host_now()).count();
      pollfd data{reader_.event_fd(), POLLIN, 0};
      if (left <= 0 || ::poll(&data, 1, static_cast<int>(left)) <= 0) {
        return false;
      }
      reader_.take(bus::host_now(), [&](const bus::Sample<bus::Sightings>& sample) {
        any = any || sample.message.has_value();
      });
    }
    return true;
  }

 private:
  bus::Participant participant_;
  bus::Reader<bus::Sightings> reader_;
  bus::Writer<bus::Sightings> writer_;
  bus::Sightings sightings_;
};

}  // namespace

PingResult ping_bus(const PingPlan& plan) {
  Node node(plan, 1);
  return run_pings(plan, [&] {
    node.write();
    return node.wait_and_take();
  });
}

void echo_bus(const PingPlan& plan) {
  Node node(plan, 2);
  while (true) {
    if (node.wait_and_take()) {
      node.write();
    }
  }
}

}  // namespace teamsight::bench
