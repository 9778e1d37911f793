// tests/vision/mirror/multi_part_test.cpp: the multi-part mirror closes, with the known numbers.
#include "vision/mirror/multi_part.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "tests/vision/mirror/mirrors.hpp"
#include "vision/mirror/trace.hpp"

namespace teamsight::mirror {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

constexpr double kDegree = std::numbers::pi / 180.0;
const Rim kRim{0.09, 0.8};

TEST(MultiPart, ClosesWithTheVerifiedNumbers) {
  const MultiPartSolution s = solve(MultiPart{}, kRim).value();

  EXPECT_NEAR(s.point_A.x, 58.1649375e-3, 5e-11);
  EXPECT_NEAR(s.point_A.y, 164.63602e-3, 5e-9);
  EXPECT_NEAR(s.point_B.x, 68.8235294e-3, 5e-11);
  EXPECT_NEAR(s.point_B.y, 171.4285714e-3, 5e-11);
  EXPECT_NEAR(s.isometric.pinhole_height, 0.628571429, 5e-10);
  EXPECT_NEAR(s.isometric.eta, 16.983017, 5e-7);
  EXPECT_NEAR(s.isometric.apex, 131.437699e-3, 5e-10);
  EXPECT_NEAR(1.0 / s.arc.curvature, 348.306217e-3, 5e-10);
  EXPECT_NEAR(std::atan(s.point_A.slope) / kDegree, 31.469110, 5e-7);
  EXPECT_NEAR(std::atan(s.point_B.slope) / kDegree, 33.548318, 5e-7);
  EXPECT_EQ(s.point_C, (Node{0.09, s.point_B.y, 0.0}));
}

TEST(MultiPart, HasTheCentreOfTheArcWhereItBelongs) {
  const MultiPartSolution s = solve(MultiPart{}, kRim).value();
  const double radius = 1.0 / s.arc.curvature;
  const double angle = std::atan(s.point_A.slope);

  EXPECT_NEAR(s.point_A.x - radius * std::sin(angle), -123.664424e-3, 5e-10);
  EXPECT_NEAR(s.point_A.y + radius * std::cos(angle), 461.713963e-3, 5e-10);
}

struct Member {
  double share;
  double eta;
  double apex_mm;
  double radius_mm;
};

class DesignFamily : public testing::TestWithParam<Member> {};

TEST_P(DesignFamily, HasTheKnownNumbers) {
  MultiPart parameters;
  parameters.isometric_share = GetParam().share;

  const MultiPartSolution s = solve(parameters, kRim).value();

  EXPECT_NEAR(s.isometric.eta, GetParam().eta, 0.006);
  EXPECT_NEAR(s.isometric.apex * 1e3, GetParam().apex_mm, 0.0006);
  EXPECT_NEAR(1e3 / s.arc.curvature, GetParam().radius_mm, 0.005 * GetParam().radius_mm);
}

INSTANTIATE_TEST_SUITE_P(OverTheShare,
                         DesignFamily,
                         testing::Values(Member{0.70, 21.35, 128.765, 12200.0},
                                         Member{0.75, 19.93, 129.500, 2133.0},
                                         Member{0.80, 18.68, 130.240, 967.0},
                                         Member{0.85, 17.58, 130.986, 511.0},
                                         Member{0.92, 16.245, 132.044, 195.0}));

TEST(MultiPart, HasTheImageOfTheDesign) {
  const Mirror mirror = design(test::default_parameters()).value();
  const auto samples = sample_floor(mirror.assembly);

  EXPECT_NEAR(mirror.assembly.focal_px, 975.24, 0.005);
  EXPECT_NEAR(
      mirror.assembly.focal_px * mirror.multi_part->point_A.x / mirror.multi_part->point_A.y,
      344.5,
      0.05);
  EXPECT_NEAR(
      mirror.assembly.focal_px * mirror.multi_part->point_B.x / mirror.multi_part->point_B.y,
      391.5,
      0.05);
  EXPECT_NEAR(pixel_error(samples, 3.0).value(), 17.414e-3, 5e-7);
  EXPECT_NEAR(pixel_error(samples, 0.45).value(), 0.996e-3, 5e-7);
}

TEST(MultiPart, ShowsTheMiddleZoneWhereItShould) {
  const Mirror mirror = design(test::default_parameters()).value();
  const auto floor_at = [&](double share) {
    const double radius = 344.5458824 + share * (391.5294118 - 344.5458824);
    return *floor_distance(*trace(mirror.assembly, radius), mirror.assembly.pinhole_height);
  };

  EXPECT_NEAR(floor_at(0.25), 7.6, 0.05);
  EXPECT_NEAR(floor_at(0.50), 10.5, 0.05);
  EXPECT_NEAR(floor_at(0.75), 16.9, 0.1);
}

TEST(MultiPart, IsToScaleBetweenItsNodesToo) {
  const Mirror mirror = design(test::default_parameters()).value();
  const double scale = 6.0 / 344.54588235294;

  for (double radius = 0.0137; radius < 344.5; radius += 0.37) {
    const auto floor =
        floor_distance(*trace(mirror.assembly, radius), mirror.assembly.pinhole_height);
    ASSERT_NEAR(floor.value(), scale * radius, 1e-6) << radius << " px";
  }
}

struct Broken {
  MultiPart parameters;
  Rim rim;
  std::string words;
};

class BrokenDesign : public testing::TestWithParam<Broken> {};

TEST_P(BrokenDesign, SaysWhatFailsAndByHowMuch) {
  const auto solution = solve(GetParam().parameters, GetParam().rim);

  ASSERT_FALSE(solution.has_value());
  EXPECT_EQ(solution.error().condition, Condition::kSolution);
  EXPECT_THAT(solution.error().text, StartsWith("no solution: "));
  EXPECT_THAT(solution.error().text, HasSubstr(GetParam().words));
  EXPECT_GT(solution.error().amount, 0.0);
}

INSTANTIATE_TEST_SUITE_P(
    Reasons,
    BrokenDesign,
    testing::Values(Broken{{.ring_near = 0.6}, {0.09, 0.8}, "0.600 m, is not nearer than"},
                    Broken{{}, {0.3, 0.8}, "needs the pinhole below the floor, 0.090 m nearer"},
                    Broken{{.max_distance = 0.05}, {0.09, 0.8}, "max_distance lies inside"}));

TEST(MultiPart, ClosesOverAWideRangeOfSplitsAndDistances) {
  for (const double share : {0.1, 0.3, 0.5, 0.95, 0.99}) {
    for (const double range : {0.5, 1.5, 3.0, 6.0, 10.0}) {
      const auto s = solve({.isometric_range = range, .isometric_share = share}, kRim);

      ASSERT_TRUE(s.has_value()) << share << ", " << range << " m: " << s.error().text;
      EXPECT_NEAR(at(s->arc, s->point_B.x).y, s->point_B.y, 1e-12);
      EXPECT_LT(s->point_A.x, s->point_B.x);
    }
  }
}

TEST(MultiPart, IsRefusedWhereItsOutermostRayWouldMeetTheRing) {
  MirrorParameters parameters = test::default_parameters();
  parameters.shape = MultiPart{.max_height = 2.0};

  const auto mirror = design(parameters);

  ASSERT_FALSE(mirror.has_value());
  EXPECT_EQ(mirror.error().condition, Condition::kSecondHit);
  // the ray of B rises by atan(1.2 / 11.13), the ring is level
  EXPECT_NEAR(mirror.error().amount, std::atan2(2.0 - 0.8, 11.2 - 0.0688235), 1e-6);
}

TEST(MultiPart, IsRefusedWhereItsArcWouldShowTheFloorTwice) {
  MirrorParameters parameters = test::default_parameters();
  parameters.shape = MultiPart{.isometric_range = 10.0, .isometric_share = 0.3};

  const auto mirror = design(parameters);

  ASSERT_FALSE(mirror.has_value());
  EXPECT_EQ(mirror.error().condition, Condition::kFloorOrder);
  EXPECT_THAT(mirror.error().text, HasSubstr("floor seen twice: a part's view turns back by"));
}

}  // namespace
}  // namespace teamsight::mirror
