// tests/fusion/service_system_test.cpp: real fusion processes agree, and survive each other's end.
#include <csignal>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/fusion/fake_team.hpp"

namespace teamsight::fusion {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using teamsight::test::ChildProcess;
using teamsight::test::unique_domain;
using test::FakeTeam;
using test::ids_of;
using test::Shown;
using test::start_fusion;

// The lease of the topic on loopback, and what the hand-over may take on top of it.
constexpr Duration kHandOver = milliseconds(300);

bool play_until_led_by(FakeTeam& team, RobotId maker, milliseconds bound = seconds(20)) {
  return team.play_until([&] { return team.sees_whole_world_of(maker); }, bound);
}

/// How long a reader hears nothing when the leader is gone.
Duration silence_before_next(FakeTeam& team, RobotId next) {
  const HostTime last = team.heard().back().received;
  if (!play_until_led_by(team, next, seconds(5))) return Duration::max();
  for (const auto& world : team.heard()) {
    if (world.received > last && world.model.id.robot == next) return world.received - last;
  }
  return Duration::max();
}

/// How many models of this fusion a reader must believe to have missed, by their numbers.
std::size_t missed_of(const FakeTeam& team, RobotId maker) {
  std::size_t heard = 0;
  std::size_t newest = 0;
  for (const auto& world : team.heard()) {
    if (world.model.id.robot != maker) continue;
    ++heard;
    newest = world.model.id.sequence;
  }
  return newest - heard;
}

void expect_the_scene(const WorldModel& world) {
  ASSERT_EQ(world.balls.size(), 1U);
  EXPECT_NEAR(world.balls[0].p_FB.x, FakeTeam::kBall.x, 0.02);
  EXPECT_NEAR(world.balls[0].p_FB.y, FakeTeam::kBall.y, 0.02);
  ASSERT_EQ(world.obstacles.size(), 1U);
  EXPECT_NEAR(world.obstacles[0].p_FO.x, FakeTeam::kOpponent.x, 0.02);
  EXPECT_NEAR(world.obstacles[0].p_FO.y, FakeTeam::kOpponent.y, 0.02);
}

class FusionService : public testing::Test {
 protected:
  FusionService() : team_(unique_domain()) {
    for (RobotId robot = 1; robot <= 3; ++robot) {
      processes_.push_back(start_fusion(robot, unique_domain()));
    }
  }

  FakeTeam team_;
  std::vector<ChildProcess> processes_;
};

TEST_F(FusionService, TheStrongestLeadsWithTheWholeWorld) {
  ASSERT_TRUE(play_until_led_by(team_, 3)) << processes_[2].err();

  expect_the_scene(team_.heard().back().model);
}

TEST_F(FusionService, TheNextGoesOnWithTheSameWorldWhenTheLeaderIsKilled) {
  ASSERT_TRUE(play_until_led_by(team_, 3)) << processes_[2].err();
  // Long enough for the others to have learnt the names.
  const std::size_t count = team_.heard().size() + 30;
  ASSERT_TRUE(team_.play_until([&] { return team_.heard().size() > count; }, seconds(10)));
  const auto ids = ids_of(team_.heard().back().model);

  processes_[2].kill(SIGKILL);
  EXPECT_LE(silence_before_next(team_, 2), kHandOver);
  EXPECT_EQ(ids_of(team_.heard().back().model), ids);
  expect_the_scene(team_.heard().back().model);
  // It has made over a second's models for its own host meanwhile; over the air they do not count.
  EXPECT_LE(missed_of(team_, 2), 10U);

  processes_[1].kill(SIGKILL);
  EXPECT_LE(silence_before_next(team_, 1), kHandOver);
  EXPECT_EQ(ids_of(team_.heard().back().model), ids);
  expect_the_scene(team_.heard().back().model);
}

TEST_F(FusionService, ALeaderThatWasStoppedComesBackWithTheSameWorld) {
  ASSERT_TRUE(play_until_led_by(team_, 3)) << processes_[2].err();
  const std::size_t count = team_.heard().size() + 30;
  ASSERT_TRUE(team_.play_until([&] { return team_.heard().size() > count; }, seconds(10)));
  const auto ids = ids_of(team_.heard().back().model);

  processes_[2].kill(SIGSTOP);
  EXPECT_LE(silence_before_next(team_, 2), kHandOver);
  const std::size_t heard = team_.heard().size() + 60;
  ASSERT_TRUE(team_.play_until([&] { return team_.heard().size() > heard; }, seconds(20)));
  EXPECT_EQ(ids_of(team_.heard().back().model), ids);

  processes_[2].kill(SIGCONT);
  ASSERT_TRUE(play_until_led_by(team_, 3));
  for (const auto& world : team_.heard()) {
    if (world.received < team_.heard()[heard].received) continue;
    EXPECT_EQ(ids_of(world.model), ids) << "from " << int{world.model.id.robot};
  }
}

TEST_F(FusionService, TheNextGoesOnWithTheOperatorsHintWhenTheLeaderIsKilled) {
  constexpr std::uint32_t kCommand = 77;
  team_.show(Shown::kOrangeThing);
  ASSERT_TRUE(play_until_led_by(team_, 3)) << processes_[2].err();
  team_.show(Shown::kBoth);
  ASSERT_TRUE(team_.play_until(
      [&] { return team_.heard().back().model.balls.size() == 2 && !team_.sees_the_ball_first(); },
      seconds(10)));

  team_.hint(kCommand, FakeTeam::kBall);
  ASSERT_TRUE(team_.play_until([&] { return team_.sees_the_ball_first(); }, seconds(5)));
  const auto is_said = [&] {
    return team_.acknowledged().command == kCommand && team_.acknowledged().track != 0;
  };
  ASSERT_TRUE(team_.play_until(is_said, seconds(5)));

  processes_[2].kill(SIGKILL);
  const auto next_has_it = [&] {
    return team_.heard().back().model.id.robot == 2 && team_.sees_the_ball_first();
  };
  EXPECT_TRUE(team_.play_until(next_has_it, seconds(3)));
}

}  // namespace
}  // namespace teamsight::fusion
