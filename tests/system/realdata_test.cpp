// tests/system/realdata_test.cpp: frames of a real robot through real processes to the world model.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "bus/clock.hpp"
#include "monitor.pb.h"
#include "tests/monitor/watcher.hpp"
#include "tests/system/team.hpp"

namespace teamsight::test {
namespace {

using namespace std::chrono_literals;

constexpr RobotId kInTheMiddle = 2;  // stands on the centre mark in its frame
constexpr double kClose = 0.10;      // m

std::filesystem::path data_directory() {
  const char* given = std::getenv("TEAMSIGHT_DATA");  // NOLINT(concurrency-mt-unsafe): never set
  return given != nullptr ? std::filesystem::path(given) : source_path("../shared/data");
}

// A robot as the page is told of it; nothing while it has no posture.
std::optional<v1::WorldTeammate> located(const v1::MonitorUpdate& update, RobotId robot) {
  for (const v1::WorldTeammate& mate : update.world().teammates()) {
    if (mate.robot_id() == robot && mate.status() != v1::POSTURE_LOST) return mate;
  }
  return std::nullopt;
}

// Four agents, each with one recorded frame, and a fusion beside each.
class Kassel : public testing::Test {
 protected:
  void SetUp() override {
    frames_ = data_directory() / "cnc_kassel";
    if (!std::filesystem::exists(frames_ / "log-image-0002.raw")) {
      GTEST_SKIP() << "NO REAL DATA: " << frames_
                   << " is not there; point TEAMSIGHT_DATA at the directory that holds cnc_kassel";
    }
  }

  // @param more  arguments for the agent of the robot in the middle
  void start(const std::vector<std::string>& more = {}) {
    for (int id = 1; id <= 4; ++id) {
      const std::string frame = "log-image-000" + std::to_string(id) + ".raw";
      std::vector<std::string> arguments{"--loop", "--rate-hz", "10"};
      if (id == kInTheMiddle) {
        arguments.insert(arguments.end(), more.begin(), more.end());
      }
      processes_.push_back(team_.agent(id, "raw:" + (frames_ / frame).string(), arguments));
      processes_.push_back(team_.fusion(id));
    }
    participant_ = std::make_unique<bus::Participant>(team_.join("teams/kassel.textproto"));
    listener_ = std::make_unique<Listener>(*participant_);
  }

  // Waits until robot 2 is in a world whose every part is later than `since`.
  bool is_placed_after(HostTime since) {
    return wait_until(
        [&] {
          listener_->listen();
          const auto mate = listener_->teammate(kInTheMiddle);
          return mate.has_value() && mate->status != PostureStatus::kLost &&
                 to_host_time(listener_->world->stamp, Duration{0}) - mate->age > since;
        },
        30s);
  }

  [[nodiscard]] double distance_to(const Point<Field>& place) const {
    const auto mate = listener_->teammate(kInTheMiddle);
    return mate.has_value() ? (mate->X_FR.origin().vector() - place.vector()).norm() : 1e9;
  }

  // Starts the coach station.
  // @return where its page's connection is, "127.0.0.1:port"
  std::string start_monitor() {
    static_cast<void>(web_.write("index.html", "<html></html>"));
    processes_.push_back(team_.monitor("teams/kassel.textproto", web_.path()));
    const ChildProcess& monitor = *processes_.back();
    EXPECT_TRUE(wait_until([&] { return monitor.out().find('}') != std::string::npos; }, 10s));
    const std::string line = monitor.out();
    const auto begin = line.find("http://");
    return host_of(line.substr(begin, line.find('"', begin) - begin));
  }

  [[nodiscard]] std::string errors() const {
    std::string all;
    for (const auto& process : processes_) {
      all += process->err();
    }
    return all;
  }

  std::filesystem::path frames_;
  TempDirectory web_;
  Team team_{"kassel"};
  std::vector<std::unique_ptr<ChildProcess>> processes_;
  std::unique_ptr<bus::Participant> participant_;
  std::unique_ptr<Listener> listener_;
};

TEST_F(Kassel, StandsInTheMiddleOfTheWorldModelWithoutAPrior) {
  start();

  ASSERT_TRUE(is_placed_after(HostTime{})) << errors();

  EXPECT_LT(distance_to({0.0, 0.0}), kClose);
}

TEST_F(Kassel, StandsInTheMiddleOfWhatTheCoachStationSends) {
  start();
  Watcher page(start_monitor());
  const auto until = std::chrono::steady_clock::now() + 30s;

  std::optional<v1::WorldTeammate> mate;
  v1::MonitorUpdate update;
  while (!mate.has_value() && std::chrono::steady_clock::now() < until) {
    ASSERT_TRUE(update.ParseFromString(page.next())) << errors();
    mate = located(update, kInTheMiddle);
  }

  ASSERT_TRUE(mate.has_value()) << errors();
  EXPECT_LT(std::hypot(mate->posture().x_m(), mate->posture().y_m()), kClose);
}

TEST_F(Kassel, StandsInTheMiddleWhateverPriorItIsStartedWith) {
  start({"--prior", "-3.5,2.0,1.0"});

  ASSERT_TRUE(is_placed_after(HostTime{})) << errors();

  EXPECT_LT(distance_to({0.0, 0.0}), kClose);
}

TEST_F(Kassel, ShowsAllFourRobotsWithAPosture) {
  start();

  const bool all = wait_until(
      [&] {
        listener_->listen();
        int found = 0;
        for (RobotId id = 1; id <= 4; ++id) {
          const auto mate = listener_->teammate(id);
          found += mate.has_value() && mate->status != PostureStatus::kLost ? 1 : 0;
        }
        return found == 4;
      },
      30s);

  EXPECT_TRUE(all) << errors();
}

TEST_F(Kassel, ComesBackToTheMiddleFromTwentyRandomPriors) {
  start();
  ASSERT_TRUE(is_placed_after(HostTime{})) << errors();
  std::mt19937 random(20);
  std::uniform_real_distribution<double> x(-4.45, 4.45);
  std::uniform_real_distribution<double> y(-2.79, 2.79);
  std::uniform_real_distribution<double> theta(-M_PI, M_PI);

  for (int i = 0; i < 20; ++i) {
    const Pose<Field, Robot> prior(x(random), y(random), theta(random));
    const std::uint32_t command = listener_->relocate(kInTheMiddle, prior);
    ASSERT_TRUE(wait_until(
        [&] {
          listener_->listen();
          return listener_->states[kInTheMiddle].command_acknowledged == command;
        },
        20s))
        << "prior " << i << "\n"
        << errors();
    ASSERT_TRUE(is_placed_after(bus::host_now())) << "prior " << i;
    EXPECT_LT(distance_to({0.0, 0.0}), kClose)
        << "prior " << i << ": " << prior.x() << ", " << prior.y() << ", " << prior.theta();
  }
}

TEST_F(Kassel, MovesWithTheFieldFile) {
  team_.config().append("fields/kassel-lab.textproto", "\noffset { x_m: 1.0 y_m: 0.5 }\n");
  start();

  ASSERT_TRUE(is_placed_after(HostTime{})) << errors();

  EXPECT_LT(distance_to({1.0, 0.5}), kClose);
}

}  // namespace
}  // namespace teamsight::test
