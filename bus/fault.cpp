// bus/fault.cpp: see bus/fault.hpp.
#include "bus/fault.hpp"

#include "bus/wire.hpp"

namespace teamsight::bus {

template <class Message>
std::optional<Reject> fault_of(const Message& message) {
  WireSample<Message> sample;
  return to_wire(message, sample);
}

template std::optional<Reject> fault_of(const RobotState&);
template std::optional<Reject> fault_of(const Sightings&);
template std::optional<Reject> fault_of(const VirtualSensors&);
template std::optional<Reject> fault_of(const Odometry&);
template std::optional<Reject> fault_of(const WorldModel&);
template std::optional<Reject> fault_of(const Explanation&);
template std::optional<Reject> fault_of(const ClockProbe&);
template std::optional<Reject> fault_of(const ClockEcho&);
template std::optional<Reject> fault_of(const GameState&);
template std::optional<Reject> fault_of(const Command&);
template std::optional<Reject> fault_of(const Diagnostics&);
template std::optional<Reject> fault_of(const LinePoints&);
template std::optional<Reject> fault_of(const Thumbnail&);
template std::optional<Reject> fault_of(const Truth&);

}  // namespace teamsight::bus
