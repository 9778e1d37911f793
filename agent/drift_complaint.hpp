// agent/drift_complaint.hpp: a calibration that no longer holds, in words.
#pragma once

#include <string>

#include "vision/line_drift.hpp"

namespace teamsight::agent {

/// What the coach station shows: by how much, what of size and place has changed, and what to do.
///
/// @return at most 95 characters
[[nodiscard]] std::string drift_complaint(const vision::DriftReport& drift);

}  // namespace teamsight::agent
