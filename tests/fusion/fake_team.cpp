// tests/fusion/fake_team.cpp: see tests/fusion/fake_team.hpp.
#include "tests/fusion/fake_team.hpp"

#include <algorithm>

#include <poll.h>

#include "bus/clock.hpp"
#include "process/domains.hpp"
#include "process/program.hpp"
#include "settings/load.hpp"

namespace teamsight::fusion::test {
namespace {

constexpr Duration kFrame = std::chrono::milliseconds(33);

const Pose<Field, Robot> kStands[] = {{-2.0, 0.0, 0.0}, {3.0, 1.0, 2.0}, {2.0, -3.0, 1.0}};

bus::DomainSettings demo_domain(std::uint32_t team_domain) {
  const auto team = settings::load_robot(robot_file(1)).team;
  return process::team_domain(team, {team_domain, ""});
}

}  // namespace

std::string robot_file(RobotId robot) {
  return teamsight::test::source_path("config/robots/robot" + std::to_string(robot) + ".textproto")
      .string();
}

teamsight::test::ChildProcess start_fusion(RobotId robot, std::uint32_t team_domain) {
  return teamsight::test::ChildProcess({teamsight::test::program("teamsight-fusion").string(),
                                        "--robot",
                                        robot_file(robot),
                                        "--team-domain",
                                        std::to_string(team_domain)});
}

std::vector<std::uint32_t> ids_of(const WorldModel& world) {
  std::vector<std::uint32_t> ids;
  for (const WorldBall& ball : world.balls) ids.push_back(ball.track);
  for (const WorldObstacle& obstacle : world.obstacles) ids.push_back(obstacle.track);
  return ids;
}

FakeTeam::FakeTeam(std::uint32_t team_domain)
    : participant_(bus::Participant::join(demo_domain(team_domain))),
      commands_(participant_),
      worlds_(participant_),
      explanations_(participant_) {
  for (RobotId robot = 1; robot <= 3; ++robot) {
    writers_.emplace_back(participant_);
    eyes_.emplace_back(robot, process::draw_boot_id());
  }
}

void FakeTeam::write_frames() {
  for (std::size_t i = 0; i < eyes_.size(); ++i) {
    Eye& eye = eyes_[i];
    eye.look(kStands[i], bus::host_now());
    const bool is_blind_to_the_ball = shown_ == Shown::kBoth && i == 1;
    if (shown_ != Shown::kBall) eye.see_ball(kOrangeThing);
    if (shown_ != Shown::kOrangeThing && !is_blind_to_the_ball) eye.see_ball(kBall);
    eye.see_obstacle(kOpponent);
    bus::Sightings sightings;
    sightings.id = eye.frame().id;
    sightings.exposure = stamp_of(eye.frame().exposure);
    sightings.published = stamp_of(bus::host_now());
    sightings.posture = eye.frame().posture;
    sightings.balls = eye.frame().balls;
    sightings.obstacles = eye.frame().obstacles;
    writers_[i].write(sightings);
  }
}

void FakeTeam::hint(std::uint32_t command, const Point<Field>& p_FB) {
  bus::Command order;
  order.id = {kNobody, 1, 1};
  order.command = command;
  order.kind = bus::CommandKind::kBallHint;
  order.X_FR = {p_FB.x, p_FB.y, 0.0};
  order.cov = 0.25 * Eigen::Matrix3d::Identity();
  commands_.write(order);
}

bool FakeTeam::sees_the_ball_first() const {
  if (heard_.empty() || heard_.back().model.balls.size() != 2) return false;
  const Point<Field> first = heard_.back().model.balls[0].p_FB.on_floor();
  return (first.vector() - kBall.vector()).norm() < 0.3;
}

bool FakeTeam::play_until(const std::function<bool()>& is_done, std::chrono::milliseconds bound) {
  const HostTime end = bus::host_now() + bound;
  for (HostTime now = bus::host_now(); now < end; now = bus::host_now()) {
    if (now >= next_frame_) {
      write_frames();
      next_frame_ = now + kFrame;
    }
    worlds_.take(now, [&](const bus::Sample<WorldModel>& sample) {
      if (sample.message) heard_.push_back({*sample.message, now});
    });
    explanations_.take(now, [&](const bus::Sample<bus::Explanation>& sample) {
      if (sample.message) acknowledged_ = sample.message->hint;
    });
    if (is_done()) return true;
    const auto rest =
        std::chrono::duration_cast<std::chrono::milliseconds>(next_frame_ - bus::host_now());
    pollfd waiting{worlds_.event_fd(), POLLIN, 0};
    poll(&waiting, 1, static_cast<int>(std::clamp<std::int64_t>(rest.count(), 0, 33)));
  }
  return false;
}

bool FakeTeam::sees_whole_world_of(RobotId maker) const {
  if (heard_.empty()) return false;
  const WorldModel& world = heard_.back().model;
  return world.id.robot == maker && world.balls.size() == 1 && world.obstacles.size() == 1 &&
         world.teammates.size() == 3 && world.balls[0].supporters == 7;
}

}  // namespace teamsight::fusion::test
