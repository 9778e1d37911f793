// process/supervision.cpp: see supervision.hpp.
#include "process/supervision.hpp"

#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace teamsight::process {
namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): nobody sets it
  return value == nullptr ? "" : value;
}

// A socket per message: once a second, and it survives a supervisor that starts anew.
void notify(const std::string& path, std::string_view text) noexcept {
  sockaddr_un address{};
  if (path.empty() || path.size() >= sizeof address.sun_path) return;
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, path.data(), path.size());
  if (path[0] == '@') address.sun_path[0] = '\0';  // an abstract one
  const int out = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (out < 0) return;
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + path.size());
  [[maybe_unused]] const auto sent = ::sendto(out,
                                              text.data(),
                                              text.size(),
                                              MSG_NOSIGNAL,
                                              reinterpret_cast<const sockaddr*>(&address),
                                              size);
  ::close(out);
}

void lock_memory() {
  if (environment("TEAMSIGHT_LOCK_MEMORY").empty()) return;
  if (::mlockall(MCL_CURRENT | MCL_FUTURE) == 0) return;
  throw std::runtime_error("TEAMSIGHT_LOCK_MEMORY is set and memory cannot be locked: " +
                           std::generic_category().message(errno) +
                           "; expected LimitMEMLOCK=infinity in the unit");
}

}  // namespace

void report_to_supervisor(bus::Loop& loop) {
  lock_memory();
  const std::string socket = environment("NOTIFY_SOCKET");
  if (socket.empty()) return;
  notify(socket, "READY=1");
  const long limit_us = std::strtol(environment("WATCHDOG_USEC").c_str(), nullptr, 10);
  if (limit_us <= 0) return;
  constexpr int kPerLimit = 4;  // three may be late
  loop.every(std::chrono::microseconds(limit_us) / kPerLimit,
             [socket] { notify(socket, "WATCHDOG=1"); });
}

}  // namespace teamsight::process
