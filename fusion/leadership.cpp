// fusion/leadership.cpp: see fusion/leadership.hpp.
#include "fusion/leadership.hpp"

#include <algorithm>

namespace teamsight::fusion {
namespace {

// Long before everything.
constexpr HostTime kLongAgo{std::chrono::hours(-1)};

}  // namespace

Leadership::Leadership(const Rank& own, const LeadershipParameters& parameters)
    : own_(own),
      parameters_(parameters),
      started_(kLongAgo),
      asked_(kLongAgo),
      stronger_since_(kLongAgo),
      stronger_heard_(kLongAgo),
      other_heard_(kLongAgo) {}

bool Leadership::is_heard(HostTime when, HostTime now) const {
  return now - when <= parameters_.lease;
}

void Leadership::heard(const Rank& other, HostTime now) {
  if (other == own_) return;
  other_heard_ = now;
  if (other.is_below(own_)) return;
  if (!is_heard(stronger_heard_, now)) stronger_since_ = now;
  stronger_heard_ = now;
}

bool Leadership::leads(HostTime now) {
  if (!is_heard(asked_, now)) {
    started_ = now;
    leads_ = false;
  }
  asked_ = now;
  const bool hears_stronger = is_heard(stronger_heard_, now);
  if (leads_) {
    const bool must_yield =
        hears_stronger && stronger_heard_ - stronger_since_ >= parameters_.yield_after;
    leads_ = !must_yield;
    return leads_;
  }
  const bool hears_anyone = is_heard(std::max(other_heard_, started_), now);
  const bool is_warm = now - started_ >= parameters_.warm_up;
  leads_ = !hears_stronger && (is_warm || !hears_anyone);
  return leads_;
}

}  // namespace teamsight::fusion
