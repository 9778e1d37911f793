// bench/play/scenario.hpp: the named scenarios that fusion is scored on.
#pragma once

#include <string>
#include <vector>

#include "bench/play/network.hpp"
#include "bench/play/perception.hpp"
#include "bench/play/play.hpp"

namespace teamsight::play {

struct FaultPlan {
  RobotId robot{kNobody};
  Fault fault{Fault::kNone};
  double from{0.0};  ///< s
};

struct Scenario {
  std::string name;
  PlayParameters play;
  PerceptionParameters perception;
  NetworkParameters network;
  ClockParameters clocks;
  std::vector<FaultPlan> faults;
  bool is_joining{false};  ///< robots fall silent and come back
};

/// All of them, in the order in which they are reported.
[[nodiscard]] std::vector<Scenario> all_scenarios();

}  // namespace teamsight::play
