// tests/network/network_test.cpp: every scenario of the test bench, shortened.
#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include "tests/network/hosts.hpp"
#include "tests/network/scenarios.hpp"

namespace teamsight::network {
namespace {

// Part of the whole run by command: they take a minute, or say the same as a worse one.
constexpr std::array<std::string_view, 5> kLeftOut{
    "split-60", "loss-10", "bursts", "late-robot-lossy", "attack"};

class Network : public ::testing::TestWithParam<Scenario> {};

TEST_P(Network, HoldsWhatItMustUnder) {
  if (const std::string problem = Hosts::problem(); !problem.empty()) {
    GTEST_SKIP() << "no hosts can be made here: " << problem;
  }

  go_first();
  ScenarioOptions options;
  options.length = 0.4;
  const Outcome outcome = GetParam().run(options);

  for (const std::string& line : outcome.lines) std::printf("%s\n", line.c_str());
  for (const std::string& claim : outcome.broken) ADD_FAILURE() << claim;
}

std::vector<Scenario> short_ones() {
  std::vector<Scenario> some;
  for (const Scenario& one : all_scenarios()) {
    if (std::ranges::find(kLeftOut, one.name) == kLeftOut.end()) some.push_back(one);
  }
  return some;
}

std::string name_of(const ::testing::TestParamInfo<Scenario>& info) {
  std::string name(info.param.name);
  for (char& letter : name) {
    if (letter == '-') letter = '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Faults, Network, ::testing::ValuesIn(short_ones()), name_of);

}  // namespace
}  // namespace teamsight::network
