// tests/monitor/viewer/viewer_server_test.cpp: the web server against viewers that may be slow,
// foreign or mad.
#include <algorithm>
#include <chrono>
#include <memory>
#include <string>

#include <gmock/gmock.h>

#include "monitor/web_server.hpp"
#include "tests/monitor/watcher.hpp"
#include "tests/support/process.hpp"

namespace teamsight::monitor {
namespace {

using test::Watcher;
using ::testing::HasSubstr;

constexpr auto kBound = std::chrono::seconds(10);
constexpr std::size_t kHeader = 13;  // bytes before each payload

WebServerSettings viewer_settings() {
  WebServerSettings settings;
  settings.port = 0;
  settings.name = "teamsight demo";
  settings.token = "secret";
  return settings;
}

/// A viewer that has heard the greeting and which channels there are.
class Viewer : public Watcher {
 public:
  explicit Viewer(const WebServer& server,
                  const std::string& origin = {},
                  const std::string& target = "/",
                  const std::string& protocol = "foxglove.websocket.v1")
      : Watcher(test::host_of(server.url()), origin, target, protocol),
        greeting(next()),
        channels(next()) {}

  std::string greeting;
  std::string channels;
};

/// Subscribes to channel 0 as number 5, and returns once the server knows.
void subscribe(const WebServer& server, Viewer& viewer) {
  viewer.send(R"({"op": "subscribe", "subscriptions": [{"id": 5, "channelId": 0}]})");
  ASSERT_TRUE(test::wait_until([&]() { return server.is_wanted(0); }, kBound));
}

/// A server with one channel.
class ViewerServer : public ::testing::Test {
 protected:
  void start(WebServerSettings settings = viewer_settings()) {
    server_ = std::make_unique<WebServer>(std::move(settings));
    ASSERT_EQ(server_->add_channel({"topic", "protobuf", {"x.A", "protobuf", "schema"}}), 0U);
  }

  std::unique_ptr<WebServer> server_;
};

TEST_F(ViewerServer, TellsOfChannelsAndSendsOnlyWhatIsSubscribedTo) {
  start();
  Viewer viewer(*server_);
  EXPECT_THAT(viewer.greeting, HasSubstr("teamsight demo"));
  EXPECT_THAT(viewer.channels, HasSubstr("\"topic\":\"topic\""));
  EXPECT_FALSE(server_->is_wanted(0));
  server_->send(0, 1, "before anybody asked");

  subscribe(*server_, viewer);
  server_->add_channel({"later", "protobuf", {"x.B", "protobuf", "schema"}});
  server_->send(1, 2, "of a channel that nobody wants");
  server_->send(0, 3, "payload");

  EXPECT_THAT(viewer.next(), HasSubstr("\"topic\":\"later\""));
  EXPECT_EQ(viewer.next(), std::string("\x01\x05\0\0\0\x03\0\0\0\0\0\0\0", kHeader) + "payload");
  viewer.send(R"({"op": "unsubscribe", "subscriptionIds": [5]})");
  EXPECT_TRUE(test::wait_until([&]() { return !server_->is_wanted(0); }, kBound));
}

TEST_F(ViewerServer, IsUnwantedAgainOnceAViewerIsGone) {
  start();
  {
    Viewer viewer(*server_);
    subscribe(*server_, viewer);
    EXPECT_EQ(server_->counters().viewers, 1U);
  }
  EXPECT_TRUE(test::wait_until([&]() { return !server_->is_wanted(0); }, kBound));
  EXPECT_TRUE(test::wait_until([&]() { return server_->counters().viewers == 0U; }, kBound));
}

TEST_F(ViewerServer, RefusesAForeignPageUnlessItBringsTheToken) {
  start();

  const Watcher foreign(
      test::host_of(server_->url()), "https://app.example", "/", "foxglove.sdk.v1");
  const Watcher wrong(
      test::host_of(server_->url()), "https://app.example", "/?token=no", "foxglove.sdk.v1");
  const Viewer known(*server_, "https://app.example", "/?token=secret", "foxglove.sdk.v1");

  EXPECT_TRUE(foreign.is_refused());
  EXPECT_TRUE(wrong.is_refused());
  EXPECT_THAT(known.greeting, HasSubstr("serverInfo"));
}

TEST_F(ViewerServer, AsksForTheTokenWherePagesNeedOneToo) {
  WebServerSettings settings = viewer_settings();
  settings.watch_token = "secret";
  start(std::move(settings));

  Viewer without(*server_);
  const Viewer with(*server_, "", "/?token=secret");

  EXPECT_EQ(without.greeting, "");
  EXPECT_EQ(without.close_code(), kTokenNeeded);
  EXPECT_THAT(with.greeting, HasSubstr("serverInfo"));
}

TEST_F(ViewerServer, AnswersGarbageAndClosesWhatNoViewerSends) {
  start();
  Viewer odd(*server_);
  Viewer binary(*server_);
  Viewer huge(*server_);
  Viewer babbler(*server_);
  Viewer bystander(*server_);

  odd.send("\x01 no JSON");
  binary.send_binary("bytes");
  huge.send(std::string(100'000, '['));
  for (int i = 0; i < 300; ++i) babbler.send("{}");

  EXPECT_THAT(odd.next(), HasSubstr("only takes subscribe"));
  EXPECT_EQ(binary.next(), "");
  EXPECT_EQ(huge.next(), "");
  EXPECT_TRUE(test::wait_until([&]() { return server_->counters().misbehaved == 3U; }, kBound));
  EXPECT_TRUE(test::wait_until([&]() { return server_->counters().viewers == 2U; }, kBound));
  subscribe(*server_, bystander);
  server_->send(0, 3, "payload");
  EXPECT_THAT(bystander.next(), HasSubstr("payload"));
}

TEST_F(ViewerServer, DropsOldMessagesOfASlowViewerAndSaysSo) {
  WebServerSettings settings = viewer_settings();
  settings.max_queued_viewer_bytes = 200'000;
  start(std::move(settings));
  Viewer slow(*server_);
  subscribe(*server_, slow);
  const std::string payload(100'000, '.');

  const auto has_dropped = [&]() {
    server_->send(0, 1, payload);
    return server_->counters().viewer_dropped > 0U;
  };
  ASSERT_TRUE(test::wait_until(has_dropped, kBound));
  server_->send(0, 2, "the newest");

  bool is_told = false;
  bool has_newest = false;
  while (!is_told || !has_newest) {
    const std::string message = slow.next();
    ASSERT_NE(message, "") << "closed";
    is_told = is_told || message.find("did not take them in time") != std::string::npos;
    has_newest = has_newest || message.substr(std::min(message.size(), kHeader)) == "the newest";
  }
  EXPECT_EQ(server_->counters().viewers, 1U);
}

}  // namespace
}  // namespace teamsight::monitor
