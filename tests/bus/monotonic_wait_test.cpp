// tests/bus/monotonic_wait_test.cpp: the library's waits after a step of the wall clock, with and
// without bus/monotonic_wait.cpp.
#include <string>

#include <gtest/gtest.h>

#include "tests/bus/files.hpp"
#include "tests/support/process.hpp"

namespace teamsight::bus {
namespace {

constexpr int kWait = 500;

/// How long the library's wait of kWait takes in a program that sees the wall clock five seconds
/// ahead of the real one (shifted_clock.cpp), in ms.
int wait_under_a_stepped_clock(const char* program) {
  test::ChildProcess child({program,
                            "wait",
                            testing::profile_path("loopback.xml"),
                            std::to_string(test::unique_domain()),
                            "wait",
                            std::to_string(kWait)},
                           {{"LD_PRELOAD", SHIFTED_CLOCK}});
  EXPECT_EQ(child.wait_exit(std::chrono::seconds(60)), 0) << child.err();
  return std::stoi("0" + child.out());
}

TEST(MonotonicWait, KeepsTheLibrarysWaitsAsLongAsAsked) {
  const int took = wait_under_a_stepped_clock(CHILD_WITH_MONOTONIC_WAIT);

  EXPECT_GE(took, kWait);
  EXPECT_LT(took, kWait + 2500);
}

// The trouble itself, so that a library that no longer has it is noticed.
TEST(MonotonicWait, IsNeededByThisVersionOfTheLibrary) {
  const int took = wait_under_a_stepped_clock(CHILD_WITHOUT_MONOTONIC_WAIT);

  EXPECT_GE(took, kWait + 4500);
}

}  // namespace
}  // namespace teamsight::bus
