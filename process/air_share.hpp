// process/air_share.hpp: one process's share of the team's air: what it sends, what it leaves out.
#pragma once

#include <cstdint>
#include <string>

#include "bus/loop.hpp"
#include "bus/messages.hpp"
#include "bus/participant.hpp"
#include "bus/reader.hpp"
#include "process/governor.hpp"
#include "process/token_bucket.hpp"

namespace teamsight::process {

/// Measures the own rate on the wire, hears the others' (Diagnostics), and says what to leave out.
/// Use from the loop's thread.
class AirShare {
 public:
  /// @param team  must outlive it
  AirShare(const bus::Participant& team, std::string process);

  /// Listens, and steps once a second, at a moment of its own choosing.
  void attach(bus::Loop& loop);

  [[nodiscard]] Thrift thrift() const { return governor_.thrift(); }

  /// Whether a sample that the team can do without (diagnostics, pictures) may go now.
  [[nodiscard]] bool may_tell(std::size_t bytes, HostTime now);

  /// Who else reports.
  [[nodiscard]] const bus::Reader<bus::Diagnostics>& reports() const { return others_; }

  /// Puts rate and thrift into a report, and into its message if that is empty.
  void tell(bus::Diagnostics& report) const;

 private:
  void listen();
  void step();

  const bus::Participant* team_;
  std::string process_;
  bus::Reader<bus::Diagnostics> others_;
  Governor governor_;
  TokenBucket bucket_;
  std::uint64_t bytes_{0};
  HostTime measured_{};
  double own_bps_{0.0};
  std::uint32_t steps_{0};
};

/// Leaves out the raw obstacles that this much thrift costs.
///
/// @return how many were left out
std::size_t trim(bus::Sightings& sightings, Thrift thrift);

}  // namespace teamsight::process
