// tests/agent/drift_complaint_test.cpp: what an operator reads when the mirror was bumped.
#include "agent/drift_complaint.hpp"

#include <gtest/gtest.h>

namespace teamsight::agent {
namespace {

TEST(DriftComplaint, NamesTheDirectionOfAPictureThatMoved) {
  EXPECT_EQ(drift_complaint({.drift_px = 2.3, .size_px = 0.2, .shift_px = {-2.3, 2.3}}),
            "picture off by 2.3 px (towards 135 deg): check the mirror, teamsight calibrate lines");
}

TEST(DriftComplaint, NamesNoDirectionWhenOnlyTheSizeChanged) {
  EXPECT_EQ(drift_complaint({.drift_px = 1.5, .size_px = -1.49, .shift_px = {0.1, 0.1}}),
            "picture off by 1.5 px (smaller): check the mirror, teamsight calibrate lines");
}

TEST(DriftComplaint, NamesBothInTheRoomThereIs) {
  const std::string text =
      drift_complaint({.drift_px = 99.9, .size_px = -70.0, .shift_px = {-100.0, -0.1}});

  EXPECT_EQ(text.size(), 95U) << text;
  EXPECT_NE(text.find("(smaller, towards -180 deg)"), std::string::npos) << text;
}

TEST(DriftComplaint, NeverOutgrowsAReport) {
  EXPECT_EQ(drift_complaint({.drift_px = 1e6, .size_px = -7e5, .shift_px = {-1e6, -1.0}}).size(),
            95U);
}

}  // namespace
}  // namespace teamsight::agent
