// bus/qos.hpp: a row of the topic table as the C API wants it. For bus/ only.
#pragma once

#include <cstdint>

#include "bus/entity.hpp"
#include "bus/topics.hpp"

namespace teamsight::bus {

[[nodiscard]] QosPointer reader_qos(const TopicProfile& profile, Duration lease = kDefaultLease);

/// @param ownership_strength  used if the profile is exclusive
[[nodiscard]] QosPointer writer_qos(const TopicProfile& profile,
                                    std::int32_t ownership_strength,
                                    Duration lease = kDefaultLease);

}  // namespace teamsight::bus
