// tests/process/meter_test.cpp: Diagnostics hold what was measured.
#include "process/meter.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace teamsight::process {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

TEST(ProcessMeter, GivesMedianAndNinetyFifthPercentileOfTheSteps) {
  ProcessMeter meter("fusion/3", 3, 77);
  for (int i = 1; i <= 101; ++i) meter.add_step(milliseconds(i));

  const auto report = meter.report(HostTime{seconds(5)});

  EXPECT_DOUBLE_EQ(report.step_ms_p50, 51.0);
  EXPECT_DOUBLE_EQ(report.step_ms_p95, 96.0);
}

TEST(ProcessMeter, ForgetsTheStepsOfTheReportBefore) {
  ProcessMeter meter("fusion/3", 3, 77);
  meter.add_step(milliseconds(500));
  (void)meter.report(HostTime{seconds(5)});
  meter.add_step(milliseconds(2));

  const auto report = meter.report(HostTime{seconds(6)});

  EXPECT_DOUBLE_EQ(report.step_ms_p95, 2.0);
}

TEST(ProcessMeter, KeepsTheNewestStepsWhenThereAreMany) {
  ProcessMeter meter("fusion/3", 3, 77);
  for (int i = 0; i < 600; ++i) meter.add_step(milliseconds(500));
  for (int i = 0; i < 512; ++i) meter.add_step(milliseconds(1));

  EXPECT_DOUBLE_EQ(meter.report(HostTime{seconds(5)}).step_ms_p95, 1.0);
}

TEST(ProcessMeter, ReportsAStateBeforeAllCountersAlsoWhenItIsZero) {
  ProcessMeter meter("agent/1", 1, 77);
  for (int i = 0; i < 30; ++i) meter.set("counter." + std::to_string(i), 1000U);
  meter.show("state", 5);

  meter.show("state", 0);
  const auto report = meter.report(HostTime{seconds(5)});

  ASSERT_EQ(report.counters.size(), 18U);
  EXPECT_EQ(report.counters[0].name, "state");
  EXPECT_EQ(report.counters[0].value, 0U);
}

TEST(ProcessMeter, CountsItsReportsUnderTheProcessName) {
  ProcessMeter meter("fusion/3", 3, 77);
  (void)meter.report(HostTime{seconds(5)});

  const auto report = meter.report(HostTime{seconds(6)});

  EXPECT_EQ(report.process, "fusion/3");
  EXPECT_EQ(report.id, (ObservationId{3, 77, 2}));
  EXPECT_EQ(report.stamp, PeerTime{seconds(6)});
}

TEST(ProcessMeter, MeasuresLoadAndMemoryOfThisProcess) {
  ProcessMeter meter("fusion/3", 3, 77);
  (void)meter.report(HostTime{seconds(1)});
  volatile double sum = 0.0;
  for (int i = 0; i < 2'000'000; ++i) sum = sum + 1.0;

  const auto report = meter.report(HostTime{seconds(2)});

  EXPECT_GT(report.cpu_load, 0.0);
  EXPECT_GT(report.resident_kb, 500U);
}

TEST(ProcessMeter, SendsTheLargestCountersThatAreNotZero) {
  ProcessMeter meter("fusion/3", 3, 77);
  for (std::uint64_t i = 0; i < 30; ++i) meter.set("counter" + std::to_string(i), i);
  meter.count("often", 1000);
  meter.count("often");

  const auto report = meter.report(HostTime{seconds(5)});

  ASSERT_EQ(report.counters.size(), 18U);
  EXPECT_EQ(report.counters.front(), (bus::Counter{"often", 1001}));
  EXPECT_EQ(report.counters.back().value, 13U);
}

TEST(ProcessMeter, NamesEveryReasonOfRejection) {
  ProcessMeter meter("fusion/3", 3, 77);
  bus::ReadCounters counters;
  counters.accepted = 9;
  counters.rejected[static_cast<std::size_t>(bus::Reject::kBadCovariance)] = 2;

  meter.set("Sightings", counters);

  EXPECT_THAT(meter.report(HostTime{seconds(5)}).counters,
              testing::ElementsAre(bus::Counter{"Sightings.accepted", 9},
                                   bus::Counter{"Sightings.rejected.bad_covariance", 2}));
}

TEST(StepTimer, MeasuresItsScope) {
  ProcessMeter meter("fusion/3", 3, 77);

  { const StepTimer timer(meter); }

  EXPECT_GT(meter.report(HostTime{seconds(5)}).step_ms_p50, 0.0);
}

}  // namespace
}  // namespace teamsight::process
