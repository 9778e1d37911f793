// tests/monitor/referee/referee_test.cpp: the box's messages, the state of the game, our world
// state.
#include <chrono>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "monitor/referee/box_protocol.hpp"
#include "monitor/referee/game_book.hpp"
#include "monitor/referee/world_state.hpp"

namespace teamsight::monitor {
namespace {

using bus::GamePhase;
using bus::SetPiece;
using std::chrono::seconds;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const HostTime kNow{seconds(100)};
const std::string kUs = "224.16.32.63";
const std::string kThem = "224.16.32.74";

std::vector<std::string> framed(NulFramer& framer, const std::vector<std::string>& parts) {
  std::vector<std::string> messages;
  for (const std::string& part : parts) {
    framer.take(part, [&](std::string_view message) { messages.emplace_back(message); });
  }
  return messages;
}

TEST(NulFramer, PutsSplitMessagesTogetherAndTakesGluedOnesApart) {
  using namespace std::string_literals;
  NulFramer framer;

  EXPECT_THAT(framed(framer, {"{\"a\"", ":1}\0{\"b\":2}\0"s, "\0\0c"s, "d\0"s}),
              ElementsAre("{\"a\":1}", "{\"b\":2}", "cd"));
}

TEST(NulFramer, FindsTheSameMessagesWhereverTheStreamIsCut) {
  using namespace std::string_literals;
  const std::string stream = "first\0second\0\0third\0"s;

  for (std::size_t at = 0; at <= stream.size(); ++at) {
    NulFramer framer;
    EXPECT_THAT(framed(framer, {stream.substr(0, at), stream.substr(at)}),
                ElementsAre("first", "second", "third"));
  }
}

TEST(NulFramer, DropsAMessageThatNeverEndsAndGoesOnBehindIt) {
  using namespace std::string_literals;
  NulFramer framer;
  const std::string part(40'000, 'x');

  EXPECT_THAT(framed(framer, {part, part, part, "tail\0good\0"s}), ElementsAre("good"));
  EXPECT_EQ(framer.overlong(), 1U);
}

TEST(BoxCommand, IsReadWithOrWithoutRobotAndBlanks) {
  EXPECT_EQ(parse_box_command(R"({"command":"START","targetTeam":""})"),
            (BoxCommand{"START", "", {}}));
  EXPECT_EQ(parse_box_command(R"({"targetTeam":"224.16.32.63","command":" WELCOME"})"),
            (BoxCommand{"WELCOME", kUs, {}}));
  EXPECT_EQ(parse_box_command(R"({"command":"SUBSTITUTION","targetTeam":"","robotID":3})"),
            (BoxCommand{"SUBSTITUTION", "", 3}));
  EXPECT_EQ(parse_box_command(R"({"command":"STOP","robotID":-1})"), (BoxCommand{"STOP", "", {}}));
}

TEST(BoxCommand, IsRefusedWithTheReasonWhenItIsNone) {
  for (const char* text : {"",
                           "s",
                           "[]",
                           "{}",
                           R"({"command":7})",
                           R"({"command":""})",
                           R"({"command":"START","targetTeam":5})",
                           "{\"command\":\"ST"}) {
    const auto command = parse_box_command(text);
    ASSERT_FALSE(command.has_value()) << text;
    EXPECT_FALSE(command.error().empty());
  }
  EXPECT_FALSE(parse_box_command(R"({"command":")" + std::string(100, 'A') + R"("})").has_value());
  EXPECT_FALSE(parse_box_command(std::string(10'000, '[')).has_value());
}

TEST(GameBook, FollowsAKickoffOfOursIntoPlay) {
  GameBook book(kUs);

  book.apply({"FIRST_HALF", "", {}}, kNow);
  EXPECT_EQ(book.apply({"KICKOFF", kUs, {}}, kNow), "KICKOFF ours");
  EXPECT_EQ(book.state(kNow).phase, GamePhase::kFirstHalf);
  EXPECT_EQ(book.state(kNow).piece, SetPiece::kKickoff);
  EXPECT_TRUE(book.state(kNow).piece_is_ours);
  EXPECT_FALSE(book.state(kNow).running);
  book.apply({"START", "", {}}, kNow);

  const bus::GameState state = book.state(kNow + seconds(2));
  EXPECT_TRUE(state.running);
  EXPECT_EQ(state.piece, SetPiece::kNone);
  EXPECT_EQ(state.command_age, seconds(2));
}

TEST(GameBook, KnowsEveryCommandOfTheBox) {
  for (const char* name : {"START",
                           "STOP",
                           "WELCOME",
                           "RESET",
                           "TESTMODE_ON",
                           "TESTMODE_OFF",
                           "FIRST_HALF",
                           "HALF_TIME",
                           "SECOND_HALF",
                           "FIRST_HALF_OVERTIME",
                           "SECOND_HALF_OVERTIME",
                           "END_PART",
                           "END_GAME",
                           "GAMEOVER",
                           "PARK",
                           "GOAL",
                           "SUBGOAL",
                           "KICKOFF",
                           "FREEKICK",
                           "GOALKICK",
                           "THROWIN",
                           "CORNER",
                           "PENALTY",
                           "DROP_BALL",
                           "YELLOW_CARD",
                           "RED_CARD",
                           "DOUBLE_YELLOW",
                           "REPAIR",
                           "REPAIR_END",
                           "SUBSTITUTION",
                           "IS_ALIVE"}) {
    GameBook book(kUs);
    EXPECT_THAT(book.apply({name, kThem, {}}, kNow), ::testing::Not(HasSubstr("unknown"))) << name;
    EXPECT_FALSE(book.state(kNow).piece_is_ours);
  }
}

TEST(GameBook, CountsGoalsByTargetAndNeverBelowZero) {
  GameBook book(kUs);

  book.apply({"GOAL", kUs, {}}, kNow);
  book.apply({"GOAL", kThem, {}}, kNow);
  book.apply({"GOAL", kThem, {}}, kNow);
  book.apply({"SUBGOAL", kUs, {}}, kNow);
  book.apply({"SUBGOAL", kUs, {}}, kNow);

  EXPECT_EQ(book.state(kNow).goals_own, 0);
  EXPECT_EQ(book.state(kNow).goals_opponent, 2);
}

TEST(GameBook, LearnsItsAddressFromTheWelcome) {
  GameBook book("");
  book.apply({"WELCOME", kUs, {}}, kNow);

  book.apply({"CORNER", kUs, {}}, kNow);

  EXPECT_TRUE(book.state(kNow).piece_is_ours);
}

TEST(GameBook, OfAStationThatKnowsNothingKeepsQuiet) {
  GameBook book(kUs);
  EXPECT_FALSE(book.speaks());

  book.set_connected(false);
  EXPECT_FALSE(book.speaks());

  book.set_connected(true);
  EXPECT_TRUE(book.speaks());
  book.set_connected(false);
  EXPECT_TRUE(book.speaks()) << "that the box is gone is news";
}

/// Two stations' books, each of which hears the other as the robots do.
struct TwoStations {
  GameBook one{kUs};
  GameBook other{kUs};

  static bus::GameState said_by(const GameBook& book, std::uint32_t boot, HostTime now) {
    bus::GameState state = book.state(now);
    state.id = {kNobody, boot, 1};
    return state;
  }

  void exchange(HostTime now) {
    const auto from_one = said_by(one, 1, now);
    const auto from_other = said_by(other, 2, now);
    if (one.speaks()) other.hear(from_one, 2, now);
    if (other.speaks()) one.hear(from_other, 1, now);
  }
};

TEST(GameBook, FollowsTheStationWithTheNewestCommand) {
  TwoStations stations;
  stations.one.apply({"GOAL", kUs, {}}, kNow);
  stations.exchange(kNow);
  EXPECT_EQ(stations.other.state(kNow).goals_own, 1);
  EXPECT_FALSE(stations.other.speaks());

  stations.other.apply({"START", "", {}}, kNow + seconds(5));
  stations.exchange(kNow + seconds(6));

  EXPECT_FALSE(stations.one.speaks());
  EXPECT_TRUE(stations.other.speaks());
  EXPECT_TRUE(stations.one.state(kNow + seconds(6)).running);
  EXPECT_EQ(stations.other.state(kNow).goals_own, 1) << "it went on from what it had followed";
  EXPECT_EQ(stations.one.state(kNow + seconds(8)).command_age, seconds(3));
}

TEST(GameBook, LetsTheStationWithTheBoxDecide) {
  TwoStations stations;
  stations.one.set_connected(true);
  stations.one.apply({"STOP", "", {}}, kNow);
  stations.other.apply({"START", "", {}}, kNow + seconds(5));
  stations.exchange(kNow + seconds(6));

  EXPECT_TRUE(stations.one.speaks());
  EXPECT_FALSE(stations.one.state(kNow).running);
  EXPECT_FALSE(stations.other.speaks());
  EXPECT_FALSE(stations.other.state(kNow).running);
  EXPECT_FALSE(stations.other.state(kNow).box_connected) << "that is the other's connection";
  EXPECT_TRUE(stations.other.other_has_box(kNow + seconds(7)));
  EXPECT_FALSE(stations.other.other_has_box(kNow + seconds(60)));
}

TEST(GameBook, GoesOnWithTheGameOfAStationThatHasDied) {
  TwoStations stations;
  stations.one.set_connected(true);
  stations.one.apply({"GOAL", kUs, {}}, kNow);
  stations.exchange(kNow);

  EXPECT_FALSE(stations.other.take_over(kNow + seconds(3)));
  EXPECT_TRUE(stations.other.take_over(kNow + seconds(4)));

  EXPECT_TRUE(stations.other.speaks());
  EXPECT_EQ(stations.other.state(kNow + seconds(4)).goals_own, 1);
  EXPECT_FALSE(stations.other.take_over(kNow + seconds(5))) << "it is said once";
  stations.exchange(kNow + seconds(6));
  EXPECT_FALSE(stations.other.speaks()) << "the first one is back, and has the box";
}

TEST(GameBook, LeavesOneOfTwoFollowersSpeakingWhenTheirStationHasDied) {
  TwoStations followers;
  bus::GameState told;
  told.id = {kNobody, 9, 1};
  told.running = true;
  followers.one.hear(told, 1, kNow);
  followers.other.hear(told, 2, kNow);

  EXPECT_TRUE(followers.one.take_over(kNow + seconds(5)));
  EXPECT_TRUE(followers.other.take_over(kNow + seconds(5)));
  followers.exchange(kNow + seconds(6));

  EXPECT_NE(followers.one.speaks(), followers.other.speaks());
  EXPECT_TRUE(followers.one.state(kNow + seconds(7)).running);
}

TEST(GameBook, LeavesOneStationSpeakingWhateverTheTimesOfTheirCommands) {
  for (const seconds later : {seconds(0), seconds(3), seconds(70)}) {
    TwoStations stations;  // that meet after both have given commands
    stations.one.apply({"STOP", "", {}}, kNow);
    stations.other.apply({"START", "", {}}, kNow + later);
    stations.exchange(kNow + later + seconds(200));

    EXPECT_NE(stations.one.speaks(), stations.other.speaks()) << later.count();
    const HostTime now = kNow + seconds(300);
    EXPECT_EQ(stations.one.state(now).running, stations.other.state(now).running);
  }
}

TEST(GameBook, ChangesNothingForWhatItDoesNotKnow) {
  GameBook book(kUs);
  book.apply({"START", "", {}}, kNow);

  EXPECT_EQ(book.apply({"DANCE", kUs, {}}, kNow + seconds(1)), "unknown command DANCE");

  EXPECT_TRUE(book.state(kNow).running);
  EXPECT_EQ(book.last_command(), "START");
}

class WorldStateText : public ::testing::Test {
 protected:
  WorldStateText() {
    WorldTeammate mate;
    mate.robot = 2;
    mate.status = PostureStatus::kOk;
    mate.X_FR = {4.0, 1.0, -0.5};  // 4 m towards the opponent, 1 m to the left
    mate.v_FR = {1.0, 0.25};
    world_.teammates = {mate};
    mate.robot = 3;
    mate.status = PostureStatus::kLost;
    world_.teammates.push_back(mate);
    WorldBall ball;
    ball.p_FB = {3.0, -2.0, 0.5};
    ball.existence = 0.75;
    world_.balls = {ball};
    WorldObstacle obstacle;
    obstacle.p_FO = {-1.0, 2.5};
    obstacle.radius = 0.25;
    world_.obstacles = {obstacle};
    state_.id.robot = 2;
    state_.omega = 0.5;
    state_.has_ball = true;
  }

  [[nodiscard]] std::string text() const {
    return world_state(
        {"Team \xC3\xA4", "play", &world_, {&state_}, std::chrono::milliseconds(42)});
  }

  WorldModel world_;
  bus::RobotState state_;
};

TEST_F(WorldStateText, StandsInTheBoxesFrame) {
  const auto json = nlohmann::json::parse(text());

  const auto& robot = json["robots"][0];
  EXPECT_EQ(robot["id"], 2);
  EXPECT_THAT(robot["pose"].get<std::vector<double>>(),
              ElementsAre(-1.0, 4.0, DoubleNear(2.0 * std::numbers::pi - 0.5, 1e-3)));
  EXPECT_THAT(robot["velocity"].get<std::vector<double>>(), ElementsAre(-0.25, 1.0, 0.5));
  EXPECT_EQ(robot["ballEngaged"], 1);
  EXPECT_THAT(json["balls"][0]["position"].get<std::vector<double>>(), ElementsAre(2.0, 3.0, 0.5));
  EXPECT_THAT(json["obstacles"][0]["position"].get<std::vector<double>>(), ElementsAre(-2.5, -1.0));
  EXPECT_EQ(json["ageMs"], 42);
  EXPECT_TRUE(json["ageMs"].is_number_integer());
}

TEST_F(WorldStateText, HasNullForARobotThatIsLostAndOnlyAscii) {
  const auto json = nlohmann::json::parse(text());

  EXPECT_TRUE(json["robots"][1]["pose"][0].is_null());
  EXPECT_THAT(text(), ::testing::Each(::testing::Truly([](char letter) { return letter > 0; })));
  EXPECT_EQ(fault_of_world_state(text()), std::nullopt);
}

TEST_F(WorldStateText, IsNotSentWhenItBreaksTheSchema) {
  const auto good = nlohmann::json::parse(text());
  const auto fault_with = [&](const std::string& key, const nlohmann::json& value) {
    auto changed = good;
    changed[key] = value;
    return fault_of_world_state(changed.dump()).value_or("");
  };

  EXPECT_THAT(fault_with("type", "world"), HasSubstr("type"));
  EXPECT_THAT(fault_with("ageMs", 4.5), HasSubstr("ageMs"));
  EXPECT_THAT(fault_with("teamName", 3), HasSubstr("teamName"));
  EXPECT_THAT(fault_with("balls", {{{"position", "here"}}}), HasSubstr("balls.position"));
  EXPECT_THAT(fault_with("robots", {{{"intention", 1}}}), HasSubstr("robots.intention"));
  EXPECT_THAT(fault_with("obstacles", nullptr), HasSubstr("obstacles"));
  EXPECT_THAT(fault_of_world_state("{").value_or(""), HasSubstr("JSON"));
  EXPECT_THAT(fault_with("balls", nlohmann::json::array()), IsEmpty());
}

}  // namespace
}  // namespace teamsight::monitor
