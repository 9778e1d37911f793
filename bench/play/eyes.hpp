// bench/play/eyes.hpp: who looks at a play, and what one look says.
#pragma once

#include <cstddef>
#include <cstdint>

#include "bench/play/perception.hpp"
#include "bench/play/play.hpp"
#include "fusion/observation.hpp"

namespace teamsight::play {

/// One frame of one robot.
struct Frame {
  double exposure{0.0};             ///< s, true
  std::uint32_t seen_balls{0};      ///< which true balls it shows, a bit each
  std::uint64_t seen_players{0};    ///< which true players it shows, a bit each
  fusion::Observation observation;  ///< exposure not filled in
};

/// The eyes of a whole team over one play; robots are counted from 0, in the order of the moment's
/// players.
class Eyes {
 public:
  Eyes() = default;
  virtual ~Eyes() = default;
  Eyes(const Eyes&) = delete;
  Eyes& operator=(const Eyes&) = delete;
  Eyes(Eyes&&) = delete;
  Eyes& operator=(Eyes&&) = delete;

  /// From now on this is wrong with that robot.
  virtual void set_fault(std::size_t robot, Fault fault, const Moment& moment) = 0;

  /// Once, with the first moment, after the faults that begin with it.
  virtual void begin(const Moment& first) = 0;

  /// After every step of the play.
  virtual void step(const Moment& moment) = 0;

  /// What a robot reports of this moment; `Frame::exposure` is left to the caller.
  ///
  /// @param since  s since its last frame
  [[nodiscard]] virtual Frame look(std::size_t robot, const Moment& moment, double since) = 0;
};

}  // namespace teamsight::play
