// bus/speakers.hpp: in whose name each writer that a reader hears may speak. For bus/ only.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "bus/entity.hpp"
#include "geometry/identity.hpp"

namespace teamsight::bus {

/// Remembers the partition of each writer; the permissions bind a speaker to its own.
///
/// With security off everything is believed.
class Speakers {
 public:
  explicit Speakers(bool is_secured);

  /// Whether this writer may say something in the name of `robot` (kNobody: the coach station).
  [[nodiscard]] bool may_speak(dds_entity_t reader, dds_instance_handle_t writer, RobotId robot);

 private:
  struct Entry {
    dds_instance_handle_t writer{0};
    std::optional<RobotId> robot;
  };

  bool is_secured_;
  std::vector<Entry> known_;
};

}  // namespace teamsight::bus
