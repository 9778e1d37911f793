// tests/monitor/own_page_test.cpp: which requests may be answered.
#include <gtest/gtest.h>

#include "monitor/web_server.hpp"

namespace teamsight::monitor {
namespace {

TEST(OwnPage, IsAnyPageThisComputerServedByNumberOrAsLocalhost) {
  EXPECT_TRUE(is_own_page("127.0.0.1:8080", "http://127.0.0.1:8080"));
  EXPECT_TRUE(is_own_page("localhost:8080", "http://localhost:8080"));
  EXPECT_TRUE(is_own_page("[::1]:8080", "http://[::1]:8080"));
  EXPECT_TRUE(is_own_page("192.168.1.7", "http://192.168.1.7"));
}

TEST(OwnPage, HasNoOriginWhereTheClientIsNoBrowser) {
  EXPECT_TRUE(is_own_page("127.0.0.1:8080", ""));
}

TEST(OwnPage, IsNotAPageOfAnotherSiteOrPort) {
  EXPECT_FALSE(is_own_page("127.0.0.1:8080", "http://evil.example"));
  EXPECT_FALSE(is_own_page("127.0.0.1:8080", "http://127.0.0.1:9090"));
  EXPECT_FALSE(is_own_page("127.0.0.1:8080", "https://127.0.0.1:8080"));
  EXPECT_FALSE(is_own_page("127.0.0.1:8080", "null"));
}

TEST(OwnPage, IsNotReachedUnderAForeignName) {
  EXPECT_FALSE(is_own_page("evil.example:8080", "http://evil.example:8080"));
  EXPECT_FALSE(is_own_page("evil.example", ""));
  EXPECT_FALSE(is_own_page("", ""));
  EXPECT_FALSE(is_own_page(":8080", ""));
}

}  // namespace
}  // namespace teamsight::monitor
