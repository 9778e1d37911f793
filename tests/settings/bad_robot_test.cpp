// tests/settings/bad_robot_test.cpp: robot, team and match files, good and bad.
#include <gmock/gmock.h>

#include "settings/load.hpp"
#include "tests/settings/temporary_files.hpp"

namespace teamsight::settings {
namespace {

constexpr const char* kTeam =
    "name: \"reds\" field: \"field\" domain_id: 7\ndds_profile: \"dds.xml\" host_profile: "
    "\"dds.xml\"\n";

// A folder with everything that a robot and a match name.
class RobotFile : public testing::Test {
 protected:
  RobotFile() {
    for (const char* name : {"field", "eye", "dds.xml"}) std::ignore = folder_.write(name, "");
    std::ignore = folder_.write("team", kTeam);
  }

  [[nodiscard]] std::string complaint_about_robot(const std::string& text) const {
    const auto path = folder_.write("robot", text);
    return complaint_of([&] { std::ignore = load_robot(path); });
  }

  [[nodiscard]] std::string complaint_about_match(const std::string& text) const {
    const auto path = folder_.write("match", text);
    return complaint_of([&] { std::ignore = load_match(path); });
  }

  [[nodiscard]] std::string place(const char* file, const char* line) const {
    return (folder_.path() / file).string() + line;
  }

  TemporaryFolder folder_;
};

TEST_F(RobotFile, ComesWithItsTeamAndAbsolutePaths) {
  const auto path = folder_.write(
      "robot", "id: 3 team: \"team\" camera: \"./eye\" strength: 30 start_side: OPPONENT_HALF");

  const RobotSettings robot = load_robot(path);

  EXPECT_EQ(robot.id, 3);
  EXPECT_EQ(robot.strength, 30);
  EXPECT_EQ(robot.start_side, StartSide::kOpponentHalf);
  EXPECT_EQ(robot.camera, folder_.path() / "eye");
  EXPECT_EQ(robot.team.name, "reds");
  EXPECT_EQ(robot.team.domain_id, 7U);
  EXPECT_EQ(robot.team.field, folder_.path() / "field");
  EXPECT_EQ(robot.team.host_profile, folder_.path() / "dds.xml");
}

TEST_F(RobotFile, ComesWithWhatTheTeamsWear) {
  (void)folder_.write("team", std::string(kTeam) + "shirt: CYAN opponent_shirt: MAGENTA");
  const auto path = folder_.write("robot", "id: 3 team: \"team\" camera: \"eye\" strength: 1");

  EXPECT_EQ(load_robot(path).team.shirts,
            (vision::TeamShirts{vision::ColourClass::kCyan, vision::ColourClass::kMagenta}));
}

TEST_F(RobotFile, OfTwoTeamsInOneColourIsRefused) {
  (void)folder_.write("team", std::string(kTeam) + "shirt: CYAN opponent_shirt: CYAN");

  EXPECT_EQ(complaint_about_robot("id: 3 team: \"team\" camera: \"eye\" strength: 1"),
            place("team", ":3:13: key 'opponent_shirt': found CYAN, the own colour, expected ") +
                "another than shirt");
}

TEST_F(RobotFile, OfARobotThatItsTeamLacksIsRefused) {
  (void)folder_.write("team", std::string(kTeam) + "robot: [1, 2, 5]");

  EXPECT_EQ(complaint_about_robot("id: 3 team: \"team\" camera: \"eye\" strength: 1"),
            place("robot", ":1:1: key 'id': found 3, expected one of the robots that ") +
                place("team", " lists: 1, 2, 5"));
  EXPECT_EQ(complaint_about_robot("id: 5 team: \"team\" camera: \"eye\" strength: 1"), "");
}

TEST_F(RobotFile, WithIdZeroIsRefused) {
  EXPECT_EQ(complaint_about_robot("id: 0 team: \"team\" camera: \"eye\" strength: 1"),
            place("robot", ":1:1: key 'id': found 0, expected a whole number from 1 to 16"));
}

TEST_F(RobotFile, WithoutStrengthIsRefused) {
  EXPECT_EQ(complaint_about_robot("id: 1 team: \"team\" camera: \"eye\""),
            place("robot",
                  ":1:1: key 'strength': found nothing, expected a whole number from 1 to 65535"));
}

TEST_F(RobotFile, NamesTheCameraThatIsNotThere) {
  EXPECT_EQ(complaint_about_robot("id: 1 team: \"team\" strength: 1\n camera: \"ear\""),
            place("robot", ":2:2: key 'camera': found no file ") + place("ear", "") +
                ", expected the path of a file, relative to this one");
}

TEST_F(RobotFile, PassesOnWhatIsWrongWithItsTeam) {
  std::ignore = folder_.write("team", std::string(kTeam) + "\tcolour: \"red\"");

  EXPECT_THAT(complaint_about_robot("id: 1 team: \"team\" camera: \"eye\" strength: 1"),
              testing::StartsWith(
                  place("team", ":3:9: key 'colour': found an unknown key, expected one of")));
}

TEST_F(RobotFile, MatchKeepsTheOrderOfItsRobots) {
  const auto path =
      folder_.write("match", "field: \"field\" camera: \"eye\" robot: [5, 1] seed: 9");

  const MatchSettings match = load_match(path);

  EXPECT_EQ(match.robots, (std::vector<RobotId>{5, 1}));
  EXPECT_EQ(match.seed, 9U);
  EXPECT_EQ(match.opponents, 5U);
}

TEST_F(RobotFile, MatchMayNameATeam) {
  const auto path =
      folder_.write("match", "field: \"field\" camera: \"eye\" robot: 1 team: \"team\"");

  EXPECT_EQ(load_match(path).team.value().name, "reds");
}

TEST_F(RobotFile, MatchWithARobotTwiceIsRefused) {
  EXPECT_EQ(complaint_about_match("field: \"field\" camera: \"eye\"\nrobot: 4\nrobot: 4"),
            place("match", ":3:1: key 'robot[1]': found 4 again, expected each robot once"));
}

TEST_F(RobotFile, MatchWithARobotThatCannotBeIsRefused) {
  EXPECT_EQ(complaint_about_match("field: \"field\" camera: \"eye\"\nrobot: [4, 17]"),
            place("match", ":2:1: key 'robot[1]': found 17, expected a whole number from 1 to 16"));
}

TEST_F(RobotFile, MatchWithoutRobotsIsRefused) {
  EXPECT_EQ(complaint_about_match("field: \"field\" camera: \"eye\""),
            place("match",
                  ":1:1: key 'robot': found no robot, expected the id of at least one "
                  "robot"));
}

}  // namespace
}  // namespace teamsight::settings
