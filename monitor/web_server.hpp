// monitor/web_server.hpp: serves the page and pushes what it shows over WebSocket.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "monitor/web_files.hpp"
#include "recording/message_sink.hpp"

namespace teamsight::monitor {

/// The server cannot listen; one line that names the address, what was found and what to do.
class WebServerError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct WebServerSettings {
  std::string bind{"127.0.0.1"};  ///< an address of this computer
  std::uint16_t port{8080};       ///< 0: any free one
  WebFiles files;
  std::string greeting;                ///< begins the first message of every connection
  std::size_t max_clients{64};         ///< connections beyond are closed at once
  std::size_t max_queued_events{256};  ///< of one client; one that falls further behind is closed
  std::size_t remembered_events{64};   ///< a new client is told so many of the past ones
  std::string watch_token;             ///< needed to watch, as /live?token=...; empty: not needed
  std::size_t max_requests_per_second{30};  ///< of one client; one that says more is closed

  std::string name;           ///< what viewers call this station
  std::string session;        ///< differs for each start
  std::string token;          ///< lets a viewer's page of another site watch; empty: none may
  std::string viewer_notice;  ///< said to every viewer; empty: nothing
  std::size_t max_queued_viewer_bytes{1U << 20U};  ///< of one viewer; older messages are dropped
};

/// There are never more channels than this.
inline constexpr std::size_t kMaxChannels = 64;

/// Encoded messages that may be joined end to end (protobuf reads them as one).
struct Broadcast {
  std::string state;   ///< replaces the state before; a slow client skips to the newest
  std::string events;  ///< reaches every client, each in order; may be empty
  std::string extra;   ///< as events, but not for clients that come later; may be empty
};

/// What a client said, unread.
struct ClientMessage {
  std::uint64_t client{0};
  std::string bytes;
};

/// Close code of a connection without the right token.
inline constexpr std::uint16_t kTokenNeeded = 4401;

struct WebServerCounters {
  std::uint64_t accepted{0};        ///< WebSocket connections
  std::uint64_t refused{0};         ///< foreign origin or too many
  std::uint64_t overrun{0};         ///< closed because they did not keep up with events
  std::uint64_t misbehaved{0};      ///< closed because of what they sent
  std::uint64_t clients{0};         ///< pages that watch now
  std::uint64_t viewers{0};         ///< Foxglove-like viewers that watch now
  std::uint64_t viewer_dropped{0};  ///< messages that viewers did not take in time
};

/// HTTP for the page's files and WebSocket under /live, on a thread of its own; to a client that
/// offers one of Foxglove's subprotocols, under any path, that protocol (viewer/protocol.hpp).
///
/// A page of another origin, and a page that reached us under a foreign name, is refused, but for
/// a viewer with the token. What clients say is bounded in size and rate; what pages say is handed
/// on unread.
class WebServer {
 public:
  /// Listens at once.
  ///
  /// @throws WebServerError if the address cannot be had
  explicit WebServer(WebServerSettings settings);

  /// Closes every connection and joins the thread.
  ~WebServer();
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  /// Address of the page, e.g. "http://127.0.0.1:8080/".
  [[nodiscard]] std::string url() const;

  /// Hands every client what is new. Returns at once; any thread.
  void publish(Broadcast broadcast);

  /// What clients have said since the last call, oldest first. Any thread.
  [[nodiscard]] std::vector<ClientMessage> take_messages();

  /// Readable whenever there is something to take; cleared by `take_messages`.
  [[nodiscard]] int event_fd() const noexcept;

  /// An encoded message for one client; one that has left hears nothing. Any thread.
  void tell(std::uint64_t client, std::string message);

  /// Adds a channel for viewers; those that are connected are told. One thread.
  ///
  /// @pre there are fewer than kMaxChannels
  recording::ChannelId add_channel(recording::Channel channel);

  /// Whether a viewer has subscribed to it. Any thread.
  [[nodiscard]] bool is_wanted(recording::ChannelId channel) const;

  /// Sends a message to the viewers that have subscribed. Returns at once; any thread.
  void send(recording::ChannelId channel, std::int64_t log_ns, std::string payload);

  /// Any thread.
  [[nodiscard]] WebServerCounters counters() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Whether a request may be answered: its Host names this computer by number or as localhost, and
/// its Origin, if it has one, is the page we served ourselves.
///
/// Guards against pages of other sites, also those that point a name of theirs at our address.
[[nodiscard]] bool is_own_page(std::string_view host, std::string_view origin);

}  // namespace teamsight::monitor
