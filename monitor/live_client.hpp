// monitor/live_client.hpp: one browser that watches, on the web server's thread. Only for
// web_server.cpp: it brings Boost.Beast along.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <utility>

#include "monitor/hub.hpp"

namespace teamsight::monitor {

inline constexpr std::size_t kMaxMessageBytes = 1024;

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
    set_up(socket_, kMaxMessageBytes);
    socket_.binary(true);
    socket_.async_accept(request, [self = shared_from_this()](ErrorCode error) {
      if (!error) self->begin();
    });
  }

  [[nodiscard]] std::uint64_t id() const { return id_; }

  /// Ends the connection as soon as it stands, and says that a token is needed.
  void refuse() { is_refused_ = true; }

  void push(const Text& events, const Text& extra) {
    if (events) events_.push_back(events);
    if (extra) events_.push_back(extra);
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
    if (is_refused_) {
      ++hub_.counts.refused;
      close(static_cast<websocket::close_code>(kTokenNeeded), "token");
      return;
    }
    id_ = ++hub_.last_client;
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
    socket_.async_read(
        incoming_,
        [self = shared_from_this()](ErrorCode error, std::size_t /*bytes*/) { self->hear(error); });
  }

  void hear(ErrorCode error) {
    if (error) {
      if (!is_farewell(error)) ++hub_.counts.misbehaved;
      leave();
      return;
    }
    std::string bytes = beast::buffers_to_string(incoming_.data());
    incoming_.consume(incoming_.size());
    if (!socket_.got_binary() || !rate_.allows(hub_.settings.max_requests_per_second) ||
        !hub_.mailbox.put({id_, std::move(bytes)})) {
      ++hub_.counts.misbehaved;
      leave();
      close(websocket::close_code::policy_error, "more or other than a page says");
      return;
    }
    read_next();
  }

  void close(websocket::close_code code, const char* reason) {
    socket_.async_close({code, reason}, [self = shared_from_this()](ErrorCode /*ignored*/) {});
  }

  Hub& hub_;
  websocket::stream<beast::tcp_stream> socket_;
  beast::flat_static_buffer<2 * kMaxMessageBytes> incoming_;
  std::deque<Text> events_;
  bool has_new_state_{false};
  bool is_writing_{false};
  std::string message_;
  std::uint64_t id_{0};
  bool is_refused_{false};
  RateLimit rate_;
};

}  // namespace teamsight::monitor
