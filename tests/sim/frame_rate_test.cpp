// tests/sim/frame_rate_test.cpp: the rate that a computer is given, and what is said about it.
#include "sim/frame_rate.hpp"

#include <chrono>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace teamsight::sim {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::Optional;

TEST(FrameRate, LeavesTheRestOfTheComputerToTheTeam) {
  const double rate = rate_that_holds(11ms, 5, 2);

  EXPECT_EQ(rate, std::floor(rate));
  EXPECT_LE(rate * 5 * 0.011, kDrawingShare * 2);
  EXPECT_GT((rate + 1.0) * 5 * 0.011, kDrawingShare * 2);
}

TEST(FrameRate, GrowsWithCoresAndShrinksWithCameras) {
  const double two = rate_that_holds(10ms, 5, 2);

  EXPECT_GT(rate_that_holds(10ms, 5, 3), two);
  EXPECT_GT(rate_that_holds(10ms, 4, 2), two);
  EXPECT_GT(rate_that_holds(8ms, 5, 2), two);
}

TEST(FrameRate, StaysWithinWhatALiveMatchNeeds) {
  EXPECT_EQ(rate_that_holds(1s, 5, 1), kSlowestRate);
  EXPECT_EQ(rate_that_holds(1us, 1, 64), kFastestRate);
}

TEST(FrameTally, HearsOfProcessesThatAreForked) {
  FrameTally tally(2);
  const pid_t child = ::fork();
  if (child == 0) {
    tally.set(1, {7, 5});
    ::_exit(0);
  }
  ASSERT_EQ(::waitpid(child, nullptr, 0), child);

  EXPECT_EQ(tally.of(1).due, 7U);
  EXPECT_EQ(tally.of(1).taken, 5U);
  EXPECT_EQ(tally.of(0).due, 0U);
}

TEST(RateJudge, SaysOnceThatTheRateHolds) {
  FrameTally tally(2);
  RateJudge judge(2, 10.0);
  tally.set(0, {100, 100});
  tally.set(1, {100, 98});

  EXPECT_THAT(judge.judge(tally, 10.0), Optional(HasSubstr("hold 9.8 of 10 Hz")));

  tally.set(0, {200, 200});
  tally.set(1, {200, 198});
  EXPECT_EQ(judge.judge(tally, 10.0), std::nullopt);
}

TEST(RateJudge, SaysClearlyWhenTheSlowestCameraFallsBehind) {
  FrameTally tally(2);
  RateJudge judge(2, 10.0);
  tally.set(0, {100, 100});
  tally.set(1, {100, 100});
  ASSERT_TRUE(judge.judge(tally, 10.0).has_value());

  tally.set(0, {200, 200});
  tally.set(1, {200, 170});

  EXPECT_THAT(judge.judge(tally, 10.0),
              Optional(HasSubstr("do not hold their rate: 7.0 of 10 Hz")));
}

TEST(RateJudge, JudgesNoCameraThatNobodyReads) {
  FrameTally tally(2);
  RateJudge judge(2, 10.0);
  tally.set(0, {40, 1});  // its reader came late

  EXPECT_EQ(judge.judge(tally, 10.0), std::nullopt);

  tally.set(0, {140, 101});
  EXPECT_THAT(judge.judge(tally, 10.0), Optional(HasSubstr("hold 10.0 of 10 Hz")));
}

}  // namespace
}  // namespace teamsight::sim
