// tests/tools/doctor_findings_test.cpp: what the doctor says of a healthy robot, and of every ill
// one.
#include "tools/doctor_findings.hpp"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace teamsight::tools {
namespace {

using ::testing::HasSubstr;

Observed healthy() {
  Observed seen;
  seen.robot = 3;
  seen.software_version = "0.1.0";
  seen.camera_exists = true;
  seen.camera_device = "/dev/video0";
  seen.calibration_days = 1.0;
  seen.heard = {{3, {30.0, false, 0.3, "0.1.0"}}, {4, {30.0, false, 0.3, "0.1.0"}}};
  seen.expected = {3, 4};
  seen.state_writers = 2;
  seen.leader = 4;
  seen.own_fusion = true;
  seen.clock_sigmas = {{3, std::chrono::milliseconds(1)}, {4, Duration{0}}};
  seen.team_bps = 1.2e6;
  seen.disk_free_gb = 20.0;
  return seen;
}

/// The finding about this.
Finding about(const Observed& seen, const std::string& check) {
  const auto all = findings(seen);
  const auto found =
      std::ranges::find_if(all, [&](const Finding& finding) { return finding.check == check; });
  return found == all.end() ? Finding{"nothing", true, "", ""} : *found;
}

/// That this is wrong, that it says why, and that nothing else is wrong.
void expect_only(const Observed& seen, const std::string& check, const std::string& what_to_do) {
  for (const Finding& finding : findings(seen)) {
    EXPECT_EQ(finding.ok, finding.check != check) << finding.check << ": " << finding.found;
  }
  EXPECT_THAT(about(seen, check).what_to_do, HasSubstr(what_to_do));
}

TEST(Doctor, FindsNothingWrongWithAHealthyRobot) {
  for (const Finding& finding : findings(healthy())) {
    EXPECT_TRUE(finding.ok) << finding.check << ": " << finding.found;
    EXPECT_EQ(finding.what_to_do, "");
  }
}

TEST(Doctor, SaysOnWhichOtherComputerTheIdIsUsed) {
  Observed twin = healthy();
  twin.rival = "omni2 (192.168.1.12)";

  expect_only(twin, "id", "give one of the two robots another id");
  EXPECT_EQ(about(twin, "id").found, "robot id 3 is used on omni2 (192.168.1.12) too");
}

TEST(Doctor, SaysWhichCardItIsOnAndAsksForANameAmongSeveral) {
  Observed seen = healthy();
  seen.profile = "wifi.xml";
  seen.card = "wlan0";
  EXPECT_EQ(about(seen, "card").found, "wifi.xml on wlan0");

  seen.card.clear();
  seen.cards_up = {"eth0 (192.168.1.5)"};
  EXPECT_EQ(about(seen, "card").found, "wifi.xml on eth0 (192.168.1.5)");

  seen.cards_up.emplace_back("wlan0 (10.0.0.5)");
  expect_only(seen, "card", "name the team's card in the profile");
}

TEST(Doctor, SaysWhatToDoAboutTheCamera) {
  Observed lost = healthy();
  lost.heard[3].camera_lost = true;
  expect_only(lost, "camera", "cable");

  Observed slow = healthy();
  slow.heard[3].frame_rate_hz = 12.0;
  expect_only(slow, "camera", "exposure");

  Observed no_agent = healthy();
  no_agent.heard.erase(3);
  no_agent.expected = {4};
  expect_only(no_agent, "camera", "systemctl start teamsight-agent@robot3");

  no_agent.camera_exists = false;
  expect_only(no_agent, "camera", "--device");
}

TEST(Doctor, WantsANewCalibrationWhenItIsOldOrHasDrifted) {
  Observed old = healthy();
  old.calibration_days = 30.0;
  expect_only(old, "calibration", "calibrate");

  Observed drifted = healthy();
  drifted.heard[3].calibration_drift_px = 2.0;
  expect_only(drifted, "calibration", "moved");
}

TEST(Doctor, NamesThePeersThatAreMissing) {
  Observed seen = healthy();
  seen.expected = {3, 4, 5};

  expect_only(seen, "peers", "same team file");
  EXPECT_THAT(about(seen, "peers").found, HasSubstr("not heard: 5"));
}

TEST(Doctor, TellsDroppedMulticastFromNobodyThere) {
  Observed dropped = healthy();
  dropped.heard.erase(4);
  dropped.expected = {3};
  expect_only(dropped, "network", "drops multicast");

  dropped.state_writers = 1;
  expect_only(dropped, "network", "interface");

  dropped.other_domains = "domain 22 (red)";
  EXPECT_THAT(about(dropped, "network").found, HasSubstr("this network carries domain 22 (red)"));
}

TEST(Doctor, SaysWhatElseIsWrong) {
  Observed clocks = healthy();
  clocks.clock_sigmas[3] = Duration{0};
  expect_only(clocks, "clocks", "wait");

  Observed security = healthy();
  security.secured = true;
  security.certificate_days = 3.0;
  expect_only(security, "security", "--renew");

  Observed fusion = healthy();
  fusion.own_fusion = false;
  expect_only(fusion, "fusion", "teamsight-fusion@robot3");

  Observed versions = healthy();
  versions.heard[4].version = "0.0.9";
  expect_only(versions, "versions", "same packages");

  Observed air = healthy();
  air.team_bps = 2.1e6;
  expect_only(air, "air", "frame rate");

  Observed disk = healthy();
  disk.disk_free_gb = 0.5;
  expect_only(disk, "disk", "recordings");
}

}  // namespace
}  // namespace teamsight::tools
