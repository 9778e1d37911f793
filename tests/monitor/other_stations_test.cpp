// tests/monitor/other_stations_test.cpp: see monitor/other_stations.hpp.
#include "monitor/other_stations.hpp"

#include <chrono>

#include <gtest/gtest.h>

namespace teamsight::monitor {
namespace {

using std::chrono::seconds;

constexpr HostTime kStart{seconds(100)};

TEST(OtherStations, CountAsLongAsTheySpeak) {
  OtherStations others(seconds(5));

  EXPECT_TRUE(others.hear(7, kStart));
  EXPECT_TRUE(others.hear(8, kStart));
  EXPECT_FALSE(others.hear(8, kStart + seconds(4)));

  EXPECT_EQ(others.count(kStart + seconds(4)), 2U);
  EXPECT_EQ(others.count(kStart + seconds(6)), 1U);
  EXPECT_EQ(others.count(kStart + seconds(10)), 0U);
  EXPECT_TRUE(others.hear(7, kStart + seconds(10))) << "it was gone";
}

TEST(OtherStations, AreNotRememberedWithoutBound) {
  OtherStations others(seconds(5));

  for (std::uint32_t boot = 1; boot < 1000; ++boot) others.hear(boot, kStart);

  EXPECT_EQ(others.count(kStart), 16U);
}

}  // namespace
}  // namespace teamsight::monitor
