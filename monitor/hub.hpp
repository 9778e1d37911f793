// monitor/hub.hpp: what the web server's connections share. Only for web_server.cpp: it brings
// Boost.Beast along.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>

#include "monitor/mailbox.hpp"
#include "monitor/web_server.hpp"

namespace teamsight::monitor {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Tcp = asio::ip::tcp;
using ErrorCode = beast::error_code;

using Text = std::shared_ptr<const std::string>;

struct Counts {
  std::atomic<std::uint64_t> accepted{0};
  std::atomic<std::uint64_t> refused{0};
  std::atomic<std::uint64_t> overrun{0};
  std::atomic<std::uint64_t> misbehaved{0};
  std::atomic<std::uint64_t> clients{0};
  std::atomic<std::uint64_t> viewers{0};
  std::atomic<std::uint64_t> viewer_dropped{0};
};

class LiveClient;
class ViewerClient;

/// What every connection shares; used on the server's thread only, but for counts and `wanted`.
struct Hub {
  WebServerSettings settings;
  Counts counts;
  Text newest_state;
  std::deque<Text> past_events;
  std::set<LiveClient*> clients;
  std::set<ViewerClient*> viewers;
  std::vector<recording::Channel> channels;
  std::array<std::atomic<std::uint32_t>, kMaxChannels> wanted{};  ///< subscriptions per channel
  std::size_t connections{0};
  std::uint64_t last_client{0};
  Mailbox mailbox;
};

/// Counts what a client says, second by second.
class RateLimit {
 public:
  /// Takes one more; false: that is more than `most` in this second.
  bool allows(std::size_t most) {
    const auto now = std::chrono::steady_clock::now();
    if (now - second_began_ > std::chrono::seconds(1)) {
      second_began_ = now;
      said_ = 0;
    }
    return ++said_ <= most;
  }

 private:
  std::chrono::steady_clock::time_point second_began_;
  std::size_t said_{0};
};

/// Time limits and the largest message of a connection that has just begun.
inline void set_up(websocket::stream<beast::tcp_stream>& socket, std::size_t max_message_bytes) {
  beast::get_lowest_layer(socket).expires_never();
  auto timeout = websocket::stream_base::timeout::suggested(beast::role_type::server);
  timeout.keep_alive_pings = true;
  timeout.idle_timeout = std::chrono::seconds(20);
  socket.set_option(timeout);
  socket.read_message_max(max_message_bytes);
}

/// Whether a connection just ended, as connections do.
inline bool is_farewell(ErrorCode error) {
  return error == websocket::error::closed || error == asio::error::eof ||
         error == asio::error::connection_reset || error == asio::error::operation_aborted ||
         error == beast::error::timeout;
}

}  // namespace teamsight::monitor
