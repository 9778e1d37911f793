// tests/monitor/station_samples.hpp: what a station hears, made up by value.
#pragma once

#include <chrono>
#include <cstdint>

#include "monitor/station.hpp"

namespace teamsight::monitor {

using std::chrono::milliseconds;
using std::chrono::seconds;

inline const HostTime kStart{seconds(100)};

template <class Message>
bus::Sample<Message> sample_of(const Message& message, HostTime received, std::uint64_t instance) {
  bus::Sample<Message> sample;
  sample.message = message;
  sample.instance = instance;
  sample.received = received;
  return sample;
}

/// One frame of a robot, exposed 30 ms and published 10 ms before it arrived.
inline void hear_frame(
    Station& station, RobotId robot, std::uint32_t sequence, HostTime at, std::uint32_t boot = 1) {
  bus::RobotState state;
  state.id = {robot, boot, sequence};
  state.exposure = stamp_of(at - milliseconds(30));
  state.published = stamp_of(at - milliseconds(10));
  station.hear(sample_of(state, at, robot));
  bus::Sightings sightings;
  sightings.id = state.id;
  sightings.exposure = state.exposure;
  sightings.published = state.published;
  station.hear(sample_of(sightings, at, robot));
}

inline void hear_world(Station& station,
                       RobotId leader,
                       HostTime at,
                       Quarantine quarantine = Quarantine::kNone) {
  WorldModel world;
  world.id = {leader, 1, 1};
  WorldTeammate mate;
  mate.robot = 1;
  mate.quarantine = quarantine;
  world.teammates.push_back(mate);
  station.hear(sample_of(world, at, 1));
}

inline bus::Sample<bus::RobotState> presence_of(bus::Presence presence,
                                                std::uint64_t instance,
                                                HostTime at) {
  bus::Sample<bus::RobotState> sample;
  sample.presence = presence;
  sample.instance = instance;
  sample.received = at;
  return sample;
}

}  // namespace teamsight::monitor
