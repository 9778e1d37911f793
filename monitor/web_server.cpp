// monitor/web_server.cpp: see monitor/web_server.hpp. The only file that includes Boost.Beast.
#include "monitor/web_server.hpp"

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <deque>
#include <optional>
#include <set>
#include <string_view>
#include <thread>
#include <utility>

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

namespace teamsight::monitor {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Tcp = asio::ip::tcp;
using ErrorCode = beast::error_code;

constexpr auto kRequestTimeout = std::chrono::seconds(10);
constexpr auto kAcceptPause = std::chrono::milliseconds(200);
constexpr std::size_t kMaxMessageBytes = 1024;
constexpr std::uint32_t kMaxHeaderBytes = 8192;
constexpr std::uint64_t kMaxBodyBytes = 1024;

using Text = std::shared_ptr<const std::string>;

struct Counts {
  std::atomic<std::uint64_t> accepted{0};
  std::atomic<std::uint64_t> refused{0};
  std::atomic<std::uint64_t> overrun{0};
  std::atomic<std::uint64_t> misbehaved{0};
  std::atomic<std::uint64_t> clients{0};
};

class LiveClient;

/// What every connection shares; used on the server's thread only, but for the counts.
struct Hub {
  WebServerSettings settings;
  Counts counts;
  Text newest_state;
  std::deque<Text> past_events;
  std::set<LiveClient*> clients;
  std::size_t connections{0};
};

/// One browser that watches.
class LiveClient : public std::enable_shared_from_this<LiveClient> {
 public:
  LiveClient(Hub& hub, beast::tcp_stream stream) : hub_(hub), socket_(std::move(stream)) {
    ++hub_.connections;
  }

  ~LiveClient() { --hub_.connections; }

  LiveClient(const LiveClient&) = delete;
  LiveClient& operator=(const LiveClient&) = delete;

  void start(const http::request<http::string_body>& request) {
    beast::get_lowest_layer(socket_).expires_never();
    auto timeout = websocket::stream_base::timeout::suggested(beast::role_type::server);
    timeout.keep_alive_pings = true;
    timeout.idle_timeout = std::chrono::seconds(20);
    socket_.set_option(timeout);
    socket_.read_message_max(kMaxMessageBytes);
    socket_.binary(true);
    socket_.async_accept(request, [self = shared_from_this()](ErrorCode error) {
      if (!error) self->begin();
    });
  }

  void push(const Text& events) {
    if (events) events_.push_back(events);
    has_new_state_ = true;
    if (events_.size() > hub_.settings.max_queued_events) {
      ++hub_.counts.overrun;
      drop();
      return;
    }
    write_next();
  }

  void drop() {
    leave();
    beast::get_lowest_layer(socket_).close();
  }

 private:
  void begin() {
    ++hub_.counts.accepted;
    ++hub_.counts.clients;
    hub_.clients.insert(this);
    message_ = hub_.settings.greeting;
    events_ = hub_.past_events;
    has_new_state_ = true;
    write_next();
    read_next();
  }

  void leave() {
    if (hub_.clients.erase(this) != 0) --hub_.counts.clients;
  }

  /// One message: the newest state and all events that wait.
  void write_next() {
    if (is_writing_ || !has_new_state_ || !hub_.newest_state) return;
    is_writing_ = true;
    has_new_state_ = false;
    message_ += *hub_.newest_state;
    for (const Text& events : std::exchange(events_, {})) message_ += *events;
    socket_.async_write(asio::buffer(message_),
                        [self = shared_from_this()](ErrorCode error, std::size_t /*bytes*/) {
                          self->is_writing_ = false;
                          self->message_.clear();
                          if (error) {
                            self->drop();
                          } else {
                            self->write_next();
                          }
                        });
  }

  void read_next() {
    socket_.async_read(incoming_,
                       [self = shared_from_this()](ErrorCode error, std::size_t /*bytes*/) {
                         self->finish(error);
                       });
  }

  /// A read ends when the client leaves, or says something: the page has nothing to say.
  void finish(ErrorCode error) {
    const bool left = error == websocket::error::closed || error == asio::error::eof ||
                      error == asio::error::connection_reset ||
                      error == asio::error::operation_aborted || error == beast::error::timeout;
    if (!left) ++hub_.counts.misbehaved;
    leave();
    if (error) return;
    socket_.async_close({websocket::close_code::policy_error, "the station takes no messages"},
                        [self = shared_from_this()](ErrorCode /*ignored*/) {});
  }

  Hub& hub_;
  websocket::stream<beast::tcp_stream> socket_;
  beast::flat_static_buffer<2 * kMaxMessageBytes> incoming_;
  std::deque<Text> events_;
  bool has_new_state_{false};
  bool is_writing_{false};
  std::string message_;
};

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

Response answer_to(const Request& request, const WebFiles& files) {
  if (request.method() != http::verb::get && request.method() != http::verb::head) {
    return plain(request, http::status::method_not_allowed, "only GET\n");
  }
  const std::string_view target = view_of(request.target());
  const auto found = files.find(target.substr(0, target.find('?')));
  if (found == files.end()) return plain(request, http::status::not_found, "no such page\n");
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
               "default-src 'self'; img-src 'self' data:; frame-ancestors 'none'");
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
    const bool is_own =
        is_own_page(view_of(request[http::field::host]), view_of(request[http::field::origin]));
    if (!is_own) {
      ++hub_.counts.refused;
      respond(request, plain(request, http::status::forbidden, "foreign page\n"));
    } else if (!websocket::is_upgrade(request)) {
      respond(request, answer_to(request, hub_.settings.files));
    } else if (request.target() != "/live") {
      respond(request, plain(request, http::status::not_found, "WebSocket is under /live\n"));
    } else {
      std::make_shared<LiveClient>(hub_, std::move(stream_))->start(request);
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
    const std::set<LiveClient*> clients = hub.clients;  // a client that is dropped leaves the set
    for (LiveClient* client : clients) client->push(events);
  }

  Hub hub;
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

WebServerCounters WebServer::counters() const {
  const Counts& counts = impl_->hub.counts;
  return {counts.accepted, counts.refused, counts.overrun, counts.misbehaved, counts.clients};
}

}  // namespace teamsight::monitor
