// agent/identity_guard.cpp: see identity_guard.hpp.
#include "agent/identity_guard.hpp"

namespace teamsight::agent {

Rivalry judge_rival(const ObservationId& own, const ObservationId& heard) {
  if (heard.robot != own.robot || heard.boot == own.boot) {
    return Rivalry::kNone;
  }
  if (own.sequence / 2 > heard.sequence) {
    return Rivalry::kStay;
  }
  if (heard.sequence / 2 > own.sequence) {
    return Rivalry::kYield;
  }
  return own.boot > heard.boot ? Rivalry::kYield : Rivalry::kStay;
}

}  // namespace teamsight::agent
