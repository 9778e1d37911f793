// bench/mrclam/score.hpp: what the team makes of real robots' postures, against the truth.
#pragma once

#include <array>
#include <optional>

#include "bench/fuse_score/tally.hpp"
#include "bench/mrclam/landmark_filter.hpp"
#include "bench/mrclam/robot_logs.hpp"
#include "geometry/identity.hpp"

namespace teamsight::mrclam {

/// One robot's posture against motion capture, ten times a second.
struct PostureScore {
  score::ErrorTally alone;          ///< m, as its own filter says
  score::ErrorTally team;           ///< m, as the world model says
  score::ErrorTally heading_alone;  ///< rad
  score::ErrorTally heading_team;   ///< rad
  score::MeanTally nees_alone;      ///< per degree of freedom
  score::MeanTally nees_team;
  int quarantined{0};  ///< moments at which the team did not believe it
};

using PostureScores = std::array<PostureScore, kRobots>;

/// Runs every robot's own filter, hands its posture and the robots that it sees, without their
/// names, to fusion, and compares.
///
/// @param blind  a robot that sees no landmarks after the first ten seconds, if any
[[nodiscard]] PostureScores score_postures(const RobotLogs& logs, std::optional<RobotId> blind);

}  // namespace teamsight::mrclam
