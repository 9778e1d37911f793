// tests/vision/mirror/curvature_test.cpp: the arc is a circle with the right tangents.
#include "vision/mirror/curvature.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include "vision/mirror/trace.hpp"

namespace teamsight::mirror {
namespace {

const Node kStart{0.058, 0.1646, 0.61};

TEST(Arc, LiesOnOneCircle) {
  const Arc arc = make_arc(kStart, 0.069, 0.59);
  const double angle = std::atan(kStart.slope);
  const double radius = 1.0 / arc.curvature;
  const double centre_x = kStart.x - radius * std::sin(angle);
  const double centre_y = kStart.y + radius * std::cos(angle);

  for (const Node& node : sample(arc, 50)) {
    EXPECT_NEAR(std::hypot(node.x - centre_x, node.y - centre_y), radius, 1e-14);
    // the tangent is across the radius
    EXPECT_NEAR((node.x - centre_x) + node.slope * (node.y - centre_y), 0.0, 1e-14);
  }
}

TEST(Arc, BeginsWithTheTangentOfAAndEndsWithThatOfB) {
  const auto nodes = sample(make_arc(kStart, 0.069, 0.59), 7);

  EXPECT_EQ(nodes.size(), 8U);
  EXPECT_NEAR(nodes.front().slope, kStart.slope, 1e-15);
  EXPECT_NEAR(nodes.front().y, kStart.y, 1e-15);
  EXPECT_NEAR(nodes.back().x, 0.069, 1e-15);
  EXPECT_NEAR(std::atan(nodes.back().slope), 0.59, 1e-14);
}

TEST(Arc, IsAStraightLineBetweenEqualTangents) {
  const Arc arc = make_arc(kStart, 0.069, std::atan(kStart.slope));

  EXPECT_NEAR(arc.curvature, 0.0, 1e-13);
  EXPECT_NEAR(at(arc, 0.069).y, kStart.y + 0.011 * kStart.slope, 1e-15);
}

TEST(Arc, MayBendTheOtherWay) {
  const Arc arc = make_arc(kStart, 0.069, 0.5);

  EXPECT_LT(arc.curvature, 0.0);
  EXPECT_NEAR(std::atan(at(arc, 0.069).slope), 0.5, 1e-14);
}

struct FarCondition {
  double max_distance;
  double max_height;
};

class OuterSlope : public testing::TestWithParam<FarCondition> {};

TEST_P(OuterSlope, SendsTheRayThroughTheHeightAtTheDistance) {
  const auto [max_distance, max_height] = GetParam();
  constexpr double kX = 0.0688;
  constexpr double kY = 0.1714;
  constexpr double kPinholeHeight = 0.6286;

  const double angle =
      outer_slope_angle(kX / kY, kX, kPinholeHeight + kY, max_distance, max_height);
  const Ray ray = reflect(0, {kX, kY, std::tan(angle)});

  ASSERT_TRUE(height_at(ray, kPinholeHeight, max_distance).has_value());
  EXPECT_NEAR(*height_at(ray, kPinholeHeight, max_distance), max_height, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(NearFarLowAndRising,
                         OuterSlope,
                         testing::Values(FarCondition{11.2, 0.6},
                                         FarCondition{18.0, 0.9},
                                         FarCondition{3.0, 0.0},
                                         FarCondition{5.0, 2.0}));

}  // namespace
}  // namespace teamsight::mirror
