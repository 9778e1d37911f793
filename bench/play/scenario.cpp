// bench/play/scenario.cpp: see bench/play/scenario.hpp.
#include "bench/play/scenario.hpp"

namespace teamsight::play {
namespace {

// From the start, so that no posture jumps and gives the fault away.
constexpr double kFaultBegins = 0.0;  // s

Scenario named(const std::string& name) {
  Scenario scenario;
  scenario.name = name;
  return scenario;
}

Scenario with_kicks(const std::string& name, double slowest, double fastest, double high_share) {
  Scenario scenario = named(name);
  scenario.play.min_kick = slowest;
  scenario.play.max_kick = fastest;
  scenario.play.high_share = high_share;
  return scenario;
}

Scenario with_fault(const std::string& name, Fault fault, const std::vector<RobotId>& robots) {
  Scenario scenario = named(name);
  for (const RobotId robot : robots) scenario.faults.push_back({robot, fault, kFaultBegins});
  return scenario;
}

Scenario with_loss(const std::string& name, double loss) {
  Scenario scenario = named(name);
  scenario.network.loss = loss;
  return scenario;
}

}  // namespace

std::vector<Scenario> all_scenarios() {
  std::vector<Scenario> all;
  all.push_back(named("normal"));
  all.push_back(with_kicks("fast-passes", 4.0, 7.0, 0.0));
  all.push_back(with_kicks("kicks-10", 9.0, 10.0, 0.0));
  all.push_back(with_kicks("high-balls", 5.0, 8.0, 0.8));
  all.push_back(named("crowd"));
  all.back().play.is_crowd = true;
  all.push_back(named("two-balls"));
  all.back().play.balls = 2;
  all.push_back(with_fault("one-biased", Fault::kBiased, {3}));
  all.push_back(with_fault("one-mirrored", Fault::kMirrored, {3}));
  all.push_back(with_fault("one-kidnapped", Fault::kKidnapped, {3}));
  all.push_back(with_fault("two-mirrored", Fault::kMirrored, {2, 4}));
  all.push_back(with_loss("loss-10", 0.1));
  all.push_back(with_loss("loss-30", 0.3));
  all.push_back(named("delays"));
  all.back().network.max_delay = 0.2;
  all.back().network.duplicates = 0.1;
  all.push_back(named("clocks"));
  all.back().clocks = {3600.0, 1e-4, true};
  all.back().network.max_delay = 0.02;
  all.push_back(named("joining"));
  all.back().is_joining = true;
  return all;
}

}  // namespace teamsight::play
