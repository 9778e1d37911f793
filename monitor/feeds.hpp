// monitor/feeds.hpp: the topics that the station listens to, who hears them, and what it says.
#pragma once

#include "bus/clock.hpp"
#include "bus/loop.hpp"
#include "bus/other_versions.hpp"
#include "bus/participant.hpp"
#include "bus/reader.hpp"
#include "bus/writer.hpp"
#include "monitor/order_desk.hpp"
#include "monitor/station.hpp"
#include "monitor/what_if.hpp"
#include "process/hearing.hpp"

namespace teamsight::monitor {

/// Every topic that the station listens to.
struct Feeds {
  explicit Feeds(const bus::Participant& participant)
      : states(participant),
        sightings(participant),
        worlds(participant),
        explanations(participant),
        diagnostics(participant),
        line_points(participant),
        thumbnails(participant),
        sensors(participant),
        echoes(participant),
        others(participant) {}

  void count(Station& station) const {
    station.count("RobotState", states.counters());
    station.count("Sightings", sightings.counters());
    station.count("WorldModel", worlds.counters());
    station.count("Explanation", explanations.counters());
    station.count("Diagnostics", diagnostics.counters());
    station.count("LinePoints", line_points.counters());
    station.count("Thumbnail", thumbnails.counters());
    station.count("VirtualSensors", sensors.counters());
    station.count("ClockEcho", echoes.counters());
  }

  /// Those whose writers speak all the time, or beside another topic.
  void watch(process::Hearing& ear) const {
    ear.watch(states);
    ear.watch(sightings);
    ear.watch(worlds);
    ear.watch_beside(explanations, worlds);
    ear.watch_always(diagnostics, states, worlds);
  }

  bus::Reader<bus::RobotState> states;
  bus::Reader<bus::Sightings> sightings;
  bus::Reader<WorldModel> worlds;
  bus::Reader<bus::Explanation> explanations;
  bus::Reader<bus::Diagnostics> diagnostics;
  bus::Reader<bus::LinePoints> line_points;
  bus::Reader<bus::Thumbnail> thumbnails;
  bus::Reader<bus::VirtualSensors> sensors;
  bus::Reader<bus::ClockEcho> echoes;
  bus::OtherVersions others;
};

/// What the station itself says, beside the referee's game.
struct Words {
  explicit Words(const bus::Participant& participant)
      : diagnostics(participant),
        commands(participant),
        probes(participant) {}

  bus::Writer<bus::Diagnostics> diagnostics;
  bus::Writer<bus::Command> commands;
  bus::Writer<bus::ClockProbe> probes;
};

/// Hands every new sample to each of those who listen.
template <class Message, class... Listener>
void take(bus::Reader<Message>& reader, Listener&... listeners) {
  reader.take(bus::host_now(),
              [&](const bus::Sample<Message>& sample) { (listeners.hear(sample), ...); });
}

/// The same whenever there are some; all must outlive the loop's run.
template <class Message, class... Listener>
void pass_on(bus::Loop& loop, bus::Reader<Message>& reader, Listener&... listeners) {
  loop.on_readable(reader.event_fd(), [&]() { take(reader, listeners...); });
}

/// Every topic but the worlds, which set the pace of the updates.
inline void pass_on(
    bus::Loop& loop, Feeds& feeds, Station& station, OrderDesk& desk, WhatIf& what_if) {
  loop.on_readable(feeds.states.event_fd(), [&]() {
    feeds.states.take(bus::host_now(), [&](const bus::Sample<bus::RobotState>& sample) {
      station.hear(sample);
      if (!sample.message) return;
      desk.hear(sample.message->id.robot, sample.message->command_acknowledged);
    });
  });
  pass_on(loop, feeds.sightings, station, what_if);
  loop.on_readable(feeds.explanations.event_fd(), [&]() {
    feeds.explanations.take(bus::host_now(), [&](const bus::Sample<bus::Explanation>& sample) {
      station.hear(sample);
      what_if.hear(sample);
      if (sample.message) desk.hear(sample.message->hint);
    });
  });
  pass_on(loop, feeds.diagnostics, station);
  pass_on(loop, feeds.line_points, station);
  pass_on(loop, feeds.thumbnails, station);
  pass_on(loop, feeds.sensors, station);
  pass_on(loop, feeds.echoes, station);
}

}  // namespace teamsight::monitor
