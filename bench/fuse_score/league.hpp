// bench/fuse_score/league.hpp: a real game as the league's referee box kept it: one team's
// obstacles, as said and as fused, beside the other team's own postures.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "bench/fuse_score/run.hpp"
#include "geometry/frames.hpp"
#include "geometry/identity.hpp"
#include "geometry/pose.hpp"

namespace teamsight::score {

struct LeagueRobot {
  RobotId robot{kNobody};
  Pose<Field, Robot> X_FR;  ///< in its own team's F
  bool plays{false};        ///< on the field, and not waiting for its turn
};

struct LeagueObstacle {
  Point<Field> p_FO;          ///< centre, in the reporting team's F; m
  RobotId reporter{kNobody};  ///< nobody: the team says it, without saying who saw it
};

/// One world state of one team.
struct LeagueRecord {
  std::int64_t arrival_ms{0};  ///< at the box, by its clock
  std::int64_t age_ms{0};      ///< of what it tells, as the team says
  bool is_in_order{true};      ///< it arrived after all before it; only then is it fused
  std::vector<LeagueRobot> robots;
  std::vector<LeagueObstacle> obstacles;
};

/// One team's world states, by arrival.
struct LeagueTeam {
  std::string name;
  std::vector<LeagueRecord> records;
  std::map<std::string, std::uint64_t> dropped;  ///< by reason
  std::uint64_t read{0};                         ///< records in the file
  std::uint64_t gaps{0};                         ///< of over a second without a record
};

/// When the ball was in play, by the box's clock; ms.
struct LeagueSpan {
  std::int64_t from_ms{0};
  std::int64_t to_ms{0};
};

/// How far the obstacles lie from the nearest of the other team's postures, whoever it is.
struct LeagueScore {
  std::string estimator;
  ErrorTally nearest;       ///< any posture of the other team, waiting robots too
  ObstacleTally obstacles;  ///< against the robots that play; empty for what is not a set
  std::map<std::string, std::uint64_t> counts;  ///< of fusion's frames and robots, by reason
};

/// What became of one team's world states.
struct LeagueResult {
  std::vector<LeagueScore> scores;
  std::map<std::string, std::uint64_t> counts;  ///< of looks, and of those left out
};

/// The field of that game: 18 x 12 m, and a metre around it.
[[nodiscard]] FieldModel league_field();

/// Whether a place lies within the lines.
[[nodiscard]] bool is_within_lines(const Point<Field>& p_F);

/// One team's record as what each of its playing robots saw.
///
/// Obstacles beyond the lines are left out. A list that says no reporter goes to the robot nearest
/// to each obstacle. Positions are taken as centres, the teams' uncertainties (which they do not
/// say) as this project's own perception has been measured to be; see fusion/README.md.
[[nodiscard]] std::vector<fusion::Observation> league_frames(const LeagueRecord& record,
                                                             std::int64_t start_ms,
                                                             std::uint32_t sequence);

/// Scores what `own` says against where `other` says that it stands, while in play.
[[nodiscard]] LeagueResult run_league(const LeagueTeam& own,
                                      const LeagueTeam& other,
                                      const std::vector<LeagueSpan>& spans);

}  // namespace teamsight::score
