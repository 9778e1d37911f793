// tests/process/supervision_test.cpp: a supervisor hears that the loop turns, and when it hangs.
#include "process/supervision.hpp"

#include <cstdlib>
#include <cstring>
#include <string>

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace teamsight::process {
namespace {

using std::chrono::milliseconds;

/// The end of the socket that systemd holds.
class Supervisor {
 public:
  Supervisor() {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string name = "@teamsight-supervision-" + std::to_string(::getpid());
    std::memcpy(address.sun_path + 1, name.data() + 1, name.size() - 1);
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
    EXPECT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&address), size), 0);
    ::setenv("NOTIFY_SOCKET", name.c_str(), 1);
  }

  ~Supervisor() {
    ::close(socket_);
    ::unsetenv("NOTIFY_SOCKET");
    ::unsetenv("WATCHDOG_USEC");
  }

  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;

  /// What has come; empty: nothing.
  [[nodiscard]] std::string hear() const {
    char text[64];
    const auto size = ::recv(socket_, text, sizeof text, MSG_DONTWAIT);
    return size < 0 ? "" : std::string(text, static_cast<std::size_t>(size));
  }

 private:
  int socket_{::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)};
};

TEST(Supervision, SaysReadyAndThenAliveFromTheLoop) {
  const Supervisor supervisor;
  ::setenv("WATCHDOG_USEC", "8000", 1);
  bus::Loop loop;

  report_to_supervisor(loop);

  EXPECT_EQ(supervisor.hear(), "READY=1");
  EXPECT_EQ(supervisor.hear(), "");  // a loop that does not turn says nothing
  loop.every(milliseconds(9), [&] { loop.stop(); });
  loop.run();
  EXPECT_EQ(supervisor.hear(), "WATCHDOG=1");
}

TEST(Supervision, IsSilentWithoutASupervisor) {
  bus::Loop loop;

  EXPECT_NO_THROW(report_to_supervisor(loop));
}

}  // namespace
}  // namespace teamsight::process
