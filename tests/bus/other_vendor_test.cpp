// tests/bus/other_vendor_test.cpp: a robot on Fast DDS beside ours on Cyclone DDS.
#include <gtest/gtest.h>

#include "bus/writer.hpp"
#include "tests/bus/transport.hpp"

namespace teamsight::bus {
namespace {

RobotState state_of_robot_two(std::uint32_t sequence) {
  RobotState state;
  state.id = {2, 78, sequence};
  state.exposure = stamp_of(host_now());
  state.published = state.exposure;
  state.posture.status = PostureStatus::kOk;
  state.posture.X_FR = Pose<Field, Robot>{1.5, 0.0, 0.0};
  state.posture.cov = Eigen::Matrix3d::Identity() * 1e-4;
  state.frame_rate = 30.0;
  state.software_version = "0.1.0-test";
  return state;
}

TEST(OtherVendor, ReadsOurWorldAndIsTakenByOurFusion) {
  const std::string domain = std::to_string(test::unique_domain());
  test::ChildProcess fusion({test::program("teamsight-fusion").string(),
                             "--robot",
                             test::source_path("config/robots/robot1.textproto").string(),
                             "--team-domain",
                             domain});
  const auto team = Participant::join(testing::own_domain("demo"));
  Writer<RobotState> states(team);
  test::ChildProcess other({OTHER_VENDOR, domain, "demo", "20"});

  std::uint32_t sequence = 0;
  std::optional<int> code;
  while (!code && sequence < 1000) {
    states.write(state_of_robot_two(++sequence));
    code = other.wait_exit(testing::milliseconds(33));
  }

  EXPECT_EQ(code, 0) << other.out() << other.err() << fusion.err();
}

}  // namespace
}  // namespace teamsight::bus
