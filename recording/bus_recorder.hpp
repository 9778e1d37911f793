// recording/bus_recorder.hpp: everything that is said on the bus, into a recording.
#pragma once

#include <memory>

#include "bus/loop.hpp"
#include "bus/participant.hpp"
#include "recording/recorder.hpp"

namespace teamsight::recording {

/// Listens to every topic of the team's domain, with readers of its own. Use from the loop's
/// thread.
///
/// Samples that a reader drops are not recorded; they stand in the file as counters of Diagnostics.
class BusRecorder {
 public:
  /// @param loop, recorder  outlive this
  BusRecorder(const bus::Participant& team, bus::Loop& loop, Recorder& recorder);
  ~BusRecorder();
  BusRecorder(const BusRecorder&) = delete;
  BusRecorder& operator=(const BusRecorder&) = delete;

  /// The truth of a simulated match as well, which has a domain of its own.
  void add_truth(const bus::Participant& match);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace teamsight::recording
