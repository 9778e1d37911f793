// agent/carried_out.hpp: which commands were carried out already.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "bus/messages.hpp"

namespace teamsight::agent {

/// Remembers the newest commands. Only the last one of a frame is acknowledged, so that a station
/// may repeat one that a newer one has overtaken: it must be acknowledged, and not be done again.
/// A value.
class CarriedOut {
 public:
  [[nodiscard]] bool has(const bus::Command& command) const {
    return std::find(newest_.begin(), newest_.end(), name_of(command)) != newest_.end();
  }

  void note(const bus::Command& command) { newest_[next_++ % newest_.size()] = name_of(command); }

 private:
  /// Stations number apart.
  struct Name {
    std::uint32_t boot{0};
    std::uint32_t command{0};

    friend bool operator==(const Name&, const Name&) = default;
  };

  static Name name_of(const bus::Command& command) { return {command.id.boot, command.command}; }

  std::array<Name, 32> newest_{};
  std::size_t next_{0};
};

}  // namespace teamsight::agent
