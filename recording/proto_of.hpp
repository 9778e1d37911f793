// recording/proto_of.hpp: which protobuf message stands for which value.
#pragma once

#include "bus/messages.hpp"
#include "geometry/world_model.hpp"
#include "recording.pb.h"

namespace teamsight::recording {

/// `ProtoOf<bus::RobotState>::Type` is v1::RobotState, and so on for every topic.
template <class Message>
struct ProtoOf;

template <>
struct ProtoOf<bus::RobotState> {
  using Type = v1::RobotState;
};

template <>
struct ProtoOf<bus::Sightings> {
  using Type = v1::Sightings;
};

template <>
struct ProtoOf<bus::VirtualSensors> {
  using Type = v1::VirtualSensors;
};

template <>
struct ProtoOf<bus::Odometry> {
  using Type = v1::Odometry;
};

template <>
struct ProtoOf<WorldModel> {
  using Type = v1::WorldModel;
};

template <>
struct ProtoOf<bus::Explanation> {
  using Type = v1::Explanation;
};

template <>
struct ProtoOf<bus::ClockProbe> {
  using Type = v1::ClockProbe;
};

template <>
struct ProtoOf<bus::ClockEcho> {
  using Type = v1::ClockEcho;
};

template <>
struct ProtoOf<bus::GameState> {
  using Type = v1::GameState;
};

template <>
struct ProtoOf<bus::Command> {
  using Type = v1::Command;
};

template <>
struct ProtoOf<bus::Diagnostics> {
  using Type = v1::Diagnostics;
};

template <>
struct ProtoOf<bus::LinePoints> {
  using Type = v1::LinePoints;
};

template <>
struct ProtoOf<bus::Thumbnail> {
  using Type = v1::Thumbnail;
};

template <>
struct ProtoOf<bus::Truth> {
  using Type = v1::Truth;
};

}  // namespace teamsight::recording
