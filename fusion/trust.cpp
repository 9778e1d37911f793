// fusion/trust.cpp: see fusion/trust.hpp.
#include "fusion/trust.hpp"

#include <algorithm>
#include <cmath>

namespace teamsight::fusion {
namespace {

constexpr Duration kActive = std::chrono::seconds(2);  // silent for longer: has no vote
constexpr std::size_t kMostJudged = 10;                // explanations are tried one by one
constexpr double kSmoothing = 0.2;                     // of the offset, per look

std::size_t index_of(RobotId robot) {
  return static_cast<std::size_t>(robot) - 1U;
}

/// Log-odds of "both or neither" from the log-odds of two independent claims.
double both_or_neither(double a, double b) {
  return 2.0 * std::atanh(std::tanh(0.5 * a) * std::tanh(0.5 * b) * (1.0 - 1e-12));
}

double own_weight(double own_half, const TrustParameters& parameters) {
  return std::clamp(own_half, 0.5, parameters.most_own);
}

/// What explains all contradictions best.
struct Explanation {
  unsigned robots{0};  ///< bit i: the i-th is elsewhere than it says; 0: nobody is
  double gain{0.0};    ///< log-odds over nobody being so
  double lead{0.0};    ///< ... over the next best
};

/// Whether any pair speaks against itself. If none does, every explanation loses.
template <class Pair>
bool is_contradicted(std::size_t count, const Pair& evidence_of) {
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      if (evidence_of(i, j) < 0.0) return true;
    }
  }
  return false;
}

/// Tries every set of `count` robots.
template <class Gain>
Explanation best_explanation(std::size_t count, const Gain& gain_of) {
  Explanation best;
  double second = 0.0;
  for (unsigned set = 1; set < 1U << count; ++set) {
    const double gain = gain_of(set);
    if (gain > best.gain) {
      second = best.gain;
      best.gain = gain;
      best.robots = set;
    } else {
      second = std::max(second, gain);
    }
  }
  best.lead = best.gain - second;
  return best;
}

}  // namespace

bool TrustBook::is_due(RobotId robot, HostTime exposure, const TrustParameters& parameters) const {
  return exposure - pages_[index_of(robot)].looked >= parameters.period;
}

void TrustBook::note(RobotId robot, HostTime exposure, double own_half, double offset) {
  TrustPage& page = pages_[index_of(robot)];
  page.seen = std::max(page.seen, exposure);
  page.own_half = own_half;
  page.bias += kSmoothing * (std::min(offset, 200.0) - page.bias);
}

void TrustBook::note_elsewhere(RobotId robot,
                               HostTime exposure,
                               double log_odds,
                               const TrustParameters& parameters) {
  TrustPage& page = pages_[index_of(robot)];
  const bool is_found = log_odds >= parameters.in_place + parameters.place_margin;
  page.elsewhere = is_found ? page.elsewhere + 1 : 0;
  if (page.elsewhere >= 2) banish(robot, exposure);
}

void TrustBook::begin_look(RobotId robot, HostTime exposure, const TrustParameters& parameters) {
  TrustPage& page = pages_[index_of(robot)];
  if (page.looked != kNever) {
    // Each pair fades twice, once for each of its robots.
    const double dt = to_seconds(exposure - page.looked);
    const double keep = std::exp(-0.5 * dt / to_seconds(parameters.memory));
    fade(agreement_, robot, keep);
    fade(same_half_, robot, keep);
    fade(at_mirror_, robot, keep);
  }
  page.looked = exposure;
}

void TrustBook::fade(Pairs& pairs, RobotId robot, double keep) {
  for (std::size_t other = 0; other < kMaxRobotId; ++other) {
    pairs[index_of(robot)][other] *= keep;
    pairs[other][index_of(robot)] *= keep;
  }
}

void TrustBook::add(RobotId robot,
                    const PairEvidence& evidence,
                    const TrustParameters& parameters) {
  const std::size_t a = index_of(robot);
  const std::size_t b = index_of(evidence.other);
  const double most = parameters.most_evidence;
  const auto put = [&](Pairs& pairs, double value) {
    pairs[a][b] = pairs[b][a] = std::clamp(pairs[a][b] + value, -most, most);
  };
  put(agreement_, evidence.agreement);
  put(same_half_, evidence.same_half);
  put(at_mirror_, evidence.agreement - evidence.same_half);
}

void TrustBook::turn_over(RobotId robot) {
  for (std::size_t other = 0; other < kMaxRobotId; ++other) {
    same_half_[index_of(robot)][other] *= -1.0;
    same_half_[other][index_of(robot)] *= -1.0;
    agreement_[index_of(robot)][other] = agreement_[other][index_of(robot)] = 0.0;
    at_mirror_[index_of(robot)][other] = at_mirror_[other][index_of(robot)] = 0.0;
  }
  pages_[index_of(robot)].bias = 0.0;
  pages_[index_of(robot)].is_carried = false;
  pages_[index_of(robot)].verdict = Quarantine::kNone;
}

void TrustBook::forget(RobotId robot) {
  for (std::size_t other = 0; other < kMaxRobotId; ++other) {
    for (Pairs* pairs : {&agreement_, &same_half_, &at_mirror_}) {
      (*pairs)[index_of(robot)][other] = (*pairs)[other][index_of(robot)] = 0.0;
    }
  }
  pages_[index_of(robot)].bias = 0.0;
  pages_[index_of(robot)].is_carried = false;
  pages_[index_of(robot)].verdict = Quarantine::kNone;
}

void TrustBook::hold(RobotId robot, HostTime exposure) {
  convict(index_of(robot), Quarantine::kKidnapped, exposure);
}

void TrustBook::banish(RobotId robot, HostTime exposure) {
  pages_[index_of(robot)].is_carried = true;
  convict(index_of(robot), Quarantine::kKidnapped, exposure);
}

void TrustBook::set_aside(RobotId robot, HostTime exposure) {
  const TrustPage& page = pages_[index_of(robot)];
  const bool is_worse =
      page.verdict == Quarantine::kMirrored || page.verdict == Quarantine::kKidnapped;
  if (is_worse && page.held == exposure) return;
  convict(index_of(robot), Quarantine::kBiased, exposure);
}

void TrustBook::convict(std::size_t index, Quarantine verdict, HostTime exposure) {
  pages_[index].verdict = verdict;
  pages_[index].held = exposure;
}

TrustBook::Active TrustBook::active_at(HostTime exposure) const {
  Active active;
  for (std::size_t i = 0; i < pages_.size() && active.count < kMostJudged; ++i) {
    if (pages_[i].seen == kNever || exposure - pages_[i].seen > kActive) continue;
    active.index[active.count++] = i;
  }
  return active;
}

double TrustBook::gain_of(const Active& active,
                          unsigned turned,
                          const TrustParameters& parameters) const {
  double gain = 0.0;
  for (std::size_t i = 0; i < active.count; ++i) {
    if ((turned >> i & 1U) == 0) continue;
    gain -= own_weight(pages_[active.index[i]].own_half, parameters);
    for (std::size_t j = 0; j < active.count; ++j) {
      if ((turned >> j & 1U) == 0) gain -= same_half_[active.index[i]][active.index[j]];
    }
  }
  return gain;
}

void TrustBook::judge_halves(const Active& active,
                             HostTime exposure,
                             const TrustParameters& parameters) {
  const auto evidence = [&](std::size_t i, std::size_t j) {
    return same_half_[active.index[i]][active.index[j]];
  };
  if (!is_contradicted(active.count, evidence)) return;
  const Explanation best = best_explanation(
      active.count, [&](unsigned set) { return gain_of(active, set, parameters); });
  if (best.gain < parameters.mirror_gain || best.lead < parameters.mirror_margin) return;
  const unsigned turned = best.robots;
  for (std::size_t i = 0; i < active.count; ++i) {
    if ((turned >> i & 1U) == 0 || !is_found_at_mirror(i, active, turned)) continue;
    convict(active.index[i], Quarantine::kMirrored, exposure);
  }
}

/// Whether what it and those in the right half see does not speak against its mirror image as well:
/// one that fits neither place was carried away.
bool TrustBook::is_found_at_mirror(std::size_t i, const Active& active, unsigned turned) const {
  double sum = 0.0;
  for (std::size_t j = 0; j < active.count; ++j) {
    if ((turned >> j & 1U) == 0) sum += at_mirror_[active.index[i]][active.index[j]];
  }
  return sum >= 0.0;
}

/// What a pair counts: no robot's word alone carries a verdict.
double TrustBook::pair_agreement(std::size_t a,
                                 std::size_t b,
                                 const TrustParameters& parameters) const {
  return std::clamp(agreement_[a][b], -parameters.contradiction, parameters.agreement);
}

/// Log-odds for that these robots, and no others, were carried away: nothing that a pair with one
/// of them says of itself is to be explained any more.
double TrustBook::gain_of_carried(const Active& active,
                                  unsigned carried,
                                  const TrustParameters& parameters) const {
  double gain = 0.0;
  for (std::size_t i = 0; i < active.count; ++i) {
    const bool is_carried = (carried >> i & 1U) != 0;
    if (is_carried) gain -= parameters.in_place;
    for (std::size_t j = i + 1; j < active.count; ++j) {
      if (!is_carried && (carried >> j & 1U) == 0) continue;
      gain -= pair_agreement(active.index[i], active.index[j], parameters);
    }
  }
  return gain;
}

/// Finds who was carried away: the explanation of all contradictions that gains most, by a margin.
void TrustBook::judge_places(const Active& all,
                             HostTime exposure,
                             const TrustParameters& parameters) {
  Active active;
  for (std::size_t i = 0; i < all.count; ++i) {
    const TrustPage& page = pages_[all.index[i]];
    if (page.verdict == Quarantine::kMirrored && page.held == exposure) continue;
    active.index[active.count++] = all.index[i];
  }
  const auto evidence = [&](std::size_t i, std::size_t j) {
    return agreement_[active.index[i]][active.index[j]];
  };
  const Explanation best =
      is_contradicted(active.count, evidence)
          ? best_explanation(active.count,
                             [&](unsigned set) { return gain_of_carried(active, set, parameters); })
          : Explanation{};
  if (best.lead >= parameters.place_margin) {
    for (std::size_t i = 0; i < active.count; ++i) {
      if ((best.robots >> i & 1U) == 0) continue;
      banish(static_cast<RobotId>(active.index[i] + 1), exposure);
    }
  }
  keep_carried(active, exposure, parameters);
}

/// Who was carried away stays so until the others agree with it again, or nobody is left to.
void TrustBook::keep_carried(const Active& active,
                             HostTime exposure,
                             const TrustParameters& parameters) {
  for (std::size_t i = 0; i < active.count; ++i) {
    TrustPage& page = pages_[active.index[i]];
    if (!page.is_carried || page.held == exposure) continue;
    double sum = 0.0;
    for (std::size_t j = 0; j < active.count; ++j) {
      if (j != i) sum += pair_agreement(active.index[i], active.index[j], parameters);
    }
    page.is_carried = active.count > 2 && sum < parameters.agreement;
    if (page.is_carried) convict(active.index[i], Quarantine::kKidnapped, exposure);
  }
}

void TrustBook::judge(HostTime exposure, const TrustParameters& parameters) {
  const Active active = active_at(exposure);
  judge_halves(active, exposure, parameters);
  judge_places(active, exposure, parameters);
}

Quarantine TrustBook::verdict(RobotId robot,
                              HostTime now,
                              const TrustParameters& parameters) const {
  const TrustPage& page = pages_[index_of(robot)];
  return now - page.held <= parameters.hold ? page.verdict : Quarantine::kNone;
}

double TrustBook::half_log_odds(RobotId robot, const TrustParameters& parameters) const {
  double sum = 0.0;
  for (std::size_t other = 0; other < kMaxRobotId; ++other) {
    const TrustPage& page = pages_[other];
    if (other == index_of(robot) || page.seen == kNever) continue;
    // Who is found in the wrong half speaks for the other.
    const bool is_turned =
        page.verdict == Quarantine::kMirrored && page.looked - page.held <= parameters.hold;
    const double own = own_weight(page.own_half, parameters);
    sum += both_or_neither(same_half_[index_of(robot)][other], is_turned ? -own : own);
  }
  return std::clamp(sum, -parameters.most_evidence, parameters.most_evidence);
}

double TrustBook::trust(RobotId robot, HostTime now, const TrustParameters& parameters) const {
  if (verdict(robot, now, parameters) != Quarantine::kNone) return 0.0;
  const TrustPage& page = pages_[index_of(robot)];
  // What speaks against it, though not enough for a verdict.
  const double doubt = std::clamp(page.bias / parameters.biased, 0.0, 1.0);
  return 1.0 - 0.5 * doubt;
}

}  // namespace teamsight::fusion
