// tests/fusion/clock_offset_test.cpp: the peer's clock from two-way exchanges.
#include "fusion/clock_offset.hpp"

#include <gtest/gtest.h>

namespace teamsight::fusion {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr HostTime kStart{seconds(50)};

/// The peer is `offset` ahead; the probe needs `out`, the peer `stay`, the echo `back`.
ClockExchange exchange(HostTime sent, Duration offset, Duration out, Duration stay, Duration back) {
  const PeerTime received{sent.time_since_epoch() + out + offset};
  return {sent, received, received + stay, sent + out + stay + back};
}

TEST(ClockOffset, IsExactWhenBothWaysTakeEquallyLong) {
  ClockOffset clock;

  ASSERT_TRUE(
      clock.add(exchange(kStart, seconds(7), milliseconds(2), seconds(1), milliseconds(2))));

  const auto estimate = clock.at(kStart + seconds(2));
  ASSERT_TRUE(estimate.has_value());
  EXPECT_EQ(estimate->offset, seconds(7));
}

TEST(ClockOffset, MayBeNegative) {
  ClockOffset clock;

  clock.add(exchange(kStart, -seconds(30), milliseconds(1), Duration{0}, milliseconds(1)));

  EXPECT_EQ(clock.at(kStart + seconds(1))->offset, -seconds(30));
}

TEST(ClockOffset, PrefersTheShortestRoundTrip) {
  ClockOffset clock;
  clock.add(exchange(kStart, seconds(7), microseconds(100), Duration{0}, microseconds(100)));

  clock.add(
      exchange(kStart + seconds(1), seconds(7), milliseconds(40), Duration{0}, microseconds(100)));

  EXPECT_EQ(clock.at(kStart + seconds(1))->offset, seconds(7));
}

TEST(ClockOffset, GrowsLessSureWithTime) {
  ClockOffset clock;
  clock.add(exchange(kStart, seconds(7), microseconds(100), Duration{0}, microseconds(100)));

  EXPECT_GT(clock.at(kStart + seconds(20))->sigma, 5 * clock.at(kStart + seconds(1))->sigma);
}

TEST(ClockOffset, IsUnknownBeforeTheFirstAndLongAfterTheLastExchange) {
  ClockOffset clock;
  EXPECT_FALSE(clock.at(kStart).has_value());

  clock.add(exchange(kStart, seconds(7), microseconds(100), Duration{0}, microseconds(100)));

  EXPECT_FALSE(clock.at(kStart + seconds(60)).has_value());
}

TEST(ClockOffset, RefusesAnExchangeThatCannotBe) {
  ClockOffset clock;

  // Answered before it was asked, and back before it was answered.
  EXPECT_FALSE(clock.add(exchange(kStart, {}, milliseconds(1), -milliseconds(1), {})));
  EXPECT_FALSE(clock.add(exchange(kStart, {}, milliseconds(1), {}, -milliseconds(5))));
  EXPECT_FALSE(clock.at(kStart).has_value());
}

TEST(ClockOffset, ForgetsAPeerThatWasStartedAnew) {
  ClockOffset clock;
  clock.add(exchange(kStart, seconds(7), milliseconds(1), Duration{0}, milliseconds(1)));

  clock.forget();

  EXPECT_FALSE(clock.at(kStart + seconds(1)).has_value());
}

}  // namespace
}  // namespace teamsight::fusion
