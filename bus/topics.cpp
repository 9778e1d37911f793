// bus/topics.cpp: the rows.
#include "bus/topics.hpp"

namespace teamsight::bus {
namespace {

constexpr bool kLease = true;
constexpr bool kNoLease = false;
constexpr Duration kForever{0};
// A robot that starts again must not carry out what it was told before; a sender repeats a command
// until it is acknowledged.
constexpr Duration kCommandLifespan = std::chrono::seconds(5);

// clang-format off
constexpr std::array<TopicProfile, kTopics> kRows{{
  {"teamsight/v1/RobotState",     Delivery::kState,  1, kLease,   kForever,         false},
  {"teamsight/v1/Sightings",      Delivery::kState,  8, kLease,   kForever,         false},
  {"teamsight/v1/VirtualSensors", Delivery::kState,  1, kLease,   kForever,         false},
  {"teamsight/v1/Odometry",       Delivery::kState,  1, kLease,   kForever,         false},
  {"teamsight/v1/WorldModel",     Delivery::kState,  1, kLease,   kForever,         true},
  {"teamsight/v1/Explanation",    Delivery::kState,  1, kNoLease, kForever,         false},
  {"teamsight/v1/ClockProbe",     Delivery::kState,  1, kNoLease, kForever,         false},
  {"teamsight/v1/ClockEcho",      Delivery::kState,  1, kNoLease, kForever,         false},
  {"teamsight/v1/GameState",      Delivery::kEvent,  1, kNoLease, kForever,         false},
  {"teamsight/v1/Command",        Delivery::kEvent, 16, kNoLease, kCommandLifespan, false},
  {"teamsight/v1/Diagnostics",    Delivery::kState,  1, kNoLease, kForever,         false},
  {"teamsight/v1/LinePoints",     Delivery::kState,  1, kNoLease, kForever,         false},
  {"teamsight/v1/Thumbnail",      Delivery::kState,  1, kNoLease, kForever,         false},
  {"teamsight/v1/Truth",          Delivery::kState,  1, kLease,   kForever,         false},
}};
// clang-format on

}  // namespace

const std::array<TopicProfile, kTopics>& all_topics() noexcept {
  return kRows;
}

template <>
const TopicProfile& topic_profile<RobotState>() noexcept {
  return kRows[0];
}

template <>
const TopicProfile& topic_profile<Sightings>() noexcept {
  return kRows[1];
}

template <>
const TopicProfile& topic_profile<VirtualSensors>() noexcept {
  return kRows[2];
}

template <>
const TopicProfile& topic_profile<Odometry>() noexcept {
  return kRows[3];
}

template <>
const TopicProfile& topic_profile<WorldModel>() noexcept {
  return kRows[4];
}

template <>
const TopicProfile& topic_profile<Explanation>() noexcept {
  return kRows[5];
}

template <>
const TopicProfile& topic_profile<ClockProbe>() noexcept {
  return kRows[6];
}

template <>
const TopicProfile& topic_profile<ClockEcho>() noexcept {
  return kRows[7];
}

template <>
const TopicProfile& topic_profile<GameState>() noexcept {
  return kRows[8];
}

template <>
const TopicProfile& topic_profile<Command>() noexcept {
  return kRows[9];
}

template <>
const TopicProfile& topic_profile<Diagnostics>() noexcept {
  return kRows[10];
}

template <>
const TopicProfile& topic_profile<LinePoints>() noexcept {
  return kRows[11];
}

template <>
const TopicProfile& topic_profile<Thumbnail>() noexcept {
  return kRows[12];
}

template <>
const TopicProfile& topic_profile<Truth>() noexcept {
  return kRows[13];
}

}  // namespace teamsight::bus
