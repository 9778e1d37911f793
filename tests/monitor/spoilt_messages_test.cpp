// tests/monitor/spoilt_messages_test.cpp: whatever the box, a page or a viewer says, it is taken
// as a rule allows or refused with a reason.
#include <chrono>
#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "bus/fault.hpp"
#include "monitor.pb.h"
#include "monitor/order.hpp"
#include "monitor/referee/box_protocol.hpp"
#include "monitor/referee/game_book.hpp"
#include "monitor/viewer/protocol.hpp"
#include "tests/support/property.hpp"
#include "tests/support/spoilt.hpp"

namespace teamsight::monitor {
namespace {

using testing_support::holds_for_all;
using testing_support::spoilt_at_random;

constexpr int kCases = 3000;
const std::string kToken = "0123456789abcdef";

std::string box_stream() {
  using namespace std::string_literals;
  return R"({"command": "WELCOME", "targetTeam": "224.16.32.63"})"s + '\0' +
         R"({"command":"KICKOFF","targetTeam":"224.16.32.75","robotID":-1})" + '\0' +
         R"({"command": " START ", "targetTeam": ""})" + '\0' +
         R"({"command": "SUBSTITUTION", "targetTeam": "224.16.32.63", "robotID": 3})" + '\0';
}

/// The messages of a stream that comes in pieces of at most `most` bytes.
std::vector<std::string> messages_of(const std::string& stream, std::size_t most) {
  std::vector<std::string> messages;
  NulFramer framer;
  for (std::size_t at = 0; at < stream.size(); at += most) {
    framer.take(stream.substr(at, most), [&](std::string_view one) { messages.emplace_back(one); });
  }
  return messages;
}

TEST(SpoiltBoxMessage, IsACommandOrRefusedWithAReason) {
  int refused = 0;

  holds_for_all(
      41,
      [&] {
        const std::string stream = spoilt_at_random(box_stream());
        const auto pieces = messages_of(stream, static_cast<std::size_t>(*rc::gen::inRange(1, 60)));
        RC_ASSERT(pieces == messages_of(stream, stream.size()));
        GameBook book("224.16.32.63");
        for (const std::string& message : pieces) {
          const auto command = parse_box_command(message);
          if (!command) {
            ++refused;
            RC_ASSERT(!command.error().empty());
            continue;
          }
          RC_ASSERT(!command->name.empty() && command->name.size() <= 64);
          RC_ASSERT(!book.apply(*command, HostTime{std::chrono::seconds(1)}).empty());
        }
        bus::GameState game = book.state(HostTime{std::chrono::seconds(2)});
        game.id = {kNobody, 1, 1};
        game.stamp = PeerTime{std::chrono::seconds(1)};
        RC_ASSERT(!bus::fault_of(game));
      },
      kCases);

  EXPECT_GT(refused, kCases / 10);
}

/// One order of each kind.
std::vector<v1::MonitorRequest> orders() {
  std::vector<v1::MonitorRequest> all(8);
  all[0].mutable_relocate()->set_robot_id(3);
  all[0].mutable_relocate()->set_x_m(2.5);
  all[1].mutable_mute()->set_robot_id(2);
  all[2].mutable_ball_hint()->set_x_m(1.0);
  all[3].mutable_line_points()->set_robot_id(1);
  all[3].mutable_line_points()->set_duration_ms(500.0);
  all[4].mutable_thumbnail()->set_robot_id(1);
  all[4].mutable_thumbnail()->set_duration_ms(500.0);
  all[5].mutable_referee()->set_command("KICKOFF");
  all[5].mutable_referee()->set_side(1);
  all[6].mutable_bookmark()->set_text("here");
  all[7].mutable_without()->set_robot_id(4);
  all[7].mutable_without()->set_duration_ms(500.0);
  for (v1::MonitorRequest& one : all) one.set_token(kToken);
  return all;
}

bool has_token(const std::string& bytes) {
  v1::MonitorRequest request;
  return request.ParseFromString(bytes) && request.token() == kToken;
}

/// An order that may be sent: nothing in it that the bus would refuse.
bool is_fit(const Order& order) {
  const auto* robot = std::get_if<RobotOrder>(&order);
  if (robot == nullptr) return true;
  bus::Command command = robot->command;
  command.id = {kNobody, 1, 1};
  command.command = 1;
  return !bus::fault_of(command);
}

TEST(SpoiltRequest, IsAnOrderThatMayBeSentOrRefusedWithAReason) {
  int refused = 0;

  holds_for_all(
      42,
      [&] {
        const auto request = *rc::gen::elementOf(orders());
        const std::string bytes = spoilt_at_random(request.SerializeAsString());
        const auto order = parse_order(bytes, kToken);
        if (!order) {
          ++refused;
          RC_ASSERT(!order.error().empty());
          return;
        }
        RC_ASSERT(has_token(bytes));
        RC_ASSERT(is_fit(*order));
      },
      kCases);

  EXPECT_GT(refused, kCases / 10);
  EXPECT_LT(refused, kCases);
}

TEST(SpoiltViewerText, ChangesWhatAViewerGetsByTheRulesOnly) {
  constexpr std::size_t kChannels = 5;
  const std::string good =
      R"({"op": "subscribe", "subscriptions": [{"id": 1, "channelId": 0}, {"id": 2, "channelId": 4}]})";
  int answered = 0;

  holds_for_all(
      43,
      [&] {
        Subscriptions mine;
        static_cast<void>(mine.hear(good, kChannels));
        const std::string answer = mine.hear(spoilt_at_random(good), kChannels);
        for (const auto& [id, channel] : mine.all()) RC_ASSERT(channel < kChannels);
        RC_ASSERT(mine.all().size() >= 2U);
        if (answer.empty()) return;
        ++answered;
        RC_ASSERT(nlohmann::json::parse(answer)["op"] == "status");
      },
      kCases);

  EXPECT_GT(answered, kCases / 2);
}

}  // namespace
}  // namespace teamsight::monitor
