// bus/speakers.cpp: see speakers.hpp.
#include "bus/speakers.hpp"

#include <algorithm>

#include "bus/security.hpp"

namespace teamsight::bus {
namespace {

constexpr std::size_t kMaxKnown = 64;

std::optional<RobotId> ask(dds_entity_t reader, dds_instance_handle_t writer) {
  const EndpointPointer endpoint(dds_get_matched_publication_data(reader, writer));
  if (!endpoint) return std::nullopt;  // it has left meanwhile
  std::uint32_t count = 0;
  char** names = nullptr;
  if (!dds_qget_partition(endpoint->qos, &count, &names)) return std::nullopt;
  std::optional<RobotId> robot;
  if (count == 1) robot = speaker_of(names[0]);
  for (std::uint32_t i = 0; i < count; ++i) dds_free(names[i]);
  dds_free(names);
  return robot;
}

}  // namespace

Speakers::Speakers(bool is_secured) : is_secured_(is_secured) {
  known_.reserve(kMaxKnown);
}

bool Speakers::may_speak(dds_entity_t reader, dds_instance_handle_t writer, RobotId robot) {
  if (!is_secured_) return true;
  const auto found = std::find_if(
      known_.begin(), known_.end(), [&](const Entry& entry) { return entry.writer == writer; });
  if (found != known_.end()) return found->robot == robot;
  const std::optional<RobotId> speaker = ask(reader, writer);
  if (!speaker) return false;
  if (known_.size() == kMaxKnown) known_.erase(known_.begin());
  known_.push_back({writer, speaker});
  return *speaker == robot;
}

}  // namespace teamsight::bus
