// tests/network/hosts.cpp: see hosts.hpp.
#include "tests/network/hosts.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <linux/if_tun.h>
#include <net/if.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace teamsight::network {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error(what + ": " + std::generic_category().message(errno));
}

void run(const std::string& command) {
  // NOLINTNEXTLINE(concurrency-mt-unsafe): the environment does not change
  if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
}

// On a thread of its own: its network namespace becomes another one and ends with it.
void on_new_thread(const std::function<void()>& body) {
  std::exception_ptr error;
  std::thread([&] {
    try {
      body();
    } catch (...) {
      error = std::current_exception();
    }
  }).join();
  if (error) std::rethrow_exception(error);
}

int open_tap(const std::string& card) {
  const int tap = ::open("/dev/net/tun", O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (tap < 0) fail("/dev/net/tun");
  ifreq request{};
  request.ifr_flags = IFF_TAP | IFF_NO_PI;
  std::strncpy(request.ifr_name, card.c_str(), IFNAMSIZ - 1);
  if (::ioctl(tap, TUNSETIFF, &request) < 0) {
    ::close(tap);
    fail("TUNSETIFF " + card);
  }
  return tap;
}

void silence_ipv6() {
  for (const char* which : {"all", "default"}) {
    std::ofstream(std::string("/proc/sys/net/ipv6/conf/") + which + "/disable_ipv6") << 1;
  }
}

struct NewHost {
  Descriptor network_namespace;
  int tap{-1};
};

NewHost make_host(std::size_t index, const std::string& card) {
  NewHost host;
  on_new_thread([&] {
    if (::unshare(CLONE_NEWNET) != 0) fail("unshare(CLONE_NEWNET)");
    host.network_namespace = Descriptor(::open("/proc/thread-self/ns/net", O_RDONLY | O_CLOEXEC));
    if (host.network_namespace.get() < 0) fail("/proc/thread-self/ns/net");
    silence_ipv6();
    host.tap = open_tap(card);
    run("ip link set lo up && ip addr add " + Hosts::address(index) + "/24 dev " + card +
        " && ip link set " + card + " up");
  });
  return host;
}

}  // namespace

Descriptor::Descriptor(Descriptor&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

Descriptor::~Descriptor() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void go_first() noexcept {
  [[maybe_unused]] const int refused = ::setpriority(PRIO_PROCESS, 0, -15);
}

Hosts::Hosts(std::size_t count, const std::string& card, std::uint64_t seed) {
  std::vector<int> taps;
  for (std::size_t i = 0; i < count; ++i) {
    NewHost host = make_host(i, card);
    namespaces_.push_back(std::move(host.network_namespace));
    taps.push_back(host.tap);
  }
  switch_ = std::make_unique<Switch>(std::move(taps), seed);
}

std::string Hosts::problem() {
  try {
    const NewHost host = make_host(0, "probe0");
    ::close(host.tap);
    return {};
  } catch (const std::exception& error) {
    return error.what();
  }
}

std::vector<std::string> Hosts::on_host(std::size_t host,
                                        const std::vector<std::string>& argv) const {
  const std::string space =
      "/proc/" + std::to_string(::getpid()) + "/fd/" + std::to_string(namespaces_.at(host).get());
  const auto ahead = std::chrono::duration_cast<std::chrono::seconds>(clock_ahead(host)).count();
  std::vector<std::string> command{"/usr/bin/nsenter",
                                   "--net=" + space,
                                   "/usr/bin/unshare",
                                   "--time",
                                   "--monotonic",
                                   std::to_string(ahead)};
  command.insert(command.end(), argv.begin(), argv.end());
  return command;
}

std::chrono::nanoseconds Hosts::clock_ahead(std::size_t host) {
  return std::chrono::hours(1 + host);
}

std::string Hosts::address(std::size_t host) {
  return "10.77.0." + std::to_string(10 + host);
}

}  // namespace teamsight::network
