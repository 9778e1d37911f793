// monitor/web_server.cpp: see monitor/web_server.hpp. The only file that compiles Boost.Beast.
#include "monitor/web_server.hpp"

#include <chrono>
#include <cstdlib>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include "geometry/expect.hpp"
#include "monitor/live_client.hpp"
#include "monitor/secret.hpp"
#include "monitor/viewer/client.hpp"

namespace teamsight::monitor {
namespace {

constexpr auto kRequestTimeout = std::chrono::seconds(10);
constexpr auto kAcceptPause = std::chrono::milliseconds(200);
constexpr std::uint32_t kMaxHeaderBytes = 8192;
constexpr std::uint64_t kMaxBodyBytes = 1024;

using Request = http::request<http::string_body>;
using Response = http::response<http::string_body>;

std::string_view view_of(beast::string_view text) {
  return {text.data(), text.size()};
}

Response plain(const Request& request, http::status status, std::string text) {
  Response response{status, request.version()};
  response.set(http::field::content_type, "text/plain; charset=utf-8");
  response.body() = std::move(text);
  return response;
}

bool is_live(std::string_view target) {
  return target.substr(0, target.find('?')) == "/live";
}

/// What stands behind "?token="; empty: nothing.
std::string_view token_in(std::string_view target) {
  constexpr std::string_view kKey = "?token=";
  const auto found = target.find(kKey);
  return found == std::string_view::npos ? std::string_view() : target.substr(found + kKey.size());
}

bool may_watch(std::string_view target, const WebServerSettings& settings) {
  return settings.watch_token.empty() || is_same_secret(token_in(target), settings.watch_token);
}

/// Whether a viewer brings the token: it may then come from another site's page, as that could not
/// know it.
bool has_token(std::string_view target, const WebServerSettings& settings) {
  return !settings.token.empty() && is_same_secret(token_in(target), settings.token);
}

Response answer_to(const Request& request, const WebServerSettings& settings) {
  if (request.method() != http::verb::get && request.method() != http::verb::head) {
    return plain(request, http::status::method_not_allowed, "only GET\n");
  }
  const std::string_view target = view_of(request.target());
  const auto found = settings.files.find(target.substr(0, target.find('?')));
  if (found == settings.files.end())
    return plain(request, http::status::not_found, "no such page\n");
  if (found->second.is_private && !may_watch(target, settings)) {
    return plain(request, http::status::unauthorized, "the station's token is needed\n");
  }
  Response response{http::status::ok, request.version()};
  response.set(http::field::content_type, found->second.content_type);
  response.body() = found->second.body;
  return response;
}

/// Headers that every answer carries; the length is that of a GET, whatever was asked.
void complete(Response& response, const Request& request) {
  response.set(http::field::cache_control, "no-cache");
  response.set("X-Content-Type-Options", "nosniff");
  response.set("Content-Security-Policy",
               "default-src 'self'; img-src 'self' data: blob:; frame-ancestors 'none'");
  response.keep_alive(request.keep_alive());
  response.content_length(response.body().size());
  if (request.method() == http::verb::head) response.body().clear();
}

/// One HTTP connection, until it turns into a WebSocket.
class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(Hub& hub, Tcp::socket socket) : hub_(hub), stream_(std::move(socket)) {
    ++hub_.connections;
  }

  ~HttpConnection() { --hub_.connections; }

  HttpConnection(const HttpConnection&) = delete;
  HttpConnection& operator=(const HttpConnection&) = delete;

  void read_next() {
    parser_.emplace();
    parser_->header_limit(kMaxHeaderBytes);
    parser_->body_limit(kMaxBodyBytes);
    stream_.expires_after(kRequestTimeout);
    http::async_read(stream_,
                     buffer_,
                     *parser_,
                     [self = shared_from_this()](ErrorCode error, std::size_t /*bytes*/) {
                       if (!error) self->handle(self->parser_->release());
                     });
  }

 private:
  void handle(const Request& request) {
    const std::string_view target = view_of(request.target());
    const bool is_upgrade = websocket::is_upgrade(request);
    const bool is_viewer =
        is_upgrade && !viewer_protocol(ViewerClient::offered_by(request)).empty();
    const bool is_own =
        is_own_page(view_of(request[http::field::host]), view_of(request[http::field::origin]));
    if (!is_own && !(is_viewer && has_token(target, hub_.settings))) {
      ++hub_.counts.refused;
      respond(request, plain(request, http::status::forbidden, "foreign page\n"));
    } else if (is_viewer) {
      std::make_shared<ViewerClient>(hub_, std::move(stream_))
          ->start(request, !may_watch(target, hub_.settings));
    } else if (!is_upgrade) {
      respond(request, answer_to(request, hub_.settings));
    } else if (!is_live(target)) {
      respond(request, plain(request, http::status::not_found, "WebSocket is under /live\n"));
    } else {
      const auto client = std::make_shared<LiveClient>(hub_, std::move(stream_));
      if (!may_watch(target, hub_.settings)) client->refuse();
      client->start(request);
    }
  }

  void respond(const Request& request, Response response) {
    complete(response, request);
    response_ = std::move(response);
    stream_.expires_after(kRequestTimeout);
    // content_length is that of a GET, so a HEAD must not send its empty body.
    serializer_.emplace(response_);
    http::async_write(
        stream_, *serializer_, [self = shared_from_this()](ErrorCode error, std::size_t /*bytes*/) {
          if (error || !self->response_.keep_alive()) {
            ErrorCode ignored;
            self->stream_.socket().shutdown(Tcp::socket::shutdown_send, ignored);
          } else {
            self->read_next();
          }
        });
  }

  Hub& hub_;
  beast::tcp_stream stream_;
  beast::flat_static_buffer<2 * kMaxHeaderBytes> buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
  Response response_;
  std::optional<http::response_serializer<http::string_body>> serializer_;
};

Tcp::endpoint endpoint_of(const WebServerSettings& settings) {
  ErrorCode error;
  const auto address = asio::ip::make_address(settings.bind, error);
  if (error) {
    throw WebServerError("--bind: \"" + settings.bind +
                         "\" is not an IP address, expected one of this computer's");
  }
  return {address, settings.port};
}

}  // namespace

struct WebServer::Impl {
  explicit Impl(WebServerSettings settings) { hub.settings = std::move(settings); }

  void listen() {
    const Tcp::endpoint wanted = endpoint_of(hub.settings);
    ErrorCode error;
    acceptor.open(wanted.protocol(), error);
    if (!error) acceptor.set_option(asio::socket_base::reuse_address(true), error);
    if (!error) acceptor.bind(wanted, error);
    if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
    if (error == asio::error::address_in_use) {
      throw WebServerError("port " + std::to_string(wanted.port()) + " is in use on " +
                           hub.settings.bind + ", choose another with --port");
    }
    if (error) {
      throw WebServerError("cannot listen on " + hub.settings.bind + " port " +
                           std::to_string(wanted.port()) + ": " + error.message());
    }
    const Tcp::endpoint endpoint = acceptor.local_endpoint();
    const std::string address = endpoint.address().to_string();
    url = "http://" + (endpoint.address().is_v6() ? "[" + address + "]" : address) + ":" +
          std::to_string(endpoint.port()) + "/";
  }

  void accept_next() {
    acceptor.async_accept([this](ErrorCode error, Tcp::socket socket) {
      if (error == asio::error::operation_aborted) return;
      if (error) {
        accept_later();
        return;
      }
      greet(std::move(socket));
      accept_next();
    });
  }

  // Out of descriptors, say: not a reason to spin.
  void accept_later() {
    pause.expires_after(kAcceptPause);
    pause.async_wait([this](ErrorCode stopped) {
      if (!stopped) accept_next();
    });
  }

  // A handler that throws is a mistake of ours: the supervisor starts the station anew.
  void run() noexcept {
    try {
      io.run();
    } catch (...) {
      std::abort();
    }
  }

  void greet(Tcp::socket socket) {
    if (hub.connections >= hub.settings.max_clients) {
      ++hub.counts.refused;
      return;  // closes it
    }
    ErrorCode ignored;
    socket.set_option(Tcp::no_delay(true),
                      ignored);  // or a small message waits for the last one's ack
    std::make_shared<HttpConnection>(hub, std::move(socket))->read_next();
  }

  void spread(Broadcast broadcast) {
    hub.newest_state = std::make_shared<const std::string>(std::move(broadcast.state));
    Text events;
    if (!broadcast.events.empty()) {
      events = std::make_shared<const std::string>(std::move(broadcast.events));
      hub.past_events.push_back(events);
      if (hub.past_events.size() > hub.settings.remembered_events) hub.past_events.pop_front();
    }
    Text extra;
    if (!broadcast.extra.empty()) {
      extra = std::make_shared<const std::string>(std::move(broadcast.extra));
    }
    const std::set<LiveClient*> clients = hub.clients;  // a client that is dropped leaves the set
    for (LiveClient* client : clients) client->push(events, extra);
  }

  void tell(std::uint64_t id, std::string message) const {
    const auto text = std::make_shared<const std::string>(std::move(message));
    const std::set<LiveClient*> clients = hub.clients;
    for (LiveClient* client : clients) {
      if (client->id() == id) client->push(nullptr, text);
    }
  }

  void add_channel(recording::Channel channel) {
    const std::string text = viewer_advertisement(hub.channels.size(), {channel});
    hub.channels.push_back(std::move(channel));
    const std::set<ViewerClient*> viewers = hub.viewers;
    for (ViewerClient* viewer : viewers) viewer->say(text);
  }

  void send(recording::ChannelId channel, std::int64_t log_ns, std::string payload) const {
    const auto text = std::make_shared<const std::string>(std::move(payload));
    const std::set<ViewerClient*> viewers = hub.viewers;
    for (ViewerClient* viewer : viewers) viewer->push(channel, log_ns, text);
  }

  Hub hub;
  std::size_t channel_count{0};  // on the caller's thread
  std::string url;
  asio::io_context io{1};
  Tcp::acceptor acceptor{io};
  asio::steady_timer pause{io};
  std::thread thread;
};

WebServer::WebServer(WebServerSettings settings)
    : impl_(std::make_unique<Impl>(std::move(settings))) {
  impl_->listen();
  impl_->accept_next();
  impl_->thread = std::thread([this]() noexcept { impl_->run(); });
}

WebServer::~WebServer() {
  impl_->io.stop();
  impl_->thread.join();
}

std::string WebServer::url() const {
  return impl_->url;
}

void WebServer::publish(Broadcast broadcast) {
  asio::post(impl_->io,
             [this, moved = std::move(broadcast)]() mutable { impl_->spread(std::move(moved)); });
}

std::vector<ClientMessage> WebServer::take_messages() {
  return impl_->hub.mailbox.take();
}

int WebServer::event_fd() const noexcept {
  return impl_->hub.mailbox.event_fd();
}

void WebServer::tell(std::uint64_t client, std::string message) {
  asio::post(impl_->io, [this, client, moved = std::move(message)]() mutable {
    impl_->tell(client, std::move(moved));
  });
}

recording::ChannelId WebServer::add_channel(recording::Channel channel) {
  TEAMSIGHT_EXPECT(impl_->channel_count < kMaxChannels);
  asio::post(impl_->io, [this, moved = std::move(channel)]() mutable {
    impl_->add_channel(std::move(moved));
  });
  return impl_->channel_count++;
}

bool WebServer::is_wanted(recording::ChannelId channel) const {
  return impl_->hub.wanted.at(channel) != 0;
}

void WebServer::send(recording::ChannelId channel, std::int64_t log_ns, std::string payload) {
  asio::post(impl_->io, [this, channel, log_ns, moved = std::move(payload)]() mutable {
    impl_->send(channel, log_ns, std::move(moved));
  });
}

WebServerCounters WebServer::counters() const {
  const Counts& counts = impl_->hub.counts;
  return {counts.accepted,
          counts.refused,
          counts.overrun,
          counts.misbehaved,
          counts.clients,
          counts.viewers,
          counts.viewer_dropped};
}

}  // namespace teamsight::monitor
