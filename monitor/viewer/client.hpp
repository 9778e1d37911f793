// monitor/viewer/client.hpp: one Foxglove-like viewer, on the web server's thread. Only for
// web_server.cpp: it brings Boost.Beast along.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "monitor/hub.hpp"
#include "monitor/viewer/protocol.hpp"

namespace teamsight::monitor {

inline constexpr std::size_t kMaxViewerRequestBytes = 16'384;

/// One viewer: told of every channel, sent what it subscribes to. What it does not take in time is
/// dropped, oldest first, counted, and it is told so.
class ViewerClient : public std::enable_shared_from_this<ViewerClient> {
 public:
  ViewerClient(Hub& hub, beast::tcp_stream stream) : hub_(hub), socket_(std::move(stream)) {
    ++hub_.connections;
  }

  ~ViewerClient() { --hub_.connections; }

  ViewerClient(const ViewerClient&) = delete;
  ViewerClient& operator=(const ViewerClient&) = delete;

  /// @param is_refused  ends the connection as soon as it stands, and says that a token is needed
  void start(const http::request<http::string_body>& request, bool is_refused) {
    set_up(socket_, kMaxViewerRequestBytes);
    const std::string protocol(viewer_protocol(offered_by(request)));
    socket_.set_option(
        websocket::stream_base::decorator([protocol](websocket::response_type& answer) {
          answer.set(http::field::sec_websocket_protocol, protocol);
        }));
    socket_.async_accept(request, [self = shared_from_this(), is_refused](ErrorCode error) {
      if (error) return;
      if (is_refused) {
        ++self->hub_.counts.refused;
        self->close(static_cast<websocket::close_code>(kTokenNeeded), "token");
      } else {
        self->begin();
      }
    });
  }

  /// What a request's client can speak, see viewer_protocol.
  static std::string_view offered_by(const http::request<http::string_body>& request) {
    const auto value = request[http::field::sec_websocket_protocol];
    return {value.data(), value.size()};
  }

  /// A message of a channel, if it is subscribed to.
  void push(recording::ChannelId channel, std::int64_t log_ns, const Text& payload) {
    for (const auto& [subscription, wanted] : subscriptions_.all()) {
      if (wanted == channel) {
        enqueue({viewer_header(subscription, log_ns), payload, false});
      }
    }
  }

  /// A text for the viewer.
  void say(std::string text) {
    enqueue({{}, std::make_shared<const std::string>(std::move(text)), true});
  }

 private:
  struct Outgoing {
    ViewerHeader header{};
    Text payload;
    bool is_text{false};
  };

  void begin() {
    ++hub_.counts.accepted;
    ++hub_.counts.viewers;
    hub_.viewers.insert(this);
    say(viewer_greeting(hub_.settings.name, hub_.settings.session));
    say(viewer_advertisement(0, hub_.channels));
    if (!hub_.settings.viewer_notice.empty()) {
      say(viewer_status(StatusLevel::kWarning, hub_.settings.viewer_notice));
    }
    read_next();
  }

  void leave() {
    if (hub_.viewers.erase(this) == 0) return;
    --hub_.counts.viewers;
    for (const auto& [subscription, channel] : subscriptions_.all()) --hub_.wanted[channel];
  }

  void drop() {
    leave();
    beast::get_lowest_layer(socket_).close();
  }

  void enqueue(Outgoing message) {
    waiting_bytes_ += message.payload->size();
    waiting_.push_back(std::move(message));
    while (waiting_bytes_ > hub_.settings.max_queued_viewer_bytes && waiting_.size() > 1) {
      waiting_bytes_ -= waiting_.front().payload->size();
      waiting_.pop_front();
      ++dropped_;
      ++hub_.counts.viewer_dropped;
    }
    write_next();
  }

  void write_next() {
    if (is_writing_ || waiting_.empty()) return;
    is_writing_ = true;
    current_ = std::move(waiting_.front());
    waiting_.pop_front();
    waiting_bytes_ -= current_.payload->size();
    const std::size_t header = current_.is_text ? 0 : current_.header.size();
    const std::array<asio::const_buffer, 2> parts{asio::buffer(current_.header.data(), header),
                                                  asio::buffer(*current_.payload)};
    socket_.binary(!current_.is_text);
    socket_.async_write(parts, [self = shared_from_this()](ErrorCode error, std::size_t /*bytes*/) {
      self->is_writing_ = false;
      if (error) {
        self->drop();
        return;
      }
      self->tell_of_dropped();
      self->write_next();
    });
  }

  /// Once it reads again.
  void tell_of_dropped() {
    if (dropped_ == 0 || !waiting_.empty()) return;
    say(viewer_status(StatusLevel::kWarning,
                      std::to_string(std::exchange(dropped_, 0)) +
                          " messages left out: this viewer did not take them in time"));
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
    if (hub_.viewers.count(this) == 0) return;  // was dropped while this was on its way
    const std::string text = beast::buffers_to_string(incoming_.data());
    incoming_.consume(incoming_.size());
    if (!socket_.got_text() || !rate_.allows(kMaxViewerRequestsPerSecond)) {
      ++hub_.counts.misbehaved;
      leave();
      close(websocket::close_code::policy_error, "more or other than a viewer says");
      return;
    }
    obey(text);
    read_next();
  }

  void obey(const std::string& text) {
    for (const auto& [subscription, channel] : subscriptions_.all()) --hub_.wanted[channel];
    std::string answer = subscriptions_.hear(text, hub_.channels.size());
    for (const auto& [subscription, channel] : subscriptions_.all()) ++hub_.wanted[channel];
    if (!answer.empty()) say(std::move(answer));
  }

  void close(websocket::close_code code, const char* reason) {
    socket_.async_close({code, reason}, [self = shared_from_this()](ErrorCode /*ignored*/) {});
  }

  // A layout with many panels subscribes to every topic in a burst.
  static constexpr std::size_t kMaxViewerRequestsPerSecond = 200;

  Hub& hub_;
  websocket::stream<beast::tcp_stream> socket_;
  beast::flat_static_buffer<2 * kMaxViewerRequestBytes> incoming_;
  Subscriptions subscriptions_;
  std::deque<Outgoing> waiting_;
  std::size_t waiting_bytes_{0};
  Outgoing current_;
  bool is_writing_{false};
  std::uint64_t dropped_{0};
  RateLimit rate_;
};

}  // namespace teamsight::monitor
