// tests/monitor/viewer/viewer_system_test.cpp: the real station watched by npm's client of
// Foxglove's protocol.
#include <chrono>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/support/process.hpp"

namespace teamsight {
namespace {

using test::ChildProcess;

constexpr std::chrono::milliseconds kBound{30'000};

class ViewerSystem : public ::testing::TestWithParam<const char*> {
 protected:
  static ChildProcess fake(const std::string& role, const std::string& robot) {
    return ChildProcess({TEAMSIGHT_FAKE_TEAM,
                         role,
                         robot,
                         std::to_string(test::unique_domain()),
                         test::source_path("config/dds/loopback.xml"),
                         "demo"});
  }

  /// What a viewer has seen once a message of each wanted topic has come.
  static nlohmann::json watch(ChildProcess& station, const std::vector<std::string>& wanted) {
    EXPECT_TRUE(test::wait_until([&]() { return !station.out().empty(); }, kBound))
        << station.err();
    const auto line = nlohmann::json::parse(station.out());
    const std::string url = line["url"];
    std::vector<std::string> argv{"/usr/bin/env",
                                  "node",
                                  test::source_path("tests/monitor/viewer/viewer.mjs"),
                                  "ws" + url.substr(4),
                                  GetParam()};
    argv.insert(argv.end(), wanted.begin(), wanted.end());
    ChildProcess viewer(argv, {{"PAGE_DIR", TEAMSIGHT_PAGE_DIR}});
    EXPECT_EQ(viewer.wait_exit(kBound), 0) << viewer.err();
    return nlohmann::json::parse(viewer.out());
  }
};

TEST_P(ViewerSystem, ShowsTopicsScenesAndEventsToAClientOfFoxglovesProtocol) {
  ChildProcess station({test::program("teamsight-monitor"),
                        "--team",
                        test::source_path("config/teams/demo.textproto"),
                        "--team-domain",
                        std::to_string(test::unique_domain()),
                        "--port",
                        "0"});
  const ChildProcess robot = fake("robot", "2");
  const ChildProcess fusion = fake("fusion", "3");

  const nlohmann::json seen = watch(station,
                                    {"teamsight/v1/WorldModel",
                                     "teamsight/v1/RobotState",
                                     "scene/field",
                                     "scene/ball",
                                     "scene/robots",
                                     "scene/obstacles",
                                     "scene/frames"});

  EXPECT_EQ(seen["protocol"], GetParam());
  EXPECT_EQ(seen["server"]["name"], "teamsight demo");
  EXPECT_TRUE(seen["topics"].contains("log"));
  const auto& world = seen["newest"]["teamsight/v1/WorldModel"];
  EXPECT_EQ(world["message"]["sample"]["robotId"], 3) << "fields go by their name in JSON";
  EXPECT_NEAR(world["ms"].get<double>(), seen["now_ms"].get<double>(), 20'000.0);
  const auto& robots = seen["newest"]["scene/robots"]["message"]["entities"];
  EXPECT_EQ(robots.size(), 5U);
  EXPECT_EQ(robots[0]["frameId"], "field");
  EXPECT_EQ(seen["newest"]["scene/frames"]["message"]["transforms"][0]["childFrameId"], "robot_1");
  EXPECT_EQ(seen["statuses"].size(), 0U);
}

INSTANTIATE_TEST_SUITE_P(BothNames,
                         ViewerSystem,
                         ::testing::Values("foxglove.websocket.v1", "foxglove.sdk.v1"));

}  // namespace
}  // namespace teamsight
