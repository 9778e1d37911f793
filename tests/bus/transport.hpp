// tests/bus/transport.hpp: what the transport tests share: domains of their own, children, waiting.
#pragma once

#include <csignal>
#include <string>
#include <vector>

#include <poll.h>

#include "bus/clock.hpp"
#include "bus/participant.hpp"
#include "bus/reader.hpp"
#include "tests/bus/files.hpp"
#include "tests/support/process.hpp"

namespace teamsight::bus::testing {

using std::chrono::milliseconds;
using test::wait_until;

/// For discovery and whole processes on a machine that is busy.
inline constexpr milliseconds kPatience{20'000};

/// A domain that no other test uses, with the loopback profile.
inline DomainSettings own_domain(const std::string& tag = "bus-test") {
  return {test::unique_domain(), profile_path("loopback.xml"), tag};
}

/// Another process in that domain; see bus_test_child.cpp.
inline test::ChildProcess start_child(const std::string& what,
                                      const DomainSettings& domain,
                                      int number = 0,
                                      int second_number = 0) {
  return test::ChildProcess({BUS_TEST_CHILD,
                             what,
                             domain.profile_path,
                             std::to_string(domain.domain_id),
                             domain.tag,
                             std::to_string(number),
                             std::to_string(second_number)});
}

/// Takes what comes, as a process does, until `is_enough` or the bound.
template <class Message, class Use, class IsEnough>
bool take_until(Reader<Message>& reader,
                const Use& use,
                const IsEnough& is_enough,
                Duration bound = kPatience) {
  const HostTime end = host_now() + bound;
  while (!is_enough() && host_now() < end) {
    pollfd event{reader.event_fd(), POLLIN, 0};
    ::poll(&event, 1, 5);
    reader.take(host_now(), use);
  }
  return is_enough();
}

}  // namespace teamsight::bus::testing
