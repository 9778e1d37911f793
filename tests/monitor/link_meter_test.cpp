// tests/monitor/link_meter_test.cpp: rate, loss and latency from arrivals.
#include "monitor/link_meter.hpp"

#include <chrono>

#include <gtest/gtest.h>

namespace teamsight::monitor {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

const HostTime kStart{seconds(100)};

HostTime at_ms(int ms) {
  return kStart + milliseconds(ms);
}

void add(LinkMeter& meter, std::uint32_t sequence, HostTime received, std::uint32_t boot = 1) {
  meter.add({4, boot, sequence}, milliseconds(35), received);
}

TEST(LinkMeter, ReportsNothingBeforeTheFirstFrame) {
  const LinkMeter meter{seconds(5)};

  const LinkReport report = meter.report(kStart);

  EXPECT_EQ(report, LinkReport{});
}

TEST(LinkMeter, CountsTheGapsInTheSequenceAsLoss) {
  LinkMeter meter{seconds(5)};
  add(meter, 10, at_ms(0));
  add(meter, 11, at_ms(40));
  add(meter, 14, at_ms(160));
  add(meter, 15, at_ms(200));

  const LinkReport report = meter.report(at_ms(200));

  EXPECT_DOUBLE_EQ(report.loss, 2.0 / 6.0);
  EXPECT_DOUBLE_EQ(report.rate, 15.0);
  EXPECT_EQ(report.received, 4U);
}

TEST(LinkMeter, RateFallsWhileARobotIsSilent) {
  LinkMeter meter{seconds(5)};
  for (int i = 0; i < 26; ++i) add(meter, static_cast<std::uint32_t>(i + 1), at_ms(40 * i));

  EXPECT_NEAR(meter.report(at_ms(1000)).rate, 25.0, 1e-9);
  EXPECT_NEAR(meter.report(at_ms(2500)).rate, 10.0, 1e-9);
  EXPECT_EQ(meter.report(at_ms(7000)).rate, 0.0);
}

TEST(LinkMeter, MeasuresFromExposureToArrival) {
  LinkMeter meter{seconds(5)};
  for (int i = 0; i < 100; ++i) {
    const HostTime received = at_ms(20 * i);
    meter.add({4, 1, static_cast<std::uint32_t>(i + 1)}, milliseconds(1 + i), received);
  }

  const LinkReport report = meter.report(at_ms(1980));

  ASSERT_TRUE(report.latency_p50 && report.latency_p95);
  EXPECT_EQ(*report.latency_p50, milliseconds(51));
  EXPECT_EQ(*report.latency_p95, milliseconds(95));
}

TEST(LinkMeter, SaysNoLatencyWhileTheWindowHasFramesOfAnUnknownClock) {
  LinkMeter meter{seconds(5)};
  meter.add({4, 1, 1}, std::nullopt, at_ms(0));
  meter.add({4, 1, 2}, milliseconds(30), at_ms(40));

  EXPECT_FALSE(meter.report(at_ms(40)).latency_p50.has_value());
  EXPECT_FALSE(meter.report(at_ms(40)).latency_p95.has_value());
  EXPECT_EQ(meter.report(at_ms(5020)).latency_p50, milliseconds(30));
}

TEST(LinkMeter, ARestartIsNoLoss) {
  LinkMeter meter{seconds(5)};
  add(meter, 900, at_ms(0), 1);
  add(meter, 1, at_ms(40), 2);
  add(meter, 2, at_ms(80), 2);

  EXPECT_DOUBLE_EQ(meter.report(at_ms(80)).loss, 0.0);
  EXPECT_EQ(meter.report(at_ms(80)).received, 3U);
}

}  // namespace
}  // namespace teamsight::monitor
