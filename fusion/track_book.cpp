// fusion/track_book.cpp: see fusion/track_book.hpp.
#include "fusion/track_book.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "geometry/angle.hpp"

namespace teamsight::fusion {
namespace {

// No two bodies stand nearer to each other: what is nearer than this hides itself; m.
constexpr double kApart = 0.3;

/// Size of the turn between two azimuths of (-pi, pi]: this is asked for every cell of a map.
double turn_between(double a, double b) {
  const double turn = std::abs(a - b);
  return std::min(turn, 2.0 * std::numbers::pi - turn);
}

std::size_t index_of(RobotId robot) {
  return static_cast<std::size_t>(robot) - 1U;
}

/// Log-odds that a candidate of this confidence adds.
double evidence(double confidence) {
  constexpr double kDoubt = 0.05;  // no single frame is believed beyond this
  return std::log((confidence + kDoubt) / (1.0 - confidence + kDoubt));
}

bool is_seen_by_others(const TrackBook& book, RobotId robot) {
  for (std::size_t i = 0; i < book.supported.size(); ++i) {
    if (i != index_of(robot) && book.supported[i] != kNever) return true;
  }
  return false;
}

}  // namespace

RobotMask robots_within(const RobotTimes& times, HostTime now, Duration window) {
  RobotMask mask = 0;
  for (RobotId robot = 1; robot <= kMaxRobotId; ++robot) {
    const HostTime time = times[robot - 1U];
    if (time == kNever || now - time > window) continue;
    mask = static_cast<RobotMask>(mask | robot_bit(robot));
  }
  return mask;
}

double votes_for(const TrackBook& book) {
  return std::accumulate(book.votes.begin(), book.votes.end(), 0.0);
}

double log_odds_of(const TrackBook& book) {
  return votes_for(book) - book.doubt;
}

void turn_page(TrackBook& book, HostTime exposure, const TrackParameters& parameters) {
  const double dt = to_seconds(exposure - book.time);
  if (dt <= 0.0) return;
  book.time = exposure;
  const double keep = std::exp(-dt / to_seconds(parameters.vote_memory));
  for (double& vote : book.votes) vote *= keep;
}

void write_miss(TrackBook& book,
                RobotId robot,
                double probability,
                const TrackParameters& parameters) {
  double& vote = book.votes[index_of(robot)];
  vote = std::max(vote + std::log1p(-probability), -parameters.most_vote);
}

void take_back(TrackBook& book, RobotId robot, const TrackParameters& parameters) {
  const std::size_t index = index_of(robot);
  const HostTime said = book.supported[index];
  if (said == kNever) return;
  book.supported[index] = kNever;
  book.votes[index] = std::min(book.votes[index], 0.0);
  const HostTime others_said = *std::max_element(book.supported.begin(), book.supported.end());
  if (said - others_said > parameters.led_astray) {
    // It has gone where that robot alone led it: what the others saw was elsewhere.
    for (double& vote : book.votes) vote = std::min(vote, 0.0);
    book.proven = 0.0;
    return;
  }
  const auto others = std::count_if(book.supported.begin(),
                                    book.supported.end(),
                                    [](HostTime supported) { return supported != kNever; });
  book.proven = std::min(book.proven, static_cast<double>(others) * parameters.most_vote);
}

double existence_at(const TrackBook& book, HostTime now, const TrackParameters& parameters) {
  const double unseen = std::max(0.0, to_seconds(now - book.last_hit));
  // Things leave: half of those that nobody sees are gone after half the time to forget them.
  const double half_life = 0.5 * to_seconds(parameters.death_age);
  return std::exp2(-unseen / half_life) / (1.0 + std::exp(-log_odds_of(book)));
}

TrackBook first_page(std::uint32_t key, const Vote& vote, const TrackParameters& parameters) {
  TrackBook book;
  book.key = key;
  book.time = book.born = book.last_hit = vote.exposure;
  book.supported[index_of(vote.robot)] = vote.exposure;
  book.votes[index_of(vote.robot)] = evidence(vote.confidence);
  book.hits = 1;
  book.is_confirmed = parameters.birth_hits <= 1;
  return book;
}

void write_hit(TrackBook& book, const Vote& vote, double nis, const TrackParameters& parameters) {
  book.nis_sum += nis;
  const Duration lasted = std::max(Duration{0}, vote.exposure - book.last_hit);
  book.doubt = std::max(0.0, book.doubt - to_seconds(lasted) / to_seconds(parameters.false_life));
  if (is_seen_by_others(book, vote.robot)) book.doubt = 0.0;
  book.last_hit = std::max(book.last_hit, vote.exposure);
  book.supported[index_of(vote.robot)] = vote.exposure;
  double& said = book.votes[index_of(vote.robot)];
  said = std::min(said + evidence(vote.confidence), parameters.most_vote);
  book.proven = std::max(book.proven, log_odds_of(book));
  ++book.hits;
  const bool is_quick = vote.exposure - book.born <= parameters.birth_window;
  if (is_quick && book.hits >= static_cast<std::uint32_t>(parameters.birth_hits)) {
    book.is_confirmed = true;
  }
}

bool is_over(const TrackBook& book, HostTime exposure, const TrackParameters& parameters) {
  const bool is_late = exposure - book.born > parameters.birth_window;
  const bool is_given_up =
      votes_for(book) < parameters.death_log_odds && book.proven < parameters.lasting_log_odds;
  return is_given_up || exposure - book.last_hit > parameters.death_age ||
         (!book.is_confirmed && is_late);
}

std::uint32_t track_key(const ObservationId& id, std::uint32_t index) {
  // FNV-1a over the numbers' bytes: short, and the same on every machine.
  std::uint32_t hash = 2166136261U;
  for (std::uint32_t number : {std::uint32_t{id.robot}, id.boot, id.sequence, index}) {
    for (int i = 0; i < 4; ++i) {
      hash = (hash ^ (number & 0xFFU)) * 16777619U;
      number >>= 8U;
    }
  }
  return hash == 0 ? 1 : hash;
}

double detection_probability(const Eigen::Vector2d& p_F,
                             const Eigen::Vector2d& observer_F,
                             const CandidateList& hiding,
                             const TrackParameters& parameters) {
  const double distance = (p_F - observer_F).norm();
  if (distance >= parameters.detection_range || is_behind(p_F, observer_F, hiding)) return 0.0;
  return parameters.detection_probability * (1.0 - distance / parameters.detection_range);
}

bool is_behind(const Eigen::Vector2d& p_F,
               const Eigen::Vector2d& observer_F,
               const CandidateList& hiding) {
  const Eigen::Vector2d way = p_F - observer_F;
  const double distance = way.norm();
  const double azimuth = std::atan2(way.y(), way.x());
  return std::any_of(hiding.begin(), hiding.end(), [&](const Candidate& candidate) {
    const double aside = std::abs(angle_difference(azimuth, candidate.azimuth));
    return candidate.distance < distance && aside < candidate.half_angle;
  });
}

bool is_hidden(const Eigen::Vector2d& p_F, const Scene& scene) {
  const Eigen::Vector2d way = p_F - scene.glance.observer();
  const double distance = way.norm();
  const double azimuth = std::atan2(way.y(), way.x());
  const auto hides = [&](const auto& body, double margin) {
    return body.distance < distance - margin &&
           turn_between(azimuth, body.azimuth) < body.half_angle;
  };
  return std::any_of(scene.hiding.begin(),
                     scene.hiding.end(),
                     [&](const Candidate& body) { return hides(body, 0.0); }) ||
         std::any_of(scene.sight.shadows.begin(),
                     scene.sight.shadows.end(),
                     [&](const Shadow& body) { return hides(body, kApart); });
}

double missed_probability(const Eigen::Vector2d& p_F,
                          const Scene& scene,
                          const TrackParameters& parameters) {
  return -std::expm1(scene.sight.news * std::log1p(-shown_probability(p_F, scene, parameters)));
}

double shown_probability(const Eigen::Vector2d& p_F,
                         const Scene& scene,
                         const TrackParameters& parameters) {
  const double distance = (p_F - scene.glance.observer()).norm();
  const double probability =
      scene.sight.eyes.probability(distance, parameters, scene.sight.parameters);
  return probability > 0.0 && !is_hidden(p_F, scene) ? probability : 0.0;
}

}  // namespace teamsight::fusion
