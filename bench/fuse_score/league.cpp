// bench/fuse_score/league.cpp: see bench/fuse_score/league.hpp.
#include "bench/fuse_score/league.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "bench/peers/obstacle_rules.hpp"
#include "fusion/fusion.hpp"

namespace teamsight::score {
namespace {

using Places = std::vector<Eigen::Vector2d>;

constexpr std::int64_t kTickMs = 100;
constexpr std::int64_t kTruthMs = 200;  // no posture nearer in time: nothing to compare with
constexpr std::int64_t kListMs = 1000;  // a list that is older says nothing any more
constexpr double kRobotRadius = 0.25;   // m
constexpr double kMate = 0.5;  // m around a mate's own posture, as the peers' rules have it
// That a robot right beside a thing names it, where silence is no evidence: as bench/mrclam has it.
constexpr double kDetectionOfLists = 0.05;
constexpr double kSigmaPosture = 0.10;  // m, per axis
constexpr double kSigmaHeading = 0.05;  // rad
constexpr Duration kSigmaExposure = std::chrono::milliseconds(50);

/// Unix time as fusion's host time; no stamp is 0 or less.
HostTime host_time(std::int64_t ms, std::int64_t start_ms) {
  return HostTime{std::chrono::milliseconds(ms - start_ms + 10'000)};
}

double seconds(HostTime time) {
  return std::chrono::duration<double>(time.time_since_epoch()).count();
}

/// As bench/play draws it: 3 cm + 1.2 cm per square metre along, 1.5 cm + 0.6 cm per metre across.
ObstacleSighting sighting_of(const Point<Field>& p_FO, const Pose<Field, Robot>& X_FR) {
  const Eigen::Vector2d centre_R = (X_FR.inverse() * p_FO).vector();
  const double range = std::max(0.05, centre_R.norm() - kRobotRadius);
  const Eigen::Vector2d along = centre_R.normalized();
  const Eigen::Vector2d across(-along.y(), along.x());
  const double sigma_along = 0.03 + 0.012 * range * range;
  const double sigma_across = 0.015 + 0.006 * range;
  ObstacleSighting sighting;
  sighting.p_RO = Point<Robot>::from(range * along);
  sighting.cov_R = sigma_along * sigma_along * along * along.transpose() +
                   sigma_across * sigma_across * across * across.transpose();
  sighting.width = 2.0 * kRobotRadius;
  sighting.confidence = 0.9;
  return sighting;
}

fusion::Observation empty_frame(const LeagueRobot& robot,
                                HostTime exposure,
                                std::uint32_t sequence) {
  fusion::Observation frame;
  frame.id = {robot.robot, 1, sequence};
  frame.exposure = exposure;
  frame.sigma_exposure = kSigmaExposure;
  frame.posture.status = PostureStatus::kOk;
  frame.posture.half_log_odds = 6.0;
  frame.posture.X_FR = robot.X_FR;
  const double p = kSigmaPosture * kSigmaPosture;
  frame.posture.cov = Eigen::Vector3d(p, p, kSigmaHeading * kSigmaHeading).asDiagonal();
  frame.posture.inlier_ratio = 0.9;
  frame.posture.line_points = 80;
  return frame;
}

/// Whose frame the obstacle belongs to; none if its reporter does not play.
fusion::Observation* frame_of(const LeagueObstacle& obstacle,
                              std::vector<fusion::Observation>& frames) {
  fusion::Observation* best = nullptr;
  double nearest = std::numeric_limits<double>::max();
  for (fusion::Observation& frame : frames) {
    if (obstacle.reporter != kNobody && frame.id.robot != obstacle.reporter) continue;
    const double distance = (frame.posture.X_FR.origin().vector() - obstacle.p_FO.vector()).norm();
    if (distance >= nearest) continue;
    nearest = distance;
    best = &frame;
  }
  return best;
}

/// The record nearest in time to `ms`; nothing if none is near.
const LeagueRecord* record_at(const LeagueTeam& team, std::int64_t ms) {
  const auto after = std::lower_bound(
      team.records.begin(), team.records.end(), ms, [](const LeagueRecord& record, auto at) {
        return record.arrival_ms < at;
      });
  const LeagueRecord* best = nullptr;
  const auto consider = [&](const LeagueRecord& record) {
    const std::int64_t gap = std::abs(record.arrival_ms - ms);
    if (gap > kTruthMs || (best != nullptr && gap >= std::abs(best->arrival_ms - ms))) return;
    best = &record;
  };
  if (after != team.records.begin()) consider(*(after - 1));
  if (after != team.records.end()) consider(*after);
  return best;
}

bool is_in_play(std::int64_t ms, const std::vector<LeagueSpan>& spans) {
  return std::any_of(spans.begin(), spans.end(), [&](const LeagueSpan& span) {
    return ms >= span.from_ms && ms <= span.to_ms;
  });
}

const char* name_of(Quarantine quarantine) {
  switch (quarantine) {
    case Quarantine::kNone:
      break;
    case Quarantine::kNoPosture:
      return "no_posture";
    case Quarantine::kBiased:
      return "biased";
    case Quarantine::kMirrored:
      return "mirrored";
    case Quarantine::kKidnapped:
      return "kidnapped";
    case Quarantine::kBabbling:
      return "babbling";
    case Quarantine::kDuplicateId:
      return "duplicate_id";
  }
  return "trusted";
}

/// What the other team says of itself, as this team sees the field: turned by half a turn.
struct Truth {
  Places places;
  std::vector<bool> plays;

  explicit Truth(const LeagueRecord& record) {
    for (const LeagueRobot& robot : record.robots) {
      places.push_back(-robot.X_FR.origin().vector());
      plays.push_back(robot.plays);
    }
  }
};

void add_nearest(const Places& estimates, const Truth& truth, ErrorTally& tally) {
  for (const Eigen::Vector2d& estimate : estimates) {
    double nearest = std::numeric_limits<double>::max();
    for (const Eigen::Vector2d& place : truth.places)
      nearest = std::min(nearest, (place - estimate).squaredNorm());
    if (!truth.places.empty()) tally.add(nearest);
  }
}

Places places_of(const std::vector<peers::ObstacleGuess>& guesses) {
  Places places;
  for (const peers::ObstacleGuess& guess : guesses) places.push_back(guess.p_F);
  return places;
}

/// The newest list as it came, without what stands where a mate says that it is.
Places strangers(const LeagueRecord& record) {
  Places places;
  for (const LeagueObstacle& obstacle : record.obstacles) {
    const Eigen::Vector2d p_F = obstacle.p_FO.vector();
    const bool is_mate =
        std::any_of(record.robots.begin(), record.robots.end(), [&](const LeagueRobot& robot) {
          return robot.plays && (robot.X_FR.origin().vector() - p_F).norm() < kMate;
        });
    if (!is_mate && is_within_lines(obstacle.p_FO)) places.push_back(p_F);
  }
  return places;
}

/// Fusion as the service runs it while it leads: names stay as they were said.
class FusedGame {
 public:
  explicit FusedGame(const fusion::Parameters& parameters) : fusion_(parameters, league_field()) {}

  void take(const fusion::Observation& frame, HostTime now) {
    const fusion::Intake intake = fusion_.insert(frame, now);
    ++counts_[intake == fusion::Intake::kAccepted ? "frames" : "frames_refused"];
  }

  Places obstacles(HostTime now) {
    fusion_.adopt_ids(world_, last_);
    world_ = fusion_.world_at(now);
    last_ = now;
    for (const WorldTeammate& mate : world_.teammates)
      ++counts_[std::string("robot_ticks_") + name_of(mate.quarantine)];
    Places places;
    for (const WorldObstacle& obstacle : world_.obstacles) places.push_back(obstacle.p_FO.vector());
    return places;
  }

  /// What became of the frames, by reason.
  [[nodiscard]] std::map<std::string, std::uint64_t> counts() const {
    auto counts = counts_;
    for (const fusion::RobotReport& robot : fusion_.report_at(last_).robots) {
      counts["sightings_used"] += robot.accepted;
      counts["sightings_fitting_nothing"] += robot.rejected_gate;
    }
    return counts;
  }

 private:
  fusion::Fusion fusion_;
  WorldModel world_;
  HostTime last_{};
  std::map<std::string, std::uint64_t> counts_;
};

fusion::Parameters parameters() {
  fusion::Parameters parameters;
  parameters.robot_radius = kRobotRadius;
  return parameters;
}

fusion::Parameters parameters_of_lists() {
  fusion::Parameters of_lists = parameters();
  of_lists.obstacle.detection_probability = kDetectionOfLists;
  return of_lists;
}

/// Places in the list of scores; kNames stand in the same order.
enum Estimator : std::size_t {
  kAsRecorded,
  kWithinLines,
  kNewestList,
  kFused,
  kFusedLists,
  kInformationFilter,
  kTwoWitnesses
};

constexpr std::array<const char*, 7> kNames{"as-recorded",
                                            "recorded-within-lines",
                                            "newest-list",
                                            "teamsight",
                                            "teamsight-silence-says-nothing",
                                            "information-filter",
                                            "two-witnesses"};

/// One team's game, tick by tick.
class LeagueRun {
 public:
  LeagueRun(const LeagueTeam& own, const LeagueTeam& other, const std::vector<LeagueSpan>& spans)
      : own_(own),
        other_(other),
        spans_(spans),
        fused_(parameters()),
        fused_lists_(parameters_of_lists()) {
    for (const char* name : kNames) result_.scores.push_back({name, {}, {}, {}});
  }

  LeagueResult run() {
    if (!own_.records.empty()) start_ms_ = own_.records.front().arrival_ms;
    for (const LeagueSpan& span : spans_) {
      for (std::int64_t ms = span.from_ms; ms <= span.to_ms; ms += kTickMs) {
        deliver_until(ms);
        tick(ms);
      }
    }
    result_.scores[kFused].counts = fused_.counts();
    result_.scores[kFusedLists].counts = fused_lists_.counts();
    return std::move(result_);
  }

 private:
  void deliver_until(std::int64_t ms) {
    for (; next_ < own_.records.size() && own_.records[next_].arrival_ms <= ms; ++next_) {
      const LeagueRecord& record = own_.records[next_];
      score_recorded(record);
      if (!record.is_in_order) continue;
      newest_ = &record;
      deliver(record);
    }
  }

  /// Every record and every place in it, whatever is wrong with them.
  void score_recorded(const LeagueRecord& record) {
    if (!is_in_play(record.arrival_ms, spans_)) return;
    const LeagueRecord* truth = record_at(other_, record.arrival_ms);
    if (truth == nullptr) return;
    Places places;
    Places within_lines;
    for (const LeagueObstacle& obstacle : record.obstacles) {
      places.push_back(obstacle.p_FO.vector());
      if (is_within_lines(obstacle.p_FO)) within_lines.push_back(places.back());
    }
    add_nearest(places, Truth(*truth), result_.scores[kAsRecorded].nearest);
    add_nearest(within_lines, Truth(*truth), result_.scores[kWithinLines].nearest);
  }

  void deliver(const LeagueRecord& record) {
    const HostTime now = host_time(record.arrival_ms, start_ms_);
    for (const auto& frame : league_frames(record, start_ms_, ++sequence_)) {
      fused_.take(frame, now);
      fused_lists_.take(frame, now);
      // The peers' rules know no age at which a frame is refused.
      filter_.take(frame, seconds(frame.exposure), kRobotRadius);
      witnesses_.take(frame, seconds(frame.exposure), kRobotRadius);
    }
  }

  void tick(std::int64_t ms) {
    const LeagueRecord* record = record_at(other_, ms);
    if (record == nullptr) {
      ++result_.counts["ticks_without_truth"];
      return;
    }
    ++result_.counts["ticks"];
    const Truth truth(*record);
    const HostTime now = host_time(ms, start_ms_);
    if (newest_ != nullptr && ms - newest_->arrival_ms <= kListMs) {
      score(strangers(*newest_), truth, kNewestList);
    } else {
      score({}, truth, kNewestList);
    }
    score(fused_.obstacles(now), truth, kFused);
    score(fused_lists_.obstacles(now), truth, kFusedLists);
    score(places_of(filter_.obstacles(seconds(now))), truth, kInformationFilter);
    score(places_of(witnesses_.obstacles(seconds(now))), truth, kTwoWitnesses);
  }

  void score(const Places& estimates, const Truth& truth, Estimator estimator) {
    LeagueScore& score = result_.scores[estimator];
    add_nearest(estimates, truth, score.nearest);
    count_gospa(match_gospa(truth.places, truth.plays, estimates), score.obstacles);
  }

  const LeagueTeam& own_;
  const LeagueTeam& other_;
  const std::vector<LeagueSpan>& spans_;
  FusedGame fused_;
  FusedGame fused_lists_;
  peers::InformationFilterObstacles filter_;
  peers::TwoWitnessObstacles witnesses_;
  const LeagueRecord* newest_{nullptr};
  std::size_t next_{0};
  std::uint32_t sequence_{0};
  std::int64_t start_ms_{0};
  LeagueResult result_;
};

}  // namespace

FieldModel league_field() {
  FieldModel field;
  field.length = 18.0;
  field.width = 12.0;
  field.surround = 1.0;
  return field;
}

bool is_within_lines(const Point<Field>& p_F) {
  const FieldModel field = league_field();
  return std::abs(p_F.x) <= 0.5 * field.length && std::abs(p_F.y) <= 0.5 * field.width;
}

std::vector<fusion::Observation> league_frames(const LeagueRecord& record,
                                               std::int64_t start_ms,
                                               std::uint32_t sequence) {
  const HostTime exposure = host_time(record.arrival_ms - record.age_ms, start_ms);
  std::vector<fusion::Observation> frames;
  for (const LeagueRobot& robot : record.robots) {
    if (robot.plays) frames.push_back(empty_frame(robot, exposure, sequence));
  }
  for (const LeagueObstacle& obstacle : record.obstacles) {
    if (!is_within_lines(obstacle.p_FO)) continue;
    fusion::Observation* frame = frame_of(obstacle, frames);
    if (frame == nullptr || frame->obstacles.size() == kMaxObstacleSightings) continue;
    frame->obstacles.push_back(sighting_of(obstacle.p_FO, frame->posture.X_FR));
  }
  return frames;
}

LeagueResult run_league(const LeagueTeam& own,
                        const LeagueTeam& other,
                        const std::vector<LeagueSpan>& spans) {
  return LeagueRun(own, other, spans).run();
}

}  // namespace teamsight::score
