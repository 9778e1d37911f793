// tests/network/writer_list.cpp: see writer_list.hpp.
#include "tests/network/writer_list.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>

#include <dds/dds.h>

#include "bus/entity.hpp"
#include "bus/participant.hpp"

namespace teamsight::network {

void list_writers(const bus::Participant& participant, const std::string& path) {
  const bus::Entity reader(
      dds_create_reader(participant.handle(), DDS_BUILTIN_TOPIC_DCPSPUBLICATION, nullptr, nullptr));
  constexpr std::size_t kMost = 512;
  std::array<void*, kMost> samples{};
  std::array<dds_sample_info_t, kMost> infos{};
  const auto count = dds_take(reader.handle(), samples.data(), infos.data(), kMost, kMost);
  std::ofstream file(path);
  for (int i = 0; i < count; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (!infos[at].valid_data) continue;
    const auto& endpoint = *static_cast<const dds_builtintopic_endpoint_t*>(samples[at]);
    for (const std::uint8_t byte : endpoint.key.v) {
      std::array<char, 3> text{};
      std::snprintf(text.data(), text.size(), "%02x", byte);
      file << text.data();
    }
    file << ' ' << endpoint.topic_name << '\n';
  }
  if (count > 0) dds_return_loan(reader.handle(), samples.data(), count);
}

std::map<WriterGuid, std::string> read_writers(const std::string& path) {
  std::map<WriterGuid, std::string> all;
  std::ifstream file(path);
  std::string digits;
  std::string topic;
  while (file >> digits >> topic) {
    WriterGuid guid{};
    for (std::size_t i = 0; i < guid.size() && 2 * i + 2 <= digits.size(); ++i) {
      guid[i] = static_cast<std::uint8_t>(std::stoul(digits.substr(2 * i, 2), nullptr, 16));
    }
    all[guid] = topic;
  }
  return all;
}

}  // namespace teamsight::network
