// tests/network/attack_main.cpp: a stranger who has listened: sends a team's own packets back to
// it, changed.
//
// usage: teamsight-bench-attack DOMAIN PACKETS_PER_SECOND SEED FILE
// FILE: RTPS messages, each after its length in two bytes, low byte first.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <random>
#include <thread>
#include <vector>

#include "tests/network/stranger.hpp"

namespace {

using Packet = std::vector<std::uint8_t>;
using Random = std::mt19937;

std::vector<Packet> read_packets(const char* path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<Packet> all;
  std::array<char, 2> length{};
  while (file.read(length.data(), 2)) {
    const std::size_t low = static_cast<std::uint8_t>(length[0]);
    Packet packet(low | static_cast<std::size_t>(static_cast<std::uint8_t>(length[1])) << 8U);
    file.read(reinterpret_cast<char*>(packet.data()), static_cast<std::streamsize>(packet.size()));
    all.push_back(std::move(packet));
  }
  return all;
}

std::size_t draw(Random& random, std::size_t below) {
  return std::uniform_int_distribution<std::size_t>(0, below - 1)(random);
}

std::uint8_t byte(Random& random) {
  return static_cast<std::uint8_t>(draw(random, 256));
}

// The sequence number of the first DATA submessage, high above the true one.
void forge_sequence_number(Packet& packet, Random& random) {
  constexpr std::uint8_t kData = 0x15;
  for (std::size_t at = 20; at + 24 <= packet.size();) {
    if (packet[at] == kData) {
      packet[at + 4 + 12 + 4 + 2] = byte(random);  // third byte of the low word: + 65536 and more
      return;
    }
    const std::size_t length = packet[at + 2] | static_cast<std::size_t>(packet[at + 3]) << 8U;
    if (length == 0) return;
    at += 4 + length;
  }
}

void mutate(Packet& packet, Random& random) {
  switch (draw(random, 5)) {
    case 0:  // as it was: a replay
      return;
    case 1:
      packet.resize(20 + draw(random, packet.size() - 19));
      return;
    case 2:
      forge_sequence_number(packet, random);
      return;
    case 3:
      for (std::size_t i = 0; i < 8; ++i)
        packet[20 + draw(random, packet.size() - 20)] = byte(random);
      return;
    default:
      packet[draw(random, packet.size())] ^= static_cast<std::uint8_t>(1U << draw(random, 8));
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return 2;
  const int ports = 7400 + 250 * std::atoi(argv[1]);
  const int per_turn = std::max(1, std::atoi(argv[2]) / 100);
  Random random(static_cast<Random::result_type>(std::atoi(argv[3])));
  std::vector<Packet> packets = read_packets(argv[4]);
  std::erase_if(packets, [](const Packet& packet) { return packet.size() < 44; });
  if (packets.empty()) return 2;
  const int out = teamsight::network::multicast_socket();
  for (;;) {
    for (int i = 0; i < per_turn; ++i) {
      Packet packet = packets[draw(random, packets.size())];
      mutate(packet, random);
      const sockaddr_in to = teamsight::network::multicast(ports + i % 2);
      ::sendto(
          out, packet.data(), packet.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof to);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
}
