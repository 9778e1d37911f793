// tests/network/flood_main.cpp: a host that floods: usage: teamsight-bench-flood DOMAIN
// PACKETS_PER_SECOND
//
// Random bytes behind an RTPS header, to the discovery and data ports of the domain by multicast.
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <thread>

#include "tests/network/stranger.hpp"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const int ports = 7400 + 250 * std::atoi(argv[1]);
  const int per_turn = std::atoi(argv[2]) / 100;
  const int out = teamsight::network::multicast_socket();
  std::mt19937 random(1);
  std::array<std::uint8_t, 1200> packet{'R', 'T', 'P', 'S', 2, 1, 1, 16};
  for (;;) {
    for (int i = 0; i < per_turn; ++i) {
      for (std::size_t at = 8; at < packet.size(); at += 4) {
        const auto bits = static_cast<std::uint32_t>(random());
        for (std::size_t byte = 0; byte < 4; ++byte) {
          packet.at(at + byte) = static_cast<std::uint8_t>(bits >> (8 * byte));
        }
      }
      const sockaddr_in to = teamsight::network::multicast(ports + i % 2);
      if (::sendto(out,
                   packet.data(),
                   packet.size(),
                   0,
                   reinterpret_cast<const sockaddr*>(&to),
                   sizeof to) < 0) {
        std::perror("sendto");
        return 1;
      }
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}
