// tools/detection_report.hpp: what was seen in images against their labels, as JSON.
#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "tools/detection_score.hpp"
#include "vision/perception.hpp"

namespace teamsight::tools {

/// All kinds of things in one set of images.
struct Score {
  Tally balls;
  Tally robots;
  Tally people;

  Score& operator+=(const Score& other);
};

/// Where a frame shows balls.
[[nodiscard]] std::vector<Detection> ball_places(const vision::FrameObservation& seen);

/// Where a frame shows the feet of robots; legs are none.
[[nodiscard]] std::vector<Detection> robot_places(const vision::FrameObservation& seen);

/// Where a frame shows somebody's legs.
[[nodiscard]] std::vector<Detection> leg_places(const vision::FrameObservation& seen);

[[nodiscard]] Score score_of(const ImageLabels& labels, const vision::FrameObservation& seen);

/// Counts, recall and precision with their 95 % intervals, and the median error in pixels, of
/// balls, robots and people; a false person is legs on the carpet where nobody stands.
[[nodiscard]] nlohmann::ordered_json report_of(const Score& score);

}  // namespace teamsight::tools
