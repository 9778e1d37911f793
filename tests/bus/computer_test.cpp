// tests/bus/computer_test.cpp: whose process it is, from what its participant announces.
#include "bus/computer.hpp"

#include <gtest/gtest.h>

namespace teamsight::bus {
namespace {

TEST(Computer, IsAtTheFirstAddressThatIsNoGroup) {
  EXPECT_EQ(unicast_address_in("udp/239.255.0.1:7400@2,udp/192.168.1.12:7410@2"), "192.168.1.12");
  EXPECT_EQ(unicast_address_in("udp/239.255.0.1:7400@2"), "");
  EXPECT_EQ(unicast_address_in("localprocess"), "");
  EXPECT_EQ(unicast_address_in("udp/fe80::1:7400,,udp/10.0.0.7:1"), "10.0.0.7");
  EXPECT_EQ(unicast_address_in(""), "");
}

TEST(Computer, IsThisOneOnLoopbackAndNotOnAnotherNetwork) {
  EXPECT_TRUE(is_own_address("127.0.0.1"));
  EXPECT_FALSE(is_own_address("203.0.113.77"));
  EXPECT_FALSE(is_own_address("nonsense"));
  EXPECT_FALSE(is_own_address(""));
}

TEST(Computer, IsToldByNameAndAddressAsFarAsTheyAreKnown) {
  EXPECT_EQ(to_text({"omni2", "192.168.1.12", false}), "omni2 (192.168.1.12)");
  EXPECT_EQ(to_text({"omni2", "", false}), "omni2");
  EXPECT_EQ(to_text({}), "another computer");
  EXPECT_EQ(to_text({"omni2", "192.168.1.12", true}), "this computer");
}

}  // namespace
}  // namespace teamsight::bus
