// bus/wire.hpp: each message in its wire form, and the way there and back. For bus/ and its tests.
//
// One pair per message: `to_wire` fills a WireSample, whose sequences lie in arrays of its own and
// are lent to the write; `from_wire` checks every field, then converts. What breaks a rule is
// refused on both sides by the same check, and never repaired. Rounding is not repair: floats,
// percents and millimetres are as exact as their types, an age beyond its type reads "or older".
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <teamsight.h>

#include "bus/messages.hpp"
#include "bus/reject.hpp"
#include "geometry/result.hpp"

namespace teamsight::bus {

/// The wire form of one message: `Type` is generated, `Storage` holds what its sequences point to.
template <class Message>
struct WireForm;

/// A wire sample together with the storage of its sequences. Lives as long as its writer; not
/// copied, because it points into itself.
template <class Message>
struct WireSample {
  WireSample() = default;
  WireSample(const WireSample&) = delete;
  WireSample& operator=(const WireSample&) = delete;
  ~WireSample() = default;

  typename WireForm<Message>::Type sample{};
  typename WireForm<Message>::Storage storage{};
};

struct NoStorage {};

template <>
struct WireForm<RobotState> {
  using Type = teamsight_v1_RobotState;
  using Storage = NoStorage;
};

template <>
struct WireForm<Sightings> {
  using Type = teamsight_v1_Sightings;

  struct Storage {
    std::array<teamsight_v1_BallRay, kMaxBallRays> balls;
    std::array<teamsight_v1_ObstacleSighting, kMaxObstacleSightings> obstacles;
  };
};

template <>
struct WireForm<VirtualSensors> {
  using Type = teamsight_v1_VirtualSensors;
  using Storage = std::array<teamsight_v1_SensorReading, 24>;
};

template <>
struct WireForm<Odometry> {
  using Type = teamsight_v1_Odometry;
  using Storage = NoStorage;
};

template <>
struct WireForm<WorldModel> {
  using Type = teamsight_v1_WorldModel;

  struct Storage {
    std::array<teamsight_v1_WorldBall, kMaxWorldBalls> balls;
    std::array<teamsight_v1_WorldTeammate, kMaxWorldTeammates> teammates;
    std::array<teamsight_v1_WorldObstacle, kMaxWorldObstacles> obstacles;
  };
};

template <>
struct WireForm<Explanation> {
  using Type = teamsight_v1_Explanation;

  struct Storage {
    std::array<teamsight_v1_ExplainedTrack, 14> tracks;
    std::array<teamsight_v1_ExplainedRobot, 16> robots;
  };
};

template <>
struct WireForm<ClockProbe> {
  using Type = teamsight_v1_ClockProbe;
  using Storage = NoStorage;
};

template <>
struct WireForm<ClockEcho> {
  using Type = teamsight_v1_ClockEcho;
  using Storage = std::array<teamsight_v1_ClockReply, 16>;
};

template <>
struct WireForm<GameState> {
  using Type = teamsight_v1_GameState;
  using Storage = NoStorage;
};

template <>
struct WireForm<Command> {
  using Type = teamsight_v1_Command;
  using Storage = NoStorage;
};

template <>
struct WireForm<Diagnostics> {
  using Type = teamsight_v1_Diagnostics;
  using Storage = std::array<teamsight_v1_Counter, 18>;
};

template <>
struct WireForm<LinePoints> {
  using Type = teamsight_v1_LinePoints;
  using Storage = std::array<teamsight_v1_LinePoint, 200>;
};

template <>
struct WireForm<Thumbnail> {
  using Type = teamsight_v1_Thumbnail;
  using Storage = std::vector<std::uint8_t>;
};

template <>
struct WireForm<Truth> {
  using Type = teamsight_v1_Truth;
  using Storage = std::array<teamsight_v1_TrueRobot, 20>;
};

/// The generated description of the type, for dds_create_topic.
template <class Message>
[[nodiscard]] const dds_topic_descriptor_t& topic_descriptor() noexcept;

/// Fills `out`; valid until the next call with the same `out`.
///
/// @return nothing if `out` may be written; else the first rule that `message` breaks
template <class Message>
[[nodiscard]] std::optional<Reject> to_wire(const Message& message, WireSample<Message>& out);

/// @param wire  as the library decoded it: its sequences may be of any length and its strings
///              without an end
/// @return the message, every promise of its fields kept; else the first broken rule
template <class Message>
[[nodiscard]] Result<Message, Reject> from_wire(const typename WireForm<Message>::Type& wire);

}  // namespace teamsight::bus
