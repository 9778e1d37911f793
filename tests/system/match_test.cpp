// tests/system/match_test.cpp: a simulated team of real processes, and what happens when parts go.
#include <algorithm>
#include <csignal>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bus/clock.hpp"
#include "process/domains.hpp"
#include "settings/load.hpp"
#include "tests/system/team.hpp"

namespace teamsight::test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

constexpr int kRobots = 3;

// The truth of the last seconds, by its stamp.
class TruthBook {
 public:
  explicit TruthBook(const bus::Participant& host) : reader_(host) {}

  void listen() {
    reader_.take(bus::host_now(), [this](const bus::Sample<bus::Truth>& sample) {
      if (sample.message.has_value()) {
        book_.push_back(*sample.message);
      }
    });
    while (book_.size() > 1000) {
      book_.pop_front();
    }
  }

  [[nodiscard]] const bus::Truth* at(PeerTime stamp) const {
    for (const bus::Truth& truth : book_) {
      if (std::chrono::abs(truth.stamp - stamp) < 15ms) {
        return &truth;
      }
    }
    return nullptr;
  }

 private:
  bus::Reader<bus::Truth> reader_;
  std::deque<bus::Truth> book_;
};

double median(std::vector<double> values) {
  if (values.empty()) {
    return 1e9;
  }
  std::nth_element(values.begin(),
                   values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

class SimulatedMatch : public testing::Test {
 protected:
  SimulatedMatch() {
    team_.config().replace("matches/demo.textproto",
                           "field: \"../fields/msl-2024.textproto\"\n"
                           "camera: \"../cameras/sim-640.textproto\"\n"
                           "team: \"../teams/demo.textproto\"\n"
                           "robot: [1, 2, 3]\nopponents: 2\nframe_rate_hz: 8\n");
  }

  void start() {
    simulator_ = team_.simulator();
    for (int id = 1; id <= kRobots; ++id) {
      agents_.push_back(team_.agent(id, team_.stream(id)));
      fusions_.push_back(team_.fusion(id));
    }
    participant_ = std::make_unique<bus::Participant>(team_.join("teams/demo.textproto"));
    listener_ = std::make_unique<Listener>(*participant_);
  }

  bool waits_for(const std::function<bool()>& is_true) {
    return wait_until(
        [&] {
          listener_->listen();
          return is_true();
        },
        40s);
  }

  bool all_have_postures() {
    for (RobotId id = 1; id <= kRobots; ++id) {
      const auto mate = listener_->teammate(id);
      if (!mate.has_value() || mate->status == PostureStatus::kLost) {
        return false;
      }
    }
    return true;
  }

  // How far the world's robots and ball are from the truth, over some hundred worlds.
  struct Errors {
    std::vector<double> robots;
    std::vector<double> ball;
  };

  Errors compare(TruthBook& truth, std::size_t worlds) {
    Errors errors;
    ObservationId last;
    std::size_t compared = 0;
    (void)waits_for([&] {
      truth.listen();
      if (listener_->world->id == last) {
        return false;
      }
      const bus::Truth* then = truth.at(listener_->world->stamp);
      if (then != nullptr) {
        last = listener_->world->id;
        compare_one(*then, errors);
        ++compared;
      }
      return compared >= worlds;
    });
    return errors;
  }

  void compare_one(const bus::Truth& truth, Errors& errors) {
    for (const bus::TrueRobot& robot : truth.robots) {
      const auto mate = listener_->teammate(robot.robot);
      if (mate.has_value() && mate->status != PostureStatus::kLost) {
        errors.robots.push_back(
            (mate->X_FR.origin().vector() - robot.X_FR.origin().vector()).norm());
      }
    }
    if (!listener_->world->balls.empty()) {
      errors.ball.push_back(
          (listener_->world->balls.front().p_FB.vector() - truth.p_FB.vector()).norm());
    }
  }

  [[nodiscard]] bus::Participant join_match() const {
    const auto team = settings::load_team(team_.config().file("teams/demo.textproto"));
    return bus::Participant::join(
        process::host_domain(team, {unique_domain(), {}}, team.name + ".match"));
  }

  [[nodiscard]] std::string errors() const {
    std::string all = simulator_->err();
    for (const auto& process : agents_) {
      all += process->err();
    }
    for (const auto& process : fusions_) {
      all += process->err();
    }
    return all;
  }

  Team team_{"robot"};
  std::unique_ptr<ChildProcess> simulator_;
  std::vector<std::unique_ptr<ChildProcess>> agents_;
  std::vector<std::unique_ptr<ChildProcess>> fusions_;
  std::unique_ptr<bus::Participant> participant_;
  std::unique_ptr<Listener> listener_;
};

TEST_F(SimulatedMatch, ShowsEveryRobotAndTheBallWhereTheyAre) {
  start();
  const bus::Participant host = join_match();
  TruthBook truth(host);
  ASSERT_TRUE(waits_for([&] { return all_have_postures(); })) << errors();

  const Errors found = compare(truth, 200);

  ASSERT_GE(found.robots.size(), 400U) << errors();
  EXPECT_LT(median(found.robots), 0.15);
  ASSERT_GE(found.ball.size(), 50U);
  EXPECT_LT(median(found.ball), 0.3);
}

TEST_F(SimulatedMatch, GoesOnWithoutACameraAndTakesItUpAgain) {
  start();
  ASSERT_TRUE(waits_for([&] { return all_have_postures(); })) << errors();

  simulator_.reset();

  EXPECT_TRUE(waits_for([&] {
    const bus::Diagnostics& agent = listener_->diagnostics["agent/1"];
    return listener_->states[1].camera_lost && !agent.healthy && agent.frame_age_ms > 500.0;
  }));
  EXPECT_THAT(listener_->diagnostics["agent/1"].message, HasSubstr("camera"));
  const ObservationId before = listener_->world->id;
  EXPECT_TRUE(waits_for([&] { return listener_->world->id != before; }));
  EXPECT_TRUE(agents_[0]->is_running());

  simulator_ = team_.simulator();

  EXPECT_TRUE(waits_for([&] {
    return !listener_->states[1].camera_lost &&
           listener_->states[1].posture.status != PostureStatus::kLost;
  })) << errors();
}

TEST_F(SimulatedMatch, EndsASecondAgentWithTheSameId) {
  start();
  ASSERT_TRUE(waits_for([&] { return listener_->states.contains(1); })) << errors();

  const auto second = team_.agent(1, team_.stream(1));

  EXPECT_EQ(second->wait_exit(40s), 2);
  const std::string words = second->err();
  EXPECT_THAT(words, HasSubstr("robot id 1 is used twice on this computer: end one of the two"));
  EXPECT_EQ(std::count(words.begin(), words.end(), '\n'), 1) << words;
  EXPECT_TRUE(agents_[0]->is_running());
}

}  // namespace
}  // namespace teamsight::test
