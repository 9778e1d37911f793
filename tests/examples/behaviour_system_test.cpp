// tests/examples/behaviour_system_test.cpp: the example against a real fusion process.
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/fusion/fake_team.hpp"

namespace {

using std::chrono::seconds;
using teamsight::fusion::test::FakeTeam;
using teamsight::test::ChildProcess;
using teamsight::test::unique_domain;

ChildProcess start_behaviour(teamsight::RobotId robot) {
  return ChildProcess({teamsight::test::program("teamsight-behaviour").string(),
                       "--robot",
                       teamsight::fusion::test::robot_file(robot),
                       "--team-domain",
                       std::to_string(unique_domain()),
                       "--period-ms",
                       "50"});
}

/// The last whole line; null if there is none.
nlohmann::json last_decision(const ChildProcess& program) {
  std::istringstream lines(program.out());
  nlohmann::json last;
  for (std::string line; std::getline(lines, line);) {
    auto json = nlohmann::json::parse(line, nullptr, false);
    if (!json.is_discarded()) last = std::move(json);
  }
  return last;
}

bool is_decided(const nlohmann::json& decision) {
  return decision.is_object() && decision["source"] == "leader" && decision["attacker"].is_number();
}

TEST(Behaviour, EveryRobotSendsTheSameOneToTheBall) {
  FakeTeam team(unique_domain());
  const ChildProcess fusion = teamsight::fusion::test::start_fusion(2, unique_domain());
  const ChildProcess first = start_behaviour(1);
  const ChildProcess second = start_behaviour(2);

  const bool both = team.play_until(
      [&] {
        return is_decided(last_decision(first)) && is_decided(last_decision(second)) &&
               team.sees_whole_world_of(2);
      },
      seconds(20));

  ASSERT_TRUE(both) << fusion.err() << first.err() << second.err();
  // Robot 2 is nearest, although it must turn.
  EXPECT_EQ(last_decision(first)["attacker"], 2);
  EXPECT_EQ(last_decision(second)["attacker"], 2);
  EXPECT_EQ(last_decision(first)["i_go"], false);
  EXPECT_EQ(last_decision(second)["i_go"], true);
  EXPECT_NEAR(last_decision(first)["ball_x_m"].get<double>(), FakeTeam::kBall.x, 0.05);
  EXPECT_EQ(last_decision(first)["maker"], 2);
}

TEST(Behaviour, SaysThatThereIsNoWorldWhenNobodyFuses) {
  ChildProcess program({teamsight::test::program("teamsight-behaviour").string(),
                        "--robot",
                        teamsight::fusion::test::robot_file(1),
                        "--team-domain",
                        std::to_string(unique_domain()),
                        "--decisions",
                        "2"});

  EXPECT_EQ(program.wait_exit(seconds(10)), 0);
  EXPECT_EQ(last_decision(program)["source"], "none");
  EXPECT_TRUE(last_decision(program)["attacker"].is_null());
}

TEST(Behaviour, NamesAFileThatIsNotThere) {
  ChildProcess program(
      {teamsight::test::program("teamsight-behaviour").string(), "--robot", "/nowhere.textproto"});

  EXPECT_EQ(program.wait_exit(seconds(10)), 2);
  EXPECT_NE(program.err().find("/nowhere.textproto"), std::string::npos);
}

}  // namespace
