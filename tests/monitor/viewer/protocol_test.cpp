// tests/monitor/viewer/protocol_test.cpp: what a viewer is told, and what it may say.
#include "monitor/viewer/protocol.hpp"

#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace teamsight::monitor {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;

std::string subscribe(const std::string& list) {
  return R"({"op": "subscribe", "subscriptions": )" + list + "}";
}

TEST(ViewerProtocol, SpeaksTheFirstOfferedNameThatItKnows) {
  EXPECT_EQ(viewer_protocol("foxglove.websocket.v1"), "foxglove.websocket.v1");
  EXPECT_EQ(viewer_protocol("foxglove.sdk.v1"), "foxglove.sdk.v1");
  EXPECT_EQ(viewer_protocol("mqtt,  foxglove.websocket.v1 , foxglove.sdk.v1"),
            "foxglove.websocket.v1");
  EXPECT_EQ(viewer_protocol("foxglove.websocket.v2, ,"), "");
  EXPECT_EQ(viewer_protocol(""), "");
}

TEST(ViewerProtocol, GreetsAlsoWithANameThatIsNoUtf8) {
  const json greeting = json::parse(viewer_greeting("team \xff", "7"));

  EXPECT_EQ(greeting["op"], "serverInfo");
  EXPECT_EQ(greeting["sessionId"], "7");
}

TEST(ViewerProtocol, AdvertisesChannelsWithTheirSchemaInBase64) {
  const recording::Channel one{
      "a", "protobuf", {"x.A", "protobuf", std::string("\x00\xff\x10", 3)}};
  const recording::Channel two{"b", "protobuf", {"x.B", "protobuf", "ab"}};
  const recording::Channel three{"c", "protobuf", {"x.C", "protobuf", "abcd"}};

  const json list = json::parse(viewer_advertisement(5, {one, two, three}))["channels"];

  EXPECT_EQ(list[0]["id"], 5);
  EXPECT_EQ(list[0]["topic"], "a");
  EXPECT_EQ(list[0]["schemaName"], "x.A");
  EXPECT_EQ(list[0]["schema"], "AP8Q");
  EXPECT_EQ(list[1]["id"], 6);
  EXPECT_EQ(list[1]["schema"], "YWI=");
  EXPECT_EQ(list[2]["schema"], "YWJjZA==");
}

TEST(ViewerProtocol, PutsNumberAndTimeBeforeAMessageLeastByteFirst) {
  const ViewerHeader header = viewer_header(0x01020304U, 0x0102030405060708);

  EXPECT_THAT(header, ElementsAre(1, 4, 3, 2, 1, 8, 7, 6, 5, 4, 3, 2, 1));
}

TEST(Subscriptions, FollowWhatAViewerAsksFor) {
  Subscriptions mine;

  EXPECT_EQ(mine.hear(subscribe(R"([{"id": 0, "channelId": 3}, {"id": 9, "channelId": 3}])"), 4),
            "");
  EXPECT_THAT(mine.all(), ElementsAre(Pair(0U, 3U), Pair(9U, 3U)));

  EXPECT_EQ(mine.hear(R"({"op": "unsubscribe", "subscriptionIds": [0]})", 4), "");
  EXPECT_THAT(mine.all(), ElementsAre(Pair(9U, 3U)));
}

TEST(Subscriptions, DoOfAListWhatCanBeDoneAndSayHowMuchCannot) {
  Subscriptions mine;

  const std::string answer = mine.hear(
      subscribe(
          R"([{"id": 1, "channelId": 4}, {"id": -1, "channelId": 0}, {"id": 1.5, "channelId": 0},
                    {"id": 4294967296, "channelId": 0}, {"id": 2, "channelId": 0},
                    {"id": 2, "channelId": 1}, 7, null, {"id": 3}])"),
      4);

  EXPECT_THAT(answer, HasSubstr("8 of \\\"subscribe\\\" refused"));
  EXPECT_EQ(json::parse(answer)["level"], 1);
  EXPECT_THAT(mine.all(), ElementsAre(Pair(2U, 0U)));
  EXPECT_THAT(mine.hear(R"({"op": "unsubscribe", "subscriptionIds": [7, "2", 2]})", 4),
              HasSubstr("2 of"));
  EXPECT_THAT(mine.all(), IsEmpty());
}

TEST(Subscriptions, AreBoundedInNumber) {
  Subscriptions mine;
  json list = json::array();
  for (std::size_t i = 0; i < kMaxSubscriptions + 3; ++i)
    list.push_back({{"id", i}, {"channelId", 0}});

  const std::string answer = mine.hear(subscribe(list.dump()), 1);

  EXPECT_THAT(answer, HasSubstr("3 of"));
  EXPECT_EQ(mine.all().size(), kMaxSubscriptions);
}

TEST(Subscriptions, AnswerWhatIsNoRequestAndChangeNothing) {
  Subscriptions mine;
  ASSERT_EQ(mine.hear(subscribe(R"([{"id": 1, "channelId": 0}])"), 1), "");

  for (const std::string& text : {std::string(),
                                  std::string("{"),
                                  std::string("7"),
                                  std::string("[]"),
                                  std::string("\xff\x00{", 3),
                                  std::string(8000, '['),
                                  std::string(R"({"op": 7})"),
                                  std::string(R"({"op": "advertise", "channels": []})")}) {
    EXPECT_THAT(mine.hear(text, 1), HasSubstr("only takes subscribe and unsubscribe")) << text;
  }

  EXPECT_EQ(mine.hear(R"({"op": "subscribe", "subscriptions": 7})", 1), "");
  EXPECT_EQ(mine.all().size(), 1U);
}

}  // namespace
}  // namespace teamsight::monitor
