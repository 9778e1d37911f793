// tests/bus/forger.hpp: one packet that shuts a writer out: its number is far above the true one.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <arpa/inet.h>
#include <dds/dds.h>
#include <sys/socket.h>
#include <unistd.h>

#include "bus/entity.hpp"
#include "bus/participant.hpp"
#include "bus/reader.hpp"

namespace teamsight::bus::testing {

/// Name of the one writer of a topic in the domain, as every participant hears it announced.
inline std::optional<WriterName> announced_writer(const Participant& participant,
                                                  const std::string& topic) {
  const Entity reader(
      dds_create_reader(participant.handle(), DDS_BUILTIN_TOPIC_DCPSPUBLICATION, nullptr, nullptr));
  std::array<void*, 64> samples{};
  std::array<dds_sample_info_t, 64> infos{};
  const auto count =
      dds_take(reader.handle(), samples.data(), infos.data(), samples.size(), samples.size());
  std::optional<WriterName> name;
  for (int i = 0; i < count; ++i) {
    const auto& endpoint =
        *static_cast<const dds_builtintopic_endpoint_t*>(samples[static_cast<std::size_t>(i)]);
    if (endpoint.topic_name != topic) continue;
    name.emplace();
    std::copy_n(std::begin(endpoint.key.v), name->size(), name->begin());
  }
  if (count > 0) dds_return_loan(reader.handle(), samples.data(), count);
  return name;
}

/// An RTPS message with one sample of this writer, its number a million above any true one.
inline std::vector<std::uint8_t> forged(const WriterName& writer) {
  std::vector<std::uint8_t> packet{'R', 'T', 'P', 'S', 2, 1, 1, 0x10};
  packet.insert(packet.end(), writer.begin(), writer.begin() + 12);
  packet.insert(packet.end(), {0x15, 0x05, 0, 0, 0, 0, 16, 0, 0, 0, 0, 0});  // DATA, any reader
  packet.insert(packet.end(), writer.begin() + 12, writer.end());
  packet.insert(packet.end(), {0, 0, 0, 0, 0x40, 0x42, 0x0f, 0, 0, 1, 0, 0});  // number; encoding
  packet.resize(packet.size() + 256);
  return packet;
}

/// An RTPS message that says of a reliable writer that all up to a million are gone.
inline std::vector<std::uint8_t> forged_heartbeat(const WriterName& writer) {
  std::vector<std::uint8_t> packet{'R', 'T', 'P', 'S', 2, 1, 1, 0x10};
  packet.insert(packet.end(), writer.begin(), writer.begin() + 12);
  packet.insert(packet.end(), {0x07, 0x03, 28, 0, 0, 0, 0, 0});  // HEARTBEAT, final; any reader
  packet.insert(packet.end(), writer.begin() + 12, writer.end());
  for (int i = 0; i < 2; ++i) {  // first and last number that there is
    packet.insert(packet.end(), {0, 0, 0, 0, 0x40, 0x42, 0x0f, 0});
  }
  packet.insert(packet.end(), {0, 0, 0, 0x10});  // its own number, above the true ones
  return packet;
}

/// Sends it as the team's own samples go: by multicast, on the loopback interface.
inline void send_forged(const std::vector<std::uint8_t>& packet, std::uint32_t domain) {
  const int out = ::socket(AF_INET, SOCK_DGRAM, 0);
  in_addr loopback{};
  loopback.s_addr = htonl(INADDR_LOOPBACK);
  ::setsockopt(out, IPPROTO_IP, IP_MULTICAST_IF, &loopback, sizeof loopback);
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(static_cast<std::uint16_t>(7401 + 250 * domain));
  inet_pton(AF_INET, "239.255.0.1", &to.sin_addr);
  ::sendto(out, packet.data(), packet.size(), 0, reinterpret_cast<sockaddr*>(&to), sizeof to);
  ::close(out);
}

inline void forge_number(const WriterName& writer, std::uint32_t domain) {
  send_forged(forged(writer), domain);
}

}  // namespace teamsight::bus::testing
