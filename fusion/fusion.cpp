// fusion/fusion.cpp: see fusion/fusion.hpp.
#include "fusion/fusion.hpp"

#include <algorithm>
#include <tuple>

namespace teamsight::fusion {
namespace {

// 16 robots at 20 Hz for half a second, with room to spare; a babbler cannot make it grow.
constexpr std::size_t kMaxHeld = 192;
// Of one robot: 80 Hz. More is babble, and would push the others' frames out.
constexpr std::size_t kMaxHeldOfOne = 40;
constexpr Duration kBabbleMemory = std::chrono::seconds(2);
// Frames that count as folded behind the newest folded one: more than anybody sends while the lag
// lasts. Without an end one forged number far ahead would refuse a robot until it starts again.
constexpr std::uint32_t kFoldedFrames = 256;

auto sort_key(const Observation& observation) {
  return std::tie(observation.exposure, observation.id);
}

std::size_t index_of(RobotId robot) {
  return static_cast<std::size_t>(robot) - 1U;
}

std::vector<NamedPlace> places_of(const std::vector<WorldBall>& balls) {
  std::vector<NamedPlace> places;
  places.reserve(balls.size());
  for (const WorldBall& ball : balls) {
    places.push_back({ball.track,
                      ball.p_FB.on_floor().vector(),
                      {ball.v_FB.x, ball.v_FB.y},
                      ball.cov_p.topLeftCorner<2, 2>()});
  }
  return places;
}

std::vector<NamedPlace> places_of(const std::vector<WorldObstacle>& obstacles) {
  std::vector<NamedPlace> places;
  places.reserve(obstacles.size());
  for (const WorldObstacle& obstacle : obstacles) {
    places.push_back(
        {obstacle.track, obstacle.p_FO.vector(), obstacle.v_FO.vector(), obstacle.cov_p});
  }
  return places;
}

TrackReport report_of(const TrackBook& book, HostTime now, Duration window) {
  TrackReport report;
  report.supporters = robots_within(book.supported, now, window);
  report.rejected =
      static_cast<RobotMask>(robots_within(book.rejected, now, window) & ~report.supporters);
  report.born_ago = std::max(Duration{0}, now - book.born);
  if (book.hits > 1) report.nis = book.nis_sum / (book.hits - 1.0);
  return report;
}

NamedTracks named(const BallList& balls, HostTime at, const Parameters& parameters) {
  NamedTracks tracks;
  for (const BallTrack& track : balls) {
    const BallMoments moments = moments_at(track, at, parameters.ball_motion);
    tracks.push_back({track.book.key,
                      track.book.is_confirmed,
                      std::max(at, track.book.time),
                      moments.mean.head<2>(),
                      moments.cov.topLeftCorner<2, 2>()});
  }
  return tracks;
}

NamedTracks named(const TrackList& obstacles, HostTime at, const Parameters& parameters) {
  NamedTracks tracks;
  for (const Track& track : obstacles) {
    const PlanarMoments moments = moments_at(track, at, parameters.obstacle);
    tracks.push_back({track.book.key,
                      track.book.is_confirmed,
                      std::max(at, track.book.time),
                      moments.mean.head<2>(),
                      moments.cov.topLeftCorner<2, 2>()});
  }
  return tracks;
}

template <class List>
bool contains(const List& tracks, std::uint32_t key) {
  return std::any_of(
      tracks.begin(), tracks.end(), [key](const auto& track) { return track.book.key == key; });
}

bool is_lost(const KnownObstacles& lost, std::uint32_t key) {
  return std::ranges::any_of(lost, [key](const KnownObstacle& one) { return one.key == key; });
}

}  // namespace

Fusion::Fusion(const Parameters& parameters, const FieldModel& field)
    : setting_{parameters, field} {
  BallMotion& motion = setting_.parameters.ball_motion;
  motion.radius = parameters.ball_radius;
  motion.carpet_centre = field.centre.vector();
  motion.carpet_reach << 0.5 * field.length + field.surround, 0.5 * field.width + field.surround;
  slots_.reserve(kMaxHeld);
  order_.reserve(kMaxHeld);
  spare_.reserve(kMaxHeld);
}

Intake Fusion::insert(const Observation& observation, HostTime now) {
  TEAMSIGHT_EXPECT(robot_bit(observation.id.robot) != 0);
  while (!order_.empty() &&
         slots_[order_.front()].observation.exposure < now - setting_.parameters.lag) {
    fold_front();
  }
  const Intake intake = judge(observation, now);
  count(observation.id.robot, intake, now);
  if (intake != Intake::kAccepted) return intake;
  if (order_.size() == kMaxHeld) fold_front();
  const std::size_t place = place_of(observation);
  put(place, observation);
  take_in_from(place);
  const State& state = head();
  names_.keep_if([&state](std::uint32_t key) {
    return contains(state.balls, key) || contains(state.obstacles, key) || key == state.lost_ball ||
           is_lost(state.lost_obstacles, key);
  });
  return intake;
}

void Fusion::take_hint(const BallHint& hint) {
  TEAMSIGHT_EXPECT(hint.number != 0);
  if (hint.number != hint_.number) hint_ = hint;
}

Intake Fusion::judge(const Observation& observation, HostTime now) const {
  if (observation.exposure > now + setting_.parameters.max_future) return Intake::kFromTheFuture;
  const ObservationId& id = observation.id;
  for (const std::size_t slot : order_) {
    if (slots_[slot].observation.id == id) return Intake::kDuplicate;
  }
  if (held_of(id.robot) >= kMaxHeldOfOne) return Intake::kTooMany;
  const Folded& folded = folded_[index_of(id.robot)];
  const bool is_folded = folded.boot == id.boot && id.sequence <= folded.sequence &&
                         folded.sequence - id.sequence < kFoldedFrames;
  if (is_folded) return Intake::kTooOld;
  if (observation.exposure < now - setting_.parameters.lag) return Intake::kTooOld;
  const bool is_before_checkpoint = sort_key(observation) <= std::tie(folded_exposure_, folded_id_);
  const bool is_pushed_out = order_.size() == kMaxHeld &&
                             sort_key(observation) < sort_key(slots_[order_.front()].observation);
  return is_before_checkpoint || is_pushed_out ? Intake::kTooOld : Intake::kAccepted;
}

std::size_t Fusion::held_of(RobotId robot) const {
  return static_cast<std::size_t>(
      std::count_if(order_.begin(), order_.end(), [&](std::size_t slot) {
        return slots_[slot].observation.id.robot == robot;
      }));
}

bool Fusion::is_babbling(RobotId robot, HostTime now) const {
  return now - babbled_[index_of(robot)] <= kBabbleMemory;
}

void Fusion::count(RobotId robot, Intake intake, HostTime now) {
  if (intake == Intake::kTooMany) {
    babbled_[index_of(robot)] = now;
    ++late_[index_of(robot)];
  }
  if (intake == Intake::kDuplicate) ++duplicate_[index_of(robot)];
  if (intake == Intake::kTooOld || intake == Intake::kFromTheFuture) ++late_[index_of(robot)];
}

void Fusion::fold_front() {
  const std::size_t slot = order_.front();
  const Observation& observation = slots_[slot].observation;
  checkpoint_ = slots_[slot].after;
  folded_exposure_ = observation.exposure;
  folded_id_ = observation.id;
  folded_[index_of(observation.id.robot)] = {observation.id.boot, observation.id.sequence};
  order_.erase(order_.begin());
  spare_.push_back(slot);
}

std::size_t Fusion::place_of(const Observation& observation) const {
  const auto place = std::lower_bound(
      order_.begin(), order_.end(), observation, [this](std::size_t slot, const Observation& o) {
        return sort_key(slots_[slot].observation) < sort_key(o);
      });
  return static_cast<std::size_t>(place - order_.begin());
}

void Fusion::put(std::size_t place, const Observation& observation) {
  std::size_t slot = slots_.size();
  if (spare_.empty()) {
    slots_.emplace_back();
  } else {
    slot = spare_.back();
    spare_.pop_back();
  }
  slots_[slot].observation = observation;
  order_.insert(order_.begin() + static_cast<std::ptrdiff_t>(place), slot);
}

void Fusion::take_in_from(std::size_t place) {
  for (std::size_t i = place; i < order_.size(); ++i) {
    Slot& slot = slots_[order_[i]];
    slot.after = i == 0 ? checkpoint_ : slots_[order_[i - 1]].after;
    advance(slot.after, slot.observation, setting_);
    if (hint_.number == 0) continue;
    heed(slot.after.hinted,
         hint_,
         slot.after.balls,
         slot.observation.exposure,
         setting_.parameters.hint);
  }
}

const State& Fusion::head() const {
  return order_.empty() ? checkpoint_ : slots_[order_.back()].after;
}

WorldModel Fusion::world_at(HostTime now) const {
  WorldModel world = world_of(head(), now, setting_.parameters);
  for (WorldTeammate& mate : world.teammates) {
    if (is_babbling(mate.robot, now)) mate.quarantine = Quarantine::kBabbling;
  }
  for (WorldBall& ball : world.balls) ball.track = names_.name_of(ball.track);
  for (WorldObstacle& obstacle : world.obstacles) obstacle.track = names_.name_of(obstacle.track);
  std::sort(world.obstacles.begin(), world.obstacles.end(), [](const auto& a, const auto& b) {
    return a.track < b.track;
  });
  return world;
}

void Fusion::adopt_ids(const WorldModel& world, HostTime at) {
  const Parameters& parameters = setting_.parameters;
  names_.adopt(places_of(world.balls),
               named(head().balls, at, parameters),
               at,
               parameters.ball.gate_probability);
  names_.adopt(places_of(world.obstacles),
               named(head().obstacles, at, parameters),
               at,
               parameters.obstacle.gate_probability);
}

HintReport Fusion::hint_at(HostTime now, const WorldModel& world) const {
  HintReport report;
  if (hint_.number == 0) return report;
  report.number = hint_.number;
  report.left = time_left(hint_.given, now, setting_.parameters.hint);
  if (head().hinted.hint != hint_.number) return report;
  const std::uint32_t meant = names_.name_of(head().hinted.key);
  for (const WorldBall& ball : world.balls) {
    if (ball.track == meant) report.track = meant;
  }
  return report;
}

Report Fusion::report_at(HostTime now) const {
  Report report;
  const Duration window = setting_.parameters.support_window;
  const WorldModel world = world_at(now);
  report.hint = hint_at(now, world);
  const auto is_in = [](const auto& list, std::uint32_t track) {
    return std::any_of(
        list.begin(), list.end(), [track](const auto& thing) { return thing.track == track; });
  };
  const auto add = [&](const auto& tracks, const auto& listed, bool is_ball) {
    for (const auto& track : tracks) {
      const std::uint32_t name = names_.name_of(track.book.key);
      if (!is_in(listed, name)) continue;
      report.tracks.push_back(report_of(track.book, now, window));
      report.tracks.back().track = name;
      report.tracks.back().is_ball = is_ball;
    }
  };
  add(head().balls, world.balls, true);
  add(head().obstacles, world.obstacles, false);
  for (const Teammate& teammate : head().teammates) {
    RobotReport robot;
    robot.robot = teammate.robot;
    robot.quarantine = quarantine_at(head(), teammate, now, setting_.parameters);
    if (is_babbling(teammate.robot, now)) robot.quarantine = Quarantine::kBabbling;
    robot.trust = robot.quarantine == Quarantine::kNone
                      ? head().trust.trust(teammate.robot, now, setting_.parameters.trust)
                      : 0.0;
    robot.accepted = teammate.accepted;
    robot.rejected_gate = teammate.rejected_gate;
    robot.rejected_late = late_[index_of(teammate.robot)];
    robot.rejected_duplicate = duplicate_[index_of(teammate.robot)];
    robot.rejected_posture = teammate.rejected_posture;
    report.robots.push_back(robot);
  }
  std::sort(report.robots.begin(), report.robots.end(), [](const auto& a, const auto& b) {
    return a.robot < b.robot;
  });
  return report;
}

}  // namespace teamsight::fusion
