// tests/geometry/time_test.cpp: clocks that cannot be mixed up.
#include "geometry/time.hpp"

#include <concepts>
#include <type_traits>

#include <gtest/gtest.h>

namespace teamsight {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""ns;

template <class A, class B>
concept Subtractable = requires(A a, B b) {
  a - b;
};

static_assert(Subtractable<HostTime, HostTime>);
static_assert(!Subtractable<HostTime, PeerTime>, "two robots' clocks have no common zero");
static_assert(!std::convertible_to<PeerTime, HostTime>);

TEST(Time, ConvertsAPeersStampByItsOffset) {
  const PeerTime stamp{1500ms};

  EXPECT_EQ(to_host_time(stamp, 500ms), HostTime{1000ms});   // the peer is ahead
  EXPECT_EQ(to_host_time(stamp, -500ms), HostTime{2000ms});  // the peer is behind
}

TEST(Time, OwnStampComesBackUnchanged) {
  const HostTime now{123456789ns};

  EXPECT_EQ(to_host_time(stamp_of(now), Duration{0}), now);
}

TEST(Time, SecondsKeepNanosecondsOverAMatch) {
  const Duration duration{5'400'000'000'001};  // an hour and a half

  EXPECT_EQ(from_seconds(to_seconds(duration)), duration);
  EXPECT_EQ(from_seconds(-0.25), -250ms);
}

}  // namespace
}  // namespace teamsight
