// tests/vision/mirror/checks_test.cpp: each condition fails alone, with its amount.
#include "vision/mirror/checks.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>

#include "tests/vision/mirror/mirrors.hpp"

namespace teamsight::mirror {
namespace {

using testing::HasSubstr;

constexpr double kDegree = std::numbers::pi / 180.0;

/// A straight piece of the meridian with 20 nodes.
Part straight(double from, double to, double y, double slope, bool kinked = false) {
  Part part{"straight", {}, kinked};
  for (int i = 0; i < 20; ++i) {
    const double x = from + (to - from) * i / 19.0;
    part.nodes.push_back({x, y + slope * (x - from), slope});
  }
  return part;
}

Assembly with(std::vector<Part> parts) {
  return {.profile = {std::move(parts)}, .pinhole_height = 0.6, .focal_px = 900.0, .body = {}};
}

TEST(Checks, PassAConeAndMeasureItsMargins) {
  const auto margins = check(with({straight(0.0, 0.08, 0.12, 0.5)}));

  ASSERT_TRUE(margins.has_value());
  // camera ray at the rim atan(0.5) from the axis, surface atan(0.5) from the horizontal
  EXPECT_NEAR(margins->facing.value / kDegree, 90.0 - 2 * 26.565051, 1e-5);
  EXPECT_NEAR(margins->facing.x, 0.08, 1e-12);
  EXPECT_NEAR(margins->second_hit.value, margins->facing.value, 1e-12);
  EXPECT_FALSE(margins->ring_clearance.has_value());
}

TEST(Checks, RefuseAProfileThatGoesBack) {
  Part part = straight(0.0, 0.08, 0.12, 0.5);
  part.nodes[7].x = part.nodes[6].x - 0.001;

  const auto margins = check(with({part}));

  ASSERT_FALSE(margins.has_value());
  EXPECT_EQ(margins.error().condition, Condition::kFunction);
  EXPECT_NEAR(margins.error().amount, 0.001, 1e-12);
}

TEST(Checks, RefuseWhatIsNotFinite) {
  for (double Node::*const member : {&Node::x, &Node::y, &Node::slope}) {
    Part part = straight(0.0, 0.08, 0.12, 0.5);
    part.nodes[7].*member = std::numeric_limits<double>::quiet_NaN();

    EXPECT_EQ(check(with({part})).error().condition, Condition::kFunction);
  }
}

TEST(Checks, RefuseAGapBetweenParts) {
  const auto margins =
      check(with({straight(0.0, 0.04, 0.12, 0.5), straight(0.04, 0.08, 0.141, 0.5)}));

  ASSERT_FALSE(margins.has_value());
  EXPECT_EQ(margins.error().condition, Condition::kFunction);
  EXPECT_NEAR(margins.error().amount, 0.001, 1e-12);
  EXPECT_THAT(margins.error().text, HasSubstr("0.001 m apart"));
}

TEST(Checks, RefuseASlopeJumpAtASmoothJointOnly) {
  const auto smooth =
      check(with({straight(0.0, 0.04, 0.12, 0.5), straight(0.04, 0.08, 0.14, 0.52)}));
  const auto kinked =
      check(with({straight(0.0, 0.04, 0.12, 0.5), straight(0.04, 0.08, 0.14, 0.52, true)}));

  ASSERT_FALSE(smooth.has_value());
  EXPECT_EQ(smooth.error().condition, Condition::kSlopeJump);
  EXPECT_NEAR(smooth.error().amount, 0.02, 1e-12);
  EXPECT_TRUE(kinked.has_value());
}

TEST(Checks, RefuseADentInsideAPart) {
  Part part = straight(0.0, 0.08, 0.12, 0.5);
  part.nodes[7].slope = 0.8;

  const auto margins = check(with({part}));

  ASSERT_FALSE(margins.has_value());
  EXPECT_EQ(margins.error().condition, Condition::kSlopeJump);
  EXPECT_NEAR(margins.error().amount, 0.3, 1e-12);
}

TEST(Checks, RefuseASurfaceThatTheCameraSeesFromBehind) {
  // 30 degrees from the axis at the rim, where the surface is 70 degrees steep
  const double slope = std::tan(70.0 * kDegree);
  const auto margins =
      check(with({straight(0.09, 0.1, 0.1 / std::tan(30.0 * kDegree) - 0.01 * slope, slope)}));

  ASSERT_FALSE(margins.has_value());
  EXPECT_EQ(margins.error().condition, Condition::kFacing);
  EXPECT_GE(margins.error().amount / kDegree, 10.0 - 1e-9);
  EXPECT_THAT(margins.error().text, HasSubstr("turned away by"));
}

TEST(Checks, RefuseARayThatMeetsTheMirrorAgain) {
  // the steep cone sends its rays up, under the flat rim that follows
  const double slope = std::tan(44.0 * kDegree);
  const auto margins = check(with(
      {straight(0.0, 0.04, 0.12, slope), straight(0.04, 0.1, 0.12 + 0.04 * slope, 0.0, true)}));

  ASSERT_FALSE(margins.has_value());
  EXPECT_EQ(margins.error().condition, Condition::kSecondHit);
  // worst from just inside the joint: alpha + 2 * 44 - 90 degrees above the horizontal
  const double alpha = std::atan2(0.04, 0.12 + 0.04 * slope);
  EXPECT_NEAR(margins.error().amount, alpha - 2.0 * kDegree, 1e-6);
}

TEST(Checks, RefuseAPartThatShowsTheFloorTwice) {
  Part part{"bowl", {}};
  for (int i = 0; i <= 40; ++i) {  // concave: the slope falls from 0.6 to 0.2
    const double x = 0.002 * i;
    part.nodes.push_back({x, 0.12 + 0.6 * x - 2.5 * x * x, 0.6 - 5.0 * x});
  }

  const auto margins = check(with({part}));

  ASSERT_FALSE(margins.has_value());
  EXPECT_EQ(margins.error().condition, Condition::kFloorOrder);
  EXPECT_GT(margins.error().amount, 0.0);
}

TEST(Checks, RefuseABodyThatHidesTheRing) {
  MirrorParameters parameters = test::default_parameters();
  parameters.body = {{0.4, 0.25}};

  const auto mirror = design(parameters);

  // the inner ray passes X_B + (0.8 - 0.4) X_B / Y_B = 0.2294 m out
  ASSERT_FALSE(mirror.has_value());
  EXPECT_EQ(mirror.error().condition, Condition::kRingHidden);
  EXPECT_NEAR(mirror.error().amount, 0.25 - 0.22941176, 1e-8);
  EXPECT_THAT(mirror.error().text, HasSubstr("passes 0.2294 m from the axis at height 0.400 m"));
}

TEST(Checks, ReportTheRoomBetweenRingAndBody) {
  MirrorParameters parameters = test::default_parameters();
  parameters.body = {{0.4, 0.2}};

  EXPECT_NEAR(design(parameters)->margins.ring_clearance->value, 0.02941176, 1e-8);
}

TEST(Checks, PassEveryMirrorOfTheRepositoryWithRoomToSpare) {
  for (const std::string& file : test::kMirrorFiles) {
    const Margins margins = test::designed(file).margins;

    EXPECT_GT(margins.facing.value, 20.0 * kDegree) << file;
    EXPECT_GT(margins.second_hit.value, 0.5 * kDegree) << file;
    EXPECT_LT(margins.joint_slope_jump.value, 1e-9) << file;
  }
}

TEST(Design, SaysWhenThePinholeWouldBeBelowTheFloor) {
  MirrorParameters parameters = test::default_parameters();
  parameters.shape = Cone{0.9, 0.4};

  const auto mirror = design(parameters);

  ASSERT_FALSE(mirror.has_value());
  EXPECT_EQ(mirror.error().condition, Condition::kSolution);
  EXPECT_NEAR(mirror.error().amount, 0.9 + 0.09 * std::tan(0.4) - 0.8, 1e-12);
}

TEST(Design, TakesTheFocalLengthInsteadOfTheRimsImage) {
  MirrorParameters parameters = test::default_parameters();
  parameters.scale = FocalPx{914.3};

  EXPECT_EQ(design(parameters)->assembly.focal_px, 914.3);
}

}  // namespace
}  // namespace teamsight::mirror
