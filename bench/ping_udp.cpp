// bench/ping_udp.cpp: the bare UDP ping of ping.hpp.
#include <array>
#include <cerrno>
#include <system_error>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include "bench/ping.hpp"

namespace teamsight::bench {
namespace {

using Payload = std::array<char, kPingBytes>;

// A UDP socket on the loopback interface, closed at the end.
class Socket {
 public:
  Socket() : descriptor_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    check(descriptor_, "socket");
  }

  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  Socket(Socket&&) = delete;
  Socket& operator=(Socket&&) = delete;

  ~Socket() { ::close(descriptor_); }

  [[nodiscard]] int descriptor() const { return descriptor_; }

  static void check(int result, const char* call) {
    if (result < 0) {
      throw std::system_error(errno, std::generic_category(), call);
    }
  }

 private:
  int descriptor_;
};

sockaddr_in loopback(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

// The socket API takes every address as the same pointer type.
const sockaddr* as_sockaddr(const sockaddr_in& address) {
  return reinterpret_cast<const sockaddr*>(&address);
}

}  // namespace

PingResult ping_udp(const PingPlan& plan) {
  const Socket socket;
  const sockaddr_in echo = loopback(plan.udp_port);
  Socket::check(::connect(socket.descriptor(), as_sockaddr(echo), sizeof(echo)), "connect");
  const timeval patience{0, kAnswerWithin / std::chrono::microseconds(1)};
  Socket::check(
      ::setsockopt(socket.descriptor(), SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof(patience)),
      "setsockopt");
  Payload payload{};

  return run_pings(plan, [&] {
    return ::send(socket.descriptor(), payload.data(), payload.size(), 0) > 0 &&
           ::recv(socket.descriptor(), payload.data(), payload.size(), 0) > 0;
  });
}

void echo_udp(const PingPlan& plan) {
  const Socket socket;
  const sockaddr_in address = loopback(plan.udp_port);
  Socket::check(::bind(socket.descriptor(), as_sockaddr(address), sizeof(address)), "bind");
  Payload payload{};
  sockaddr_in from{};
  while (true) {
    socklen_t length = sizeof(from);
    auto* const sender = reinterpret_cast<sockaddr*>(&from);
    const ssize_t got =
        ::recvfrom(socket.descriptor(), payload.data(), payload.size(), 0, sender, &length);
    if (got > 0) {
      ::sendto(
          socket.descriptor(), payload.data(), static_cast<std::size_t>(got), 0, sender, length);
    }
  }
}

}  // namespace teamsight::bench
