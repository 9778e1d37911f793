// bench/fuse_score/shared_evidence.cpp: see bench/fuse_score/shared_evidence.hpp.
#include "bench/fuse_score/shared_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace teamsight::score {
namespace {

constexpr double kTogether = 0.3;  // s

bool shows(const play::Frame& frame, RobotId robot) {
  return ((frame.seen_players >> (static_cast<unsigned>(robot) - 1U)) & 1U) != 0;
}

bool can_be_compared(const play::Frame& a, const play::Frame& b) {
  if (std::abs(a.exposure - b.exposure) > kTogether) return false;
  return (a.seen_balls & b.seen_balls) != 0 || (a.seen_players & b.seen_players) != 0 ||
         shows(a, b.observation.id.robot) || shows(b, a.observation.id.robot);
}

}  // namespace

double shared_evidence_until(const play::PlayLog& log, const play::FaultPlan& fault, double until) {
  std::map<RobotId, const play::Frame*> last;
  double shared = 0.0;
  double counted = 0.0;  // up to then; s since the start
  for (const play::Delivery& delivery : log.deliveries) {
    const play::Frame& frame = log.frames[delivery.frame];
    if (frame.exposure < fault.from || delivery.arrival >= until) continue;
    const RobotId robot = frame.observation.id.robot;
    last[robot] = &frame;
    const bool is_shared = std::any_of(last.begin(), last.end(), [&](const auto& other) {
      const bool is_pair =
          other.first != robot && (robot == fault.robot || other.first == fault.robot);
      return is_pair && can_be_compared(frame, *other.second);
    });
    if (!is_shared) continue;
    const double end = std::min(until, delivery.arrival + kTogether);
    shared += std::max(0.0, end - std::max(counted, delivery.arrival));
    counted = std::max(counted, end);
  }
  return shared;
}

}  // namespace teamsight::score
