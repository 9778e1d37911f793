// agent/translate.hpp: what one frame said, as the topics say it.
#pragma once

#include "bus/messages.hpp"
#include "geometry/identity.hpp"
#include "geometry/time.hpp"
#include "vision/perception.hpp"

namespace teamsight::agent {

/// Names and times of a sample that is about to be written.
struct Stamps {
  ObservationId id;
  HostTime exposure{};
  HostTime published{};
};

[[nodiscard]] bus::Sightings sightings_of(const vision::FrameObservation& seen,
                                          const Stamps& stamps);

/// The line points; every second or third of them if there are more than a sample holds.
[[nodiscard]] bus::LinePoints line_points_of(const vision::FrameObservation& seen,
                                             const Stamps& stamps);

/// The virtual sensors; at most 24 of them, as a camera file allows.
[[nodiscard]] bus::VirtualSensors sensors_of(const vision::FrameObservation& seen,
                                             const Stamps& stamps);

/// Whether a ball is seen that is more probably one than not.
[[nodiscard]] bool sees_ball(const vision::FrameObservation& seen);

}  // namespace teamsight::agent
