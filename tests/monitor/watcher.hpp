// tests/monitor/watcher.hpp: a page that watches the station, without a browser.
#pragma once

#include <cstdint>
#include <string>

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>

namespace teamsight::test {

/// "127.0.0.1:8080" of "http://127.0.0.1:8080/".
[[nodiscard]] inline std::string host_of(const std::string& url) {
  return url.substr(7, url.size() - 8);
}

[[nodiscard]] inline boost::asio::ip::tcp::socket connect_to(boost::asio::io_context& io,
                                                             const std::string& host) {
  const auto port = static_cast<std::uint16_t>(std::stoul(host.substr(host.rfind(':') + 1)));
  boost::asio::ip::tcp::socket socket(io);
  socket.connect({boost::asio::ip::make_address("127.0.0.1"), port});
  return socket;
}

/// One connection to /live, or as a viewer that offers `protocol`. Blocks; the test's time limit
/// bounds it.
class Watcher {
 public:
  explicit Watcher(const std::string& host,
                   const std::string& origin = {},
                   const std::string& target = "/live",
                   const std::string& protocol = {})
      : socket_(connect_to(io_, host)) {
    using Decorator = boost::beast::websocket::stream_base::decorator;
    socket_.set_option(Decorator([&](boost::beast::websocket::request_type& request) {
      using Field = boost::beast::http::field;
      if (!origin.empty()) request.set(Field::origin, origin);
      if (!protocol.empty()) request.set(Field::sec_websocket_protocol, protocol);
    }));
    socket_.handshake(host, target, error_);
    is_refused_ = error_.failed();
  }

  /// Whether the handshake failed.
  [[nodiscard]] bool is_refused() const { return is_refused_; }

  void send(const std::string& text) { socket_.write(boost::asio::buffer(text), error_); }

  void send_binary(const std::string& bytes) {
    socket_.binary(true);
    send(bytes);
  }

  /// The next message; empty when the connection ended.
  std::string next() {
    boost::beast::flat_buffer buffer;
    socket_.read(buffer, error_);
    return error_ ? std::string() : boost::beast::buffers_to_string(buffer.data());
  }

  [[nodiscard]] unsigned close_code() const { return socket_.reason().code; }

 private:
  boost::asio::io_context io_;
  boost::beast::error_code error_;
  bool is_refused_{false};
  boost::beast::websocket::stream<boost::asio::ip::tcp::socket> socket_;
};

}  // namespace teamsight::test
