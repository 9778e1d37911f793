// monitor/update_to_proto.hpp: what the coach station shows, as the page gets it.
#pragma once

#include "geometry/field_model.hpp"
#include "monitor/update.hpp"

namespace teamsight::v1 {
class MonitorField;
class MonitorUpdate;
}  // namespace teamsight::v1

namespace teamsight::monitor {

/// The field as the page draws it.
void to_proto(const FieldModel& from, v1::MonitorField& to);

/// Everything but events and pictures, which travel on their own: a state that is skipped must not
/// take them along.
void to_proto(const Update& from, v1::MonitorUpdate& to);

/// The events alone.
void events_to_proto(const Update& from, v1::MonitorUpdate& to);

/// The pictures alone.
void thumbnails_to_proto(const Update& from, v1::MonitorUpdate& to);

}  // namespace teamsight::monitor
