// tests/monitor/web_server_test.cpp: the server against a client that may be slow, foreign or mad.
#include "monitor/web_server.hpp"

#include <chrono>
#include <string>
#include <vector>

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <gmock/gmock.h>

#include "tests/monitor/watcher.hpp"
#include "tests/support/process.hpp"

namespace teamsight::monitor {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Tcp = asio::ip::tcp;
using test::Watcher;
using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr auto kBound = std::chrono::seconds(10);

WebServerSettings test_settings() {
  WebServerSettings settings;
  settings.port = 0;
  settings.greeting = "hello ";
  settings.files["/"] = {"text/html; charset=utf-8", "<html></html>"};
  settings.files["/assets/page.js"] = {"text/javascript; charset=utf-8", "run();"};
  return settings;
}

std::string host_of(const WebServer& server) {
  return test::host_of(server.url());
}

Tcp::socket connect_to(asio::io_context& io, const WebServer& server) {
  return test::connect_to(io, host_of(server));
}

using Request = http::request<http::string_body>;
using Response = http::response<http::string_body>;

Response ask(const WebServer& server, Request request) {
  asio::io_context io;
  Tcp::socket socket = connect_to(io, server);
  if (request[http::field::host].empty()) request.set(http::field::host, host_of(server));
  request.prepare_payload();
  http::write(socket, request);
  beast::flat_buffer buffer;
  http::response_parser<http::string_body> parser;
  parser.skip(request.method() == http::verb::head);
  http::read(socket, buffer, parser);
  return parser.release();
}

Response get(const WebServer& server, const std::string& target) {
  return ask(server, {http::verb::get, target, 11});
}

TEST(WebServer, ServesThePagesFilesWithTheirType) {
  const WebServer server(test_settings());

  const Response index = get(server, "/");
  const Response script = get(server, "/assets/page.js?v=1");

  EXPECT_EQ(index.result_int(), 200U);
  EXPECT_EQ(index.body(), "<html></html>");
  EXPECT_EQ(script[http::field::content_type], "text/javascript; charset=utf-8");
  EXPECT_EQ(script.body(), "run();");
}

TEST(WebServer, ServesNothingElse) {
  const WebServer server(test_settings());

  for (const char* target : {"/../../../../etc/passwd",
                             "/assets/../../etc/passwd",
                             "/etc/passwd",
                             "/%2e%2e/%2e%2e/etc/passwd",
                             "//etc/passwd",
                             "/assets",
                             "/live"}) {
    EXPECT_EQ(get(server, target).result_int(), 404U) << target;
  }
}

TEST(WebServer, AnswersHeadWithoutABodyAndRefusesOtherMethods) {
  const WebServer server(test_settings());

  const Response head = ask(server, {http::verb::head, "/", 11});
  const Response post = ask(server, {http::verb::post, "/", 11, "some text"});

  EXPECT_EQ(head.result_int(), 200U);
  EXPECT_EQ(head[http::field::content_length], "13");
  EXPECT_EQ(post.result_int(), 405U);
}

TEST(WebServer, GreetsAndPushesEveryUpdate) {
  WebServer server(test_settings());
  server.publish({"[state 1]", "[event 1]", ""});
  Watcher watcher(host_of(server), server.url().substr(0, server.url().size() - 1));

  const std::string first = watcher.next();
  server.publish({"[state 2]", "", ""});
  const std::string second = watcher.next();

  EXPECT_EQ(first, "hello [state 1][event 1]");
  EXPECT_EQ(second, "[state 2]");
  EXPECT_EQ(server.counters().clients, 1U);
}

TEST(WebServer, RefusesAPageOfAnotherOrigin) {
  const WebServer server(test_settings());

  const Watcher foreign(host_of(server), "http://evil.example");
  Request rebound(http::verb::get, "/", 11);
  rebound.set(http::field::host, "evil.example:8080");

  EXPECT_TRUE(foreign.is_refused());
  EXPECT_EQ(ask(server, rebound).result_int(), 403U);
  EXPECT_EQ(server.counters().refused, 2U);
}

TEST(WebServer, ClosesWhoeverSendsWhatNoPageSends) {
  WebServer server(test_settings());
  server.publish({"[state]", "", ""});
  Watcher garbage(host_of(server));
  Watcher huge(host_of(server));
  ASSERT_EQ(garbage.next(), "hello [state]");
  ASSERT_EQ(huge.next(), "hello [state]");

  garbage.send("\x01\x02garbage");
  huge.send(std::string(100'000, 'x'));

  EXPECT_EQ(garbage.next(), "");
  EXPECT_EQ(garbage.close_code(), websocket::close_code::policy_error);
  EXPECT_EQ(huge.next(), "");
  EXPECT_TRUE(test::wait_until([&]() { return server.counters().misbehaved == 2U; }, kBound));
  EXPECT_TRUE(test::wait_until([&]() { return server.counters().clients == 0U; }, kBound));
  EXPECT_EQ(get(server, "/").result_int(), 200U);
}

TEST(WebServer, HandsOnWhatAPageSaysAndAnswersOnlyThatPage) {
  WebServer server(test_settings());
  server.publish({"[state]", "", ""});
  Watcher one(host_of(server));
  Watcher other(host_of(server));
  ASSERT_EQ(one.next(), "hello [state]");
  ASSERT_EQ(other.next(), "hello [state]");

  one.send_binary("an order");
  std::vector<ClientMessage> messages;
  ASSERT_TRUE(test::wait_until(
      [&]() {
        if (messages.empty()) messages = server.take_messages();
        return !messages.empty();
      },
      kBound));
  EXPECT_EQ(messages[0].bytes, "an order");
  server.tell(messages[0].client, "[answer]");
  server.tell(messages[0].client + 77, "[to nobody]");

  EXPECT_EQ(one.next(), "[state][answer]");
  server.publish({"[state 2]", "", "[picture]"});
  EXPECT_EQ(other.next(), "[state 2][picture]");
  EXPECT_EQ(Watcher(host_of(server)).next(), "hello [state 2]") << "pictures are not remembered";
}

TEST(WebServer, ClosesWhoeverSaysTooMuchInASecond) {
  WebServer server(test_settings());
  server.publish({"[state]", "", ""});
  Watcher babbler(host_of(server));
  ASSERT_EQ(babbler.next(), "hello [state]");

  for (int i = 0; i < 40; ++i) babbler.send_binary("again");

  EXPECT_EQ(babbler.next(), "");
  EXPECT_TRUE(test::wait_until([&]() { return server.counters().misbehaved == 1U; }, kBound));
  EXPECT_LE(server.take_messages().size(), 30U);
}

TEST(WebServer, ShowsNothingWithoutTheTokenWhereOneIsNeeded) {
  WebServerSettings settings = test_settings();
  settings.watch_token = "secret";
  settings.files["/recording.bin"] = {"application/octet-stream", "past", true};
  WebServer server(std::move(settings));
  server.publish({"[state]", "", ""});

  Watcher without(host_of(server));
  Watcher wrong(host_of(server), "", "/live?token=secreT");
  Watcher with(host_of(server), "", "/live?token=secret");

  EXPECT_EQ(without.next(), "");
  EXPECT_EQ(without.close_code(), kTokenNeeded);
  EXPECT_EQ(wrong.next(), "");
  EXPECT_EQ(with.next(), "hello [state]");
  EXPECT_EQ(get(server, "/recording.bin").result_int(), 401U);
  EXPECT_EQ(get(server, "/recording.bin?token=secret").body(), "past");
  EXPECT_EQ(get(server, "/").result_int(), 200U) << "the page itself is no secret";
}

TEST(WebServer, SurvivesBytesThatAreNoHttp) {
  const WebServer server(test_settings());
  asio::io_context io;

  for (const std::string& bytes :
       {std::string(20'000, 'A'),
        std::string("\x16\x03\x01\xff\x00", 5),
        std::string("GET / HTTP/1.1\r\nX: ") + std::string(9'000, 'b')}) {
    Tcp::socket socket = connect_to(io, server);
    beast::error_code ignored;
    asio::write(socket, asio::buffer(bytes), ignored);
    socket.shutdown(Tcp::socket::shutdown_send, ignored);
  }

  EXPECT_EQ(get(server, "/").result_int(), 200U);
}

TEST(WebServer, ASlowClientSkipsStatesButGetsEveryEvent) {
  WebServer server(test_settings());
  server.publish({"[state -1]", "", ""});
  Watcher slow(host_of(server));
  ASSERT_TRUE(test::wait_until([&]() { return server.counters().clients == 1U; }, kBound));
  constexpr int kStates = 1000;
  const std::string padding(50'000, '.');  // 50 MB in all: more than any socket buffer holds
  std::string sent_events;

  for (int i = 0; i < kStates; ++i) {
    const std::string event = i % 10 == 0 ? "<" + std::to_string(i) + ">" : "";
    sent_events += event;
    server.publish({"[state " + std::to_string(i) + "]" + padding, event, ""});
  }
  std::string all;
  int messages = 0;
  const std::string last = "[state " + std::to_string(kStates - 1) + "]";
  while (all.find(last) == std::string::npos) {
    const std::string message = slow.next();
    ASSERT_NE(message, "") << "closed after " << messages << " messages";
    ++messages;
    all += message;
  }
  std::string got_events;
  for (std::size_t at = all.find('<'); at != std::string::npos; at = all.find('<', at + 1)) {
    got_events += all.substr(at, all.find('>', at) - at + 1);
  }

  EXPECT_LT(messages, kStates);
  EXPECT_EQ(got_events, sent_events);
  EXPECT_EQ(server.counters().overrun, 0U);
}

TEST(WebServer, ClosesAClientThatFallsBehindWithEvents) {
  WebServerSettings settings = test_settings();
  settings.max_queued_events = 20;
  WebServer server(std::move(settings));
  server.publish({"[state]", "", ""});
  const Watcher stuck(host_of(server));
  ASSERT_TRUE(test::wait_until([&]() { return server.counters().clients == 1U; }, kBound));
  const std::string padding(200'000, '.');

  // States merge while one is being sent, so no number of them surely fills the socket's buffers.
  const auto is_overrun = [&]() {
    server.publish({padding, "<event>", ""});
    return server.counters().overrun == 1U;
  };

  EXPECT_TRUE(test::wait_until(is_overrun, kBound));
  EXPECT_TRUE(test::wait_until([&]() { return server.counters().clients == 0U; }, kBound));
  EXPECT_EQ(get(server, "/").result_int(), 200U);
}

TEST(WebServer, TellsANewClientThePastEvents) {
  WebServerSettings settings = test_settings();
  settings.remembered_events = 2;
  WebServer server(std::move(settings));
  for (const char* event : {"<1>", "<2>", "<3>"}) server.publish({"[s]", event, ""});

  Watcher late(host_of(server));

  EXPECT_EQ(late.next(), "hello [s]<2><3>");
}

TEST(WebServer, TakesNoMoreConnectionsThanItsBound) {
  WebServerSettings settings = test_settings();
  settings.max_clients = 1;
  WebServer server(std::move(settings));
  server.publish({"[state]", "", ""});
  Watcher first(host_of(server));
  ASSERT_EQ(first.next(), "hello [state]");

  const Watcher second(host_of(server));

  EXPECT_TRUE(second.is_refused());
  EXPECT_TRUE(test::wait_until([&]() { return server.counters().refused == 1U; }, kBound));
}

TEST(WebServer, SaysThatAPortIsInUseAndWhatToDo) {
  const WebServer first(test_settings());
  WebServerSettings settings = test_settings();
  const std::string host = host_of(first);
  settings.port = static_cast<std::uint16_t>(std::stoul(host.substr(host.rfind(':') + 1)));

  try {
    const WebServer second(settings);
    FAIL() << "two servers on one port";
  } catch (const WebServerError& error) {
    EXPECT_THAT(error.what(), StartsWith("port " + std::to_string(settings.port) + " is in use"));
    EXPECT_THAT(error.what(), HasSubstr("choose another with --port"));
  }
}

TEST(WebServer, RefusesAnAddressThatIsNone) {
  WebServerSettings settings = test_settings();
  settings.bind = "everywhere";

  EXPECT_THROW(const WebServer server(settings), WebServerError);
}

}  // namespace
}  // namespace teamsight::monitor
