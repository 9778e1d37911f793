// recording/to_proto.hpp: every topic's value as the protobuf message of recordings, page and echo.
#pragma once

#include "bus/messages.hpp"
#include "geometry/world_model.hpp"

namespace teamsight::v1 {
class ClockEcho;
class ClockProbe;
class Command;
class Diagnostics;
class ExplainedHint;
class Explanation;
class GameState;
class LinePoints;
class Odometry;
class RobotState;
class Sightings;
class Thumbnail;
class Truth;
class VirtualSensors;
class WorldModel;
}  // namespace teamsight::v1

namespace teamsight::recording {

/// Fill an empty protobuf message from a value. Units and frames are those of the .proto files;
/// numbers are passed on as they are, nothing is repaired or left out.
void to_proto(const bus::RobotState& from, v1::RobotState& to);
void to_proto(const bus::Sightings& from, v1::Sightings& to);
void to_proto(const bus::VirtualSensors& from, v1::VirtualSensors& to);
void to_proto(const bus::Odometry& from, v1::Odometry& to);
void to_proto(const WorldModel& from, v1::WorldModel& to);
void to_proto(const bus::ExplainedHint& from, v1::ExplainedHint& to);
void to_proto(const bus::Explanation& from, v1::Explanation& to);
void to_proto(const bus::ClockProbe& from, v1::ClockProbe& to);
void to_proto(const bus::ClockEcho& from, v1::ClockEcho& to);
void to_proto(const bus::GameState& from, v1::GameState& to);
void to_proto(const bus::Command& from, v1::Command& to);
void to_proto(const bus::Diagnostics& from, v1::Diagnostics& to);
void to_proto(const bus::LinePoints& from, v1::LinePoints& to);
void to_proto(const bus::Thumbnail& from, v1::Thumbnail& to);
void to_proto(const bus::Truth& from, v1::Truth& to);

}  // namespace teamsight::recording
