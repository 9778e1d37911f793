// tests/network/stranger.hpp: how who is no member of the team reaches it by multicast.
#pragma once

#include <cstdint>

#include <arpa/inet.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>

namespace teamsight::network {

/// The group of every DDS domain, at one of its ports.
inline sockaddr_in multicast(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  inet_pton(AF_INET, "239.255.0.1", &address.sin_addr);
  return address;
}

/// A socket that sends to it on the bench's card.
inline int multicast_socket() {
  const int out = ::socket(AF_INET, SOCK_DGRAM, 0);
  ip_mreqn card{};  // with the card named no route is needed
  card.imr_ifindex = static_cast<int>(if_nametoindex("wlan0"));
  ::setsockopt(out, IPPROTO_IP, IP_MULTICAST_IF, &card, sizeof card);
  return out;
}

}  // namespace teamsight::network
