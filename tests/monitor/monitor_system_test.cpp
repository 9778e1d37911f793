// tests/monitor/monitor_system_test.cpp: the real station and writers on the bus, up to the
// WebSocket.
#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>

#include "bus/participant.hpp"
#include "monitor.pb.h"
#include "tests/bus/forger.hpp"
#include "tests/monitor/watcher.hpp"
#include "tests/support/process.hpp"

namespace teamsight {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using test::ChildProcess;
using ::testing::HasSubstr;

constexpr milliseconds kStart{10'000};

/// A station of its own domain, with a page of one line, and the fake team that it watches.
class Monitor : public ::testing::Test {
 protected:
  void SetUp() override {
    static_cast<void>(web_.write("index.html", "<html></html>"));
    monitor_.emplace(arguments("0"));
    ASSERT_TRUE(test::wait_until([&]() { return !monitor_->out().empty(); }, kStart))
        << monitor_->err();
  }

  [[nodiscard]] std::vector<std::string> arguments(const std::string& port) const {
    return {test::program("teamsight-monitor"),
            "--team",
            test::source_path("config/teams/demo.textproto"),
            "--team-domain",
            std::to_string(test::unique_domain()),
            "--port",
            port,
            "--web",
            web_.path()};
  }

  /// "127.0.0.1:port", from the station's first line.
  [[nodiscard]] std::string host() const {
    const std::string line = monitor_->out();
    const auto begin = line.find("http://");
    return test::host_of(line.substr(begin, line.find('"', begin) - begin));
  }

  /// A page's order, with the token of the station's first line.
  [[nodiscard]] std::string mute(std::uint32_t robot, bool muted = true) const {
    const std::string line = monitor_->out();
    const auto begin = line.find("#token=") + 7;
    v1::MonitorRequest request;
    request.set_token(line.substr(begin, line.find('"', begin) - begin));
    request.mutable_mute()->set_robot_id(robot);
    request.mutable_mute()->set_muted(muted);
    return request.SerializeAsString();
  }

  static ChildProcess fake(const std::string& role, const std::string& robot) {
    return ChildProcess(
        {test::program("teamsight-monitor").parent_path() / "../tests/teamsight-fake-team",
         role,
         robot,
         std::to_string(test::unique_domain()),
         test::source_path("config/dds/loopback.xml"),
         "demo"});
  }

  /// Reads updates until one fulfils the condition, or `bound` has passed.
  ///
  /// @return whether one did
  static bool watch(test::Watcher& watcher,
                    milliseconds bound,
                    const std::function<bool(const v1::MonitorUpdate&)>& is_fulfilled) {
    const auto until = std::chrono::steady_clock::now() + bound;
    while (std::chrono::steady_clock::now() < until) {
      v1::MonitorUpdate update;
      if (!update.ParseFromString(watcher.next())) return false;
      if (is_fulfilled(update)) return true;
    }
    return false;
  }

  test::TempDirectory web_;
  std::optional<ChildProcess> monitor_;
};

TEST_F(Monitor, ShowsWhatRobotsAndFusionWrite) {
  const ChildProcess robot1 = fake("robot", "1");
  const ChildProcess robot2 = fake("robot", "2");
  const ChildProcess fusion = fake("fusion", "2");
  test::Watcher watcher(host());
  v1::MonitorUpdate seen;

  const bool all_seen = watch(watcher, kStart, [&](const v1::MonitorUpdate& update) {
    seen = update;
    return update.robots_size() == 2 && update.has_world() && update.silence().empty() &&
           update.robots(0).received() > 20 && update.robots(1).received() > 20;
  });

  ASSERT_TRUE(all_seen) << seen.ShortDebugString();
  EXPECT_EQ(seen.robots(0).robot_id(), 1U);
  EXPECT_TRUE(seen.robots(1).alive());
  EXPECT_GT(seen.robots(1).rate_hz(), 5.0);
  EXPECT_GE(seen.robots(1).latency_p50_ms(), 25.0);  // the fake team publishes 25 ms after exposure
  EXPECT_EQ(seen.world().sample().robot_id(), 2U);
  EXPECT_EQ(seen.world().teammates_size(), 5);
  EXPECT_NEAR(seen.world().balls(0).existence(), 0.97, 1e-9);
}

TEST_F(Monitor, BeginsWithTheFieldAndSaysWhyNothingShows) {
  test::Watcher watcher(host());
  v1::MonitorUpdate first;

  ASSERT_TRUE(first.ParseFromString(watcher.next()));

  EXPECT_EQ(first.field().name(), "msl-2024");
  EXPECT_EQ(first.field().length_m(), 22.0);
  EXPECT_EQ(first.team(), "demo");
  EXPECT_THAT(first.silence(), HasSubstr("Nothing heard yet on domain"));
}

TEST_F(Monitor, NamesTheDomainOfSomebodyElseWhileItHearsNobody) {
  const auto red = bus::Participant::join(
      {test::unique_domain(), test::source_path("config/dds/loopback.xml"), "red"});
  test::Watcher watcher(host());
  std::string last;

  EXPECT_TRUE(watch(watcher, kStart, [&](const v1::MonitorUpdate& update) {
    last = update.silence();
    return last.find("This network carries domain ") != std::string::npos;
  })) << last;
}

TEST_F(Monitor, DoesNotTakeItsOwnPauseForTheRobots) {
  const ChildProcess robot1 = fake("robot", "1");
  const ChildProcess robot2 = fake("robot", "2");
  test::Watcher watcher(host());
  ASSERT_TRUE(watch(watcher, kStart, [](const v1::MonitorUpdate& update) {
    return update.robots_size() == 2 && update.robots(0).alive() && update.robots(1).alive();
  }));

  monitor_->kill(SIGSTOP);
  std::this_thread::sleep_for(milliseconds(1500));  // the pause itself is what is tested
  monitor_->kill(SIGCONT);
  std::string events;
  int fresh = 0;
  const bool goes_on = watch(watcher, kStart, [&](const v1::MonitorUpdate& update) {
    for (const v1::MonitorEvent& event : update.events()) events += event.text() + "\n";
    fresh += update.robots(0).age_ms() < 200.0 && update.robots(1).age_ms() < 200.0 ? 1 : 0;
    return fresh == 30;
  });

  EXPECT_TRUE(goes_on);
  EXPECT_THAT(events, ::testing::Not(::testing::HasSubstr("silent")));
}

TEST_F(Monitor, TellsWithinASecondThatARobotFellSilent) {
  const ChildProcess steady = fake("robot", "1");
  ChildProcess lost = fake("robot", "2");
  test::Watcher watcher(host());
  ASSERT_TRUE(watch(watcher, kStart, [](const v1::MonitorUpdate& update) {
    return update.robots_size() == 2 && update.robots(0).alive() && update.robots(1).alive();
  }));

  lost.kill(SIGKILL);
  const bool told = watch(watcher, seconds(5), [](const v1::MonitorUpdate& update) {
    return !update.robots(1).alive();
  });
  bool is_logged = false;
  double age_ms = 0.0;
  const bool logged = watch(watcher, seconds(5), [&](const v1::MonitorUpdate& update) {
    for (const v1::MonitorEvent& event : update.events()) {
      is_logged = is_logged || event.text() == "Robot 2 is silent";
    }
    age_ms = update.robots(1).age_ms();
    return is_logged;
  });

  EXPECT_TRUE(told);
  EXPECT_TRUE(logged);
  EXPECT_LT(age_ms, 1000.0);
}

TEST_F(Monitor, IsObeyedThoughAForgedPacketKeepsItsOrdersFromTheRobots) {
  const ChildProcess robot = fake("robot", "1");
  test::Watcher watcher(host());
  ASSERT_TRUE(watch(watcher, kStart, [](const v1::MonitorUpdate& update) {
    return update.robots_size() == 1 && update.robots(0).received() > 20;
  }));
  watcher.send_binary(mute(1));
  ASSERT_TRUE(watch(watcher, kStart, [](const v1::MonitorUpdate& update) {
    return update.actions_size() == 1 && update.actions(0).state() == "done";
  })) << "the robot does not hear orders at all";
  const auto stranger = bus::Participant::join(
      {test::unique_domain(), test::source_path("config/dds/loopback.xml").string(), "demo"});
  std::optional<bus::WriterName> orders;
  ASSERT_TRUE(test::wait_until(
      [&] {
        orders = bus::testing::announced_writer(stranger, "teamsight/v1/Command");
        return orders.has_value();
      },
      kStart));
  // An order that follows at once comes by another socket, and may overtake a single packet.
  for (int i = 0; i < 10; ++i) {
    bus::testing::send_forged(bus::testing::forged_heartbeat(*orders), test::unique_domain());
    std::this_thread::sleep_for(milliseconds(30));
  }

  watcher.send_binary(mute(1, false));

  bool has_waited = false;
  EXPECT_TRUE(watch(watcher, seconds(5), [&](const v1::MonitorUpdate& update) {
    const auto& actions = update.actions();
    has_waited = has_waited || std::ranges::any_of(actions, [](const v1::MonitorAction& action) {
                   return action.state() == "waiting" && action.age_ms() > 1000.0;
                 });
    return has_waited && std::ranges::all_of(actions, [](const v1::MonitorAction& action) {
             return action.state() == "done";
           });
  }));
  EXPECT_TRUE(has_waited) << "nothing was forged";
}

TEST_F(Monitor, ASecondOneOnTheSamePortSaysSoAndLeaves) {
  const std::string port = host().substr(host().rfind(':') + 1);

  ChildProcess second(arguments(port));
  const auto exit_code = second.wait_exit(kStart);

  EXPECT_EQ(exit_code, 2);
  EXPECT_EQ(
      second.err(),
      "teamsight-monitor: port " + port + " is in use on 127.0.0.1, choose another with --port\n");
  EXPECT_TRUE(monitor_->is_running());
}

TEST_F(Monitor, EndsAtSigintWithExitCodeZero) {
  test::Watcher watcher(host());
  ASSERT_NE(watcher.next(), "");

  monitor_->kill(SIGINT);

  EXPECT_EQ(monitor_->wait_exit(seconds(5)), 0);
}

TEST(MonitorStart, NamesTheFileThatIsWrong) {
  const test::TempDirectory folder;
  const auto team = folder.write("t.textproto", "name: \"x\"\nnope: 3\n");

  ChildProcess monitor({test::program("teamsight-monitor"), "--team", team, "--port", "0"});
  const auto exit_code = monitor.wait_exit(kStart);

  const std::string said = monitor.err();
  EXPECT_EQ(exit_code, 2);
  EXPECT_THAT(said, HasSubstr("t.textproto"));
  EXPECT_THAT(said, HasSubstr("nope"));
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
}

}  // namespace
}  // namespace teamsight
