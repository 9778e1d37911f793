// monitor/referee/box_link.cpp: see monitor/referee/box_link.hpp.
#include "monitor/referee/box_link.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <stdexcept>
#include <utility>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "bus/clock.hpp"

namespace teamsight::monitor {
namespace {

constexpr Duration kTick = std::chrono::milliseconds(25);
constexpr Duration kRetry = std::chrono::seconds(1);
constexpr std::size_t kReadsPerTurn = 16;

sockaddr_in address_of(const BoxAddress& address) {
  sockaddr_in out{};
  out.sin_family = AF_INET;
  out.sin_port = htons(address.port);
  if (inet_pton(AF_INET, address.host.c_str(), &out.sin_addr) != 1) {
    throw std::runtime_error("--box: \"" + address.host +
                             "\" is no IP address, expected e.g. 172.16.1.2");
  }
  return out;
}

}  // namespace

BoxLink::BoxLink(BoxAddress address, bus::Loop& loop, Listener listener)
    : address_(std::move(address)),
      loop_(&loop),
      listener_(std::move(listener)) {
  static_cast<void>(address_of(address_));
  loop.every(kTick, [this]() { tick(); });
}

BoxLink::~BoxLink() {
  if (socket_ < 0) return;
  loop_->forget(socket_);
  ::close(socket_);
}

void BoxLink::tick() {
  if (state_ == State::kConnecting) finish_connecting();
  if (state_ == State::kConnected) write();
  const HostTime now = bus::host_now();
  const bool may_try = tried_ == HostTime{} || now - tried_ >= kRetry;
  if (state_ == State::kIdle && may_try) {
    tried_ = now;
    connect();
  }
}

void BoxLink::connect() {
  socket_ = ::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (socket_ < 0) return;
  const int yes = 1;
  ::setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
  const sockaddr_in address = address_of(address_);
  // The socket interface wants the general type.
  const auto* general = reinterpret_cast<const sockaddr*>(&address);
  state_ = State::kConnecting;
  if (::connect(socket_, general, sizeof address) != 0 && errno != EINPROGRESS) close();
}

void BoxLink::finish_connecting() {
  pollfd waiting{socket_, POLLOUT, 0};
  if (::poll(&waiting, 1, 0) != 1) {
    if (bus::host_now() - tried_ >= 5 * kRetry) close();
    return;
  }
  int error = 0;
  socklen_t size = sizeof error;
  if (::getsockopt(socket_, SOL_SOCKET, SO_ERROR, &error, &size) != 0 || error != 0) {
    close();
    return;
  }
  state_ = State::kConnected;
  sent_ = 0;
  loop_->on_readable(socket_, [this]() { read(); });
  listener_.connection(true);
}

void BoxLink::read() {
  std::array<char, 4096> buffer{};
  for (std::size_t turn = 0; turn < kReadsPerTurn; ++turn) {
    const ssize_t got = ::recv(socket_, buffer.data(), buffer.size(), 0);
    if (got < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (got <= 0) {
      close();
      return;
    }
    framer_.take({buffer.data(), static_cast<std::size_t>(got)}, listener_.message);
  }
}

void BoxLink::send(std::string message) {
  if (state_ != State::kConnected) return;
  if (!next_.empty()) ++skipped_;
  next_ = std::move(message);
  next_.push_back('\0');
  write();
}

void BoxLink::write() {
  while (state_ == State::kConnected) {
    if (outgoing_.empty()) outgoing_ = std::exchange(next_, {});
    if (outgoing_.empty()) return;
    const ssize_t done = ::send(socket_, outgoing_.data(), outgoing_.size(), MSG_NOSIGNAL);
    if (done < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (done < 0) {
      close();
      return;
    }
    outgoing_.erase(0, static_cast<std::size_t>(done));
    if (outgoing_.empty()) ++sent_;
  }
}

void BoxLink::close() {
  const bool was_connected = state_ == State::kConnected;
  if (was_connected) loop_->forget(socket_);
  ::close(std::exchange(socket_, -1));
  state_ = State::kIdle;
  framer_.reset();
  outgoing_.clear();
  next_.clear();
  if (was_connected) listener_.connection(false);
}

}  // namespace teamsight::monitor
