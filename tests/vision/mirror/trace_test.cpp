// tests/vision/mirror/trace_test.cpp: single rays, the body, and what is seen of the floor.
#include "vision/mirror/trace.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>

#include "tests/vision/mirror/mirrors.hpp"

namespace teamsight::mirror {
namespace {

constexpr double kPi = std::numbers::pi;

/// A plane mirror 0.2 m over the pinhole, 0.8 m over the floor: the floor at 5 x.
Assembly plane(std::vector<BodyCylinder> body) {
  Part part{"plane", {}};
  for (int i = 0; i <= 20; ++i) {
    part.nodes.push_back({0.005 * i, 0.2, 0.0});
  }
  return {.profile = {{part}}, .pinhole_height = 0.6, .focal_px = 1000.0, .body = std::move(body)};
}

TEST(Trace, FollowsAPixelToTheFloor) {
  const auto ray = trace(plane({}), 250.0);

  ASSERT_TRUE(ray.has_value());
  EXPECT_NEAR(ray->origin.x, 0.05, 1e-15);
  EXPECT_NEAR(floor_distance(*ray, 0.6).value(), 0.25, 1e-14);
  EXPECT_NEAR(height_at(*ray, 0.6, 0.15).value(), 0.4, 1e-14);
}

TEST(Trace, SeesNothingBesideTheMirror) {
  EXPECT_TRUE(trace(plane({}), 500.0).has_value());
  EXPECT_FALSE(trace(plane({}), 500.1).has_value());
}

TEST(Trace, HasNoFloorAtOrAboveTheHorizon) {
  EXPECT_FALSE(floor_distance({0, {0.05, 0.2, 1.0}, kPi / 2}, 0.6).has_value());
  EXPECT_FALSE(floor_distance({0, {0.05, 0.2, 1.0}, 1.7}, 0.6).has_value());
}

TEST(Trace, HasNoHeightBehindItsOriginOrBelowTheFloor) {
  const Ray ray{0, {0.05, 0.2, 0.0}, kPi / 4};

  EXPECT_FALSE(height_at(ray, 0.6, 0.04).has_value());
  EXPECT_NEAR(height_at(ray, 0.6, 0.05).value(), 0.8, 1e-14);
  EXPECT_FALSE(height_at(ray, 0.6, 0.86).has_value());
}

TEST(Trace, RisingRayHasAHeightAtEveryDistance) {
  const Ray ray{0, {0.05, 0.2, 1.0}, 3 * kPi / 4};

  EXPECT_NEAR(height_at(ray, 0.6, 2.05).value(), 2.8, 1e-12);
}

TEST(BodyClearance, IsMeasuredAtTheTopEdges) {
  const Assembly assembly = plane({{0.3, 0.12}, {0.5, 0.05}});
  const Ray ray = reflect(0, {0.05, 0.2, 0.0});  // falls from 0.8 m by 4 per distance

  // at 0.3 m height it is 0.175 m out, at 0.5 m 0.125 m
  EXPECT_NEAR(body_clearance(ray, assembly), 0.055, 1e-14);
}

TEST(BodyClearance, IsInfiniteWithoutABodyBelow) {
  const Ray ray = reflect(0, {0.05, 0.2, 0.0});

  EXPECT_EQ(body_clearance(ray, plane({})), std::numeric_limits<double>::infinity());
  EXPECT_EQ(body_clearance(ray, plane({{0.9, 0.5}})), std::numeric_limits<double>::infinity());
}

TEST(VisibleFloor, BeginsWhereTheBodyEnds) {
  // over the edge at 0.4 m height, 0.12 m out: half-way down, so 0.24 m less x on the floor, x =
  // 0.04
  const auto views = visible_floor(sample_floor(plane({{0.4, 0.12}})));

  ASSERT_EQ(views.size(), 1U);
  EXPECT_NEAR(views[0].near, 0.20, 1e-12);
  EXPECT_NEAR(views[0].far, 0.50, 1e-12);
  EXPECT_NEAR(blind_radius(views).value(), 0.20, 1e-12);
}

TEST(VisibleFloor, IsNothingBelowAWideBody) {
  const auto views = visible_floor(sample_floor(plane({{0.4, 0.5}})));

  EXPECT_TRUE(views.empty());
  EXPECT_FALSE(blind_radius(views).has_value());
}

TEST(PixelError, IsTheScaleOfAPlane) {
  const auto samples = sample_floor(plane({}));

  EXPECT_NEAR(pixel_error(samples, 0.33).value(), 1e-3, 1e-12);  // 0.5 m over 500 px
  EXPECT_NEAR(pixel_error(samples, 0.5).value(), 1e-3, 1e-12);
  EXPECT_FALSE(pixel_error(samples, 0.51).has_value());
}

TEST(PixelError, AgreesWithTwoTracedPixels) {
  const Mirror mirror = test::designed("sphere");
  const auto samples = sample_floor(mirror.assembly);
  const auto floor_at = [&](double radius) {
    return *floor_distance(*trace(mirror.assembly, radius), mirror.assembly.pinhole_height);
  };

  for (const double radius : {300.0, 400.0, 480.0, 511.4}) {
    const double slope = (floor_at(radius + 0.01) - floor_at(radius - 0.01)) / 0.02;
    EXPECT_NEAR(pixel_error(samples, floor_at(radius)).value(), slope, 1e-3 * slope) << radius;
  }
}

TEST(PixelError, TakesTheFinestPartWhereTwoShowTheSameFloor) {
  const auto samples = sample_floor(test::designed("multi_part").assembly);

  EXPECT_NEAR(pixel_error(samples, 0.5).value(), 0.996e-3, 1e-6);    // isometric part and ring
  EXPECT_NEAR(pixel_error(samples, 0.52).value(), 17.414e-3, 1e-6);  // isometric part alone
}

}  // namespace
}  // namespace teamsight::mirror
