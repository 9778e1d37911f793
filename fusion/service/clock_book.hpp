// fusion/service/clock_book.hpp: every peer's clock, from the probes and echoes on the bus.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "bus/messages.hpp"
#include "fusion/clock_offset.hpp"
#include "geometry/identity.hpp"
#include "geometry/time.hpp"

namespace teamsight::fusion {

/// A peer's stamp in this host's time.
struct ConvertedStamp {
  HostTime time;
  Duration sigma{0};
};

/// Asks the peers for their time, answers theirs, and converts their stamps. Time as an argument.
class ClockBook {
 public:
  /// @param host  this host's robot id
  /// @param boot  of this process
  ClockBook(RobotId host, std::uint32_t boot);

  /// The next question, to be written at once.
  [[nodiscard]] bus::ClockProbe next_probe(HostTime now);

  /// How many there were.
  [[nodiscard]] std::uint32_t probes() const { return probes_; }

  /// Notes a peer's question; the own ones are left out.
  void take_probe(const bus::ClockProbe& probe, HostTime now);

  /// The answers to all questions since the last echo; nothing if there were none.
  [[nodiscard]] std::optional<bus::ClockEcho> next_echo(HostTime now);

  /// Takes the answers to own questions in. A peer that was started again is another one on the
  /// same clock; it is listened to once the first has been silent for a while, because until then
  /// it may be a second computer under the same id, with a clock of its own.
  void take_echo(const bus::ClockEcho& echo, HostTime now);

  /// Converts a stamp of any process on the computer of `robot`.
  ///
  /// While a peer has not been measured, its clock is taken to be this host's if the stamp is
  /// plausible as such (within a second of `now`): several robots on one computer.
  ///
  /// @return nothing if the peer's clock is not known
  [[nodiscard]] std::optional<ConvertedStamp> convert(RobotId robot,
                                                      PeerTime stamp,
                                                      HostTime now) const;

  /// @return nothing if the peer was not measured
  [[nodiscard]] std::optional<ClockEstimate> estimate(RobotId robot, HostTime now) const;

 private:
  struct Peer {
    std::uint32_t boot{0};
    HostTime heard{};
    ClockOffset clock;
  };

  struct Question {
    std::uint32_t sequence{0};
    HostTime sent;
  };

  RobotId host_;
  std::uint32_t boot_;
  std::uint32_t probes_{0};
  std::uint32_t echoes_{0};
  std::array<Question, 32> questions_{};  // a ring by sequence
  std::vector<bus::ClockReply> replies_;
  std::array<Peer, kMaxRobotId> peers_{};
};

}  // namespace teamsight::fusion
