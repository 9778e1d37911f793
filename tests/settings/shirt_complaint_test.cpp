// tests/settings/shirt_complaint_test.cpp: what an operator reads of shirts that no class tells.
#include "settings/shirt_complaint.hpp"

#include <gtest/gtest.h>

namespace teamsight::settings {
namespace {

using vision::ColourClass;

constexpr vision::TeamShirts kShirts{ColourClass::kCyan, ColourClass::kMagenta};

TEST(ShirtComplaint, IsSilentWhereBothColoursHaveAClassOrNobodySaysWhatIsWorn) {
  vision::ColourParameters colours;
  colours.samples = {{ColourClass::kCyan, 150, 100, 20}};
  colours.sectors = {{ColourClass::kMagenta, 0.5, 1.0}};

  EXPECT_EQ(shirt_complaint(kShirts, colours), "");
  EXPECT_EQ(shirt_complaint({}, {}), "");
}

TEST(ShirtComplaint, NamesWhatHasNoClass) {
  vision::ColourParameters colours;
  colours.samples = {{ColourClass::kCyan, 150, 100, 20}};

  EXPECT_EQ(shirt_complaint(kShirts, colours),
            "the camera file has no class MAGENTA (opponent_shirt) of the team file: "
            "add it to colours, or nobody is known by it");
  EXPECT_EQ(shirt_complaint(kShirts, {}),
            "the camera file has no class CYAN (shirt) and MAGENTA (opponent_shirt) of the team "
            "file: add it to colours, or nobody is known by it");
}

TEST(ShirtComplaint, AsksOnlyWhatTellsTheCamerasColours) {
  vision::ColourParameters colours;
  colours.samples = {{ColourClass::kCyan, 150, 100, 20}, {ColourClass::kMagenta, 150, 170, 20}};
  colours.table.assign(vision::kClassCells, ColourClass::kGreen);
  colours.table[7] = ColourClass::kMagenta;

  EXPECT_EQ(shirt_complaint(kShirts, colours),
            "the camera file has no class CYAN (shirt) of the team file: "
            "add it to colours, or nobody is known by it");

  colours.method = vision::ColourMethod::kCube;
  colours.cube.emplace().classes[3] = ColourClass::kCyan;
  EXPECT_EQ(shirt_complaint({ColourClass::kCyan, ColourClass::kNone}, colours), "");
}

}  // namespace
}  // namespace teamsight::settings
