// bus/wire_meter.cpp: see wire_meter.hpp.
#include "bus/wire_meter.hpp"

#include <array>
#include <atomic>
#include <cstddef>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace teamsight::bus {
namespace {

constexpr std::uint64_t kHeaders = 14 + 20 + 8;  // Ethernet, IPv4, UDP
// RTPS: the ports of domain d begin at 7400 + 250 d. The first thing that the library sends through
// a socket goes to such a port (discovery); later ones may go to whatever port a peer has.
constexpr std::uint32_t kPortBase = 7400;
constexpr std::uint32_t kPortsPerDomain = 250;
constexpr std::uint32_t kDomains = 231;
constexpr std::size_t kSockets = 1024;

struct Sum {
  std::atomic<std::uint64_t> datagrams{0};
  std::atomic<std::uint64_t> bytes{0};
};

// Zero before any constructor runs, because the library may send at any time.
constinit std::array<Sum, kDomains> sums{};
constinit std::array<std::atomic<std::uint32_t>, kSockets>
    domain_of_socket{};  // id + 1; 0 = unknown

void learn(std::atomic<std::uint32_t>& domain, const sockaddr_in& to) noexcept {
  const bool is_multicast = IN_MULTICAST(ntohl(to.sin_addr.s_addr));
  if (domain.load(std::memory_order_relaxed) != 0 && !is_multicast) return;
  const std::uint32_t port = ntohs(to.sin_port);
  if (port < kPortBase || port >= kPortBase + kPortsPerDomain * kDomains) return;
  domain.store(1 + (port - kPortBase) / kPortsPerDomain, std::memory_order_relaxed);
}

// On the library's threads, in the middle of a send.
[[maybe_unused]] void count(int socket, const msghdr& message, std::size_t size) noexcept {
  if (socket < 0 || static_cast<std::size_t>(socket) >= kSockets) return;
  const auto* const to = static_cast<const sockaddr_in*>(message.msg_name);
  if (to == nullptr || message.msg_namelen < sizeof *to || to->sin_family != AF_INET) return;
  auto& domain = domain_of_socket[static_cast<std::size_t>(socket)];
  learn(domain, *to);
  const std::uint32_t known = domain.load(std::memory_order_relaxed);
  if (known == 0) return;
  sums[known - 1].datagrams.fetch_add(1, std::memory_order_relaxed);
  sums[known - 1].bytes.fetch_add(size + kHeaders, std::memory_order_relaxed);
}

}  // namespace

WireCounters wire_counters(std::uint32_t domain_id) noexcept {
  if (domain_id >= kDomains) return {};
  const Sum& sum = sums[domain_id];
  return {sum.datagrams.load(std::memory_order_relaxed), sum.bytes.load(std::memory_order_relaxed)};
}

}  // namespace teamsight::bus

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
// Takes the place of glibc's for every library of the process, as monotonic_wait.cpp does.
// NOLINTNEXTLINE(readability-inconsistent-declaration-parameter-name): glibc's names are reserved
extern "C" ssize_t sendmsg(int socket, const msghdr* message, int flags) {
  const ssize_t sent = syscall(SYS_sendmsg, socket, message, flags);
  if (sent >= 0) teamsight::bus::count(socket, *message, static_cast<std::size_t>(sent));
  return sent;
}
#endif
