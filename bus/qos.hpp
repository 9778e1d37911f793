// bus/qos.hpp: a row of the topic table as the C API wants it. For bus/ only.
#pragma once

#include <cstdint>
#include <string>

#include "bus/entity.hpp"
#include "bus/topics.hpp"

namespace teamsight::bus {

/// What an endpoint takes from its participant.
struct Surroundings {
  Duration lease{kDefaultLease};
  std::string partition{};  ///< of the writers; empty: security is off
};

/// With security on a reader hears every speaker's partition.
[[nodiscard]] QosPointer reader_qos(const TopicProfile& profile, const Surroundings& around = {});

/// @param ownership_strength  used if the profile is exclusive
[[nodiscard]] QosPointer writer_qos(const TopicProfile& profile,
                                    std::int32_t ownership_strength,
                                    const Surroundings& around = {});

}  // namespace teamsight::bus
