// recording/bus_recorder.hpp: everything that is said on the bus, into a recording or to viewers.
#pragma once

#include <memory>

#include "bus/loop.hpp"
#include "bus/participant.hpp"
#include "geometry/field_model.hpp"
#include "geometry/time.hpp"
#include "recording/message_sink.hpp"

namespace teamsight::recording {

/// Listens to every topic of the team's domain, with readers of its own. Use from the loop's
/// thread.
///
/// World models go out as scenes as well (scene.hpp).
/// Samples that a reader drops are not recorded; they stand in the file as counters of Diagnostics.
class BusRecorder {
 public:
  /// @param loop, sink  outlive this
  BusRecorder(const bus::Participant& team, bus::Loop& loop, MessageSink& sink);
  ~BusRecorder();
  BusRecorder(const BusRecorder&) = delete;
  BusRecorder& operator=(const BusRecorder&) = delete;

  /// The truth of a simulated match as well, which has a domain of its own.
  void add_truth(const bus::Participant& match);

  /// Draws the field for viewers of scenes; once a second, so that every part of a file has it.
  void draw(const FieldModel& field, HostTime now);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace teamsight::recording
