// tests/vision/lanes_test.cpp: runs of equal bytes.
#include "vision/lanes.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace teamsight::vision {
namespace {

std::size_t counted(const std::vector<std::uint8_t>& bytes, std::uint8_t value) {
  return leading_eights(std::span(bytes), value);
}

TEST(LeadingEights, CountsNoMoreThanTheRun) {
  for (std::size_t run = 0; run <= 40; ++run) {
    std::vector<std::uint8_t> bytes(run, 7);
    bytes.resize(41, 9);

    EXPECT_EQ(counted(bytes, 7), run / 8 * 8) << run;
  }
}

TEST(LeadingEights, EndsWithTheBytes) {
  EXPECT_EQ(counted(std::vector<std::uint8_t>(23, 0), 0), 16U);
  EXPECT_EQ(counted(std::vector<std::uint8_t>(7, 0), 0), 0U);
  EXPECT_EQ(counted({}, 0), 0U);
}

}  // namespace
}  // namespace teamsight::vision
