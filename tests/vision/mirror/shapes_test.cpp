// tests/vision/mirror/shapes_test.cpp: the classical mirrors against their closed forms.
#include "vision/mirror/shapes.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "vision/mirror/trace.hpp"

namespace teamsight::mirror {
namespace {

using testing::HasSubstr;

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kPinholeHeight = 0.63;
const Rim kRim{0.09, 0.8};

/// Where a mirror shows the floor, by the code under test.
double floor_of(const Profile& profile, double tan_alpha) {
  const auto hit = find_hit(profile, tan_alpha);
  return floor_distance(reflect(hit->part, hit->node), kPinholeHeight).value();
}

/// Where the line through two points of the meridian plane meets the floor.
double line_to_floor(std::array<double, 2> from, std::array<double, 2> through) {
  const double per_height = (through[0] - from[0]) / (through[1] - from[1]);
  return through[0] - (kPinholeHeight + through[1]) * per_height;
}

/// Where the backward extension of a ray meets the axis.
double virtual_height(const Ray& ray) {
  return ray.origin.y + ray.origin.x / std::tan(ray.psi);
}

TEST(Plane, ShowsTheFloorFromTheMirroredPinhole) {
  const Profile plane{{{"plane", {{0.0, 0.17, 0.0}, {0.09, 0.17, 0.0}}}}};

  for (double x = 0.005; x < 0.09; x += 0.007) {
    EXPECT_NEAR(floor_of(plane, x / 0.17), line_to_floor({0.0, 2 * 0.17}, {x, 0.17}), 1e-12);
  }
}

TEST(Cone, ShowsTheFloorFromThePinholeMirroredInItsSide) {
  constexpr double kApex = 0.12;
  const double angle = 29.0 * kDegree;
  const Profile cone = make_profile(Cone{kApex, angle}, kRim, 20).value();
  // The pinhole's distance from the line is kApex cos(angle), along its normal (-sin, cos).
  const double twice = 2.0 * kApex * std::cos(angle);
  const std::array<double, 2> image{-twice * std::sin(angle), twice * std::cos(angle)};

  for (double x = 0.001; x < 0.09; x += 0.003) {
    const double y = kApex + x * std::tan(angle);
    EXPECT_NEAR(floor_of(cone, x / y), line_to_floor(image, {x, y}), 1e-9);
  }
}

TEST(Sphere, ReflectsByTheLawOfSines) {
  constexpr double kRadius = 0.185;
  constexpr double kCentre = 0.148 + kRadius;
  const Profile sphere = make_profile(Sphere{0.148, kRadius}, kRim, 800).value();

  for (double alpha = 0.01; alpha < 27.0 * kDegree; alpha += 0.013) {
    const double incidence = std::asin(kCentre * std::sin(alpha) / kRadius);
    const double central = incidence - alpha;
    const double x = kRadius * std::sin(central);
    const double y = kCentre - kRadius * std::cos(central);
    const double expected = x + (y + kPinholeHeight) * std::tan(2.0 * incidence - alpha);
    EXPECT_NEAR(floor_of(sphere, std::tan(alpha)), expected, 1e-7 * (1.0 + expected * expected));
  }
}

TEST(Paraboloid, GathersRaysAlongTheAxisInItsFocus) {
  const Profile paraboloid = make_profile(Paraboloid{0.146, 0.162}, kRim, 100).value();

  for (const Node& node : paraboloid.parts[0].nodes) {
    if (node.x > 0.0) {
      const Ray ray{0, node, reflected_angle(0.0, node.slope)};
      EXPECT_NEAR(virtual_height(ray), 0.146 + 0.162 / 2.0, 1e-12);
    }
  }
}

TEST(Hyperboloid, GathersCameraRaysInItsOtherFocus) {
  const Profile hyperboloid = make_profile(Hyperboloid{0.0517, 0.0724}, kRim, 800).value();
  const double other_focus = 2.0 * std::hypot(0.0517, 0.0724);

  for (double t = 0.001; t < 0.52; t += 0.0113) {
    const auto hit = find_hit(hyperboloid, t);
    EXPECT_NEAR(virtual_height(reflect(0, hit->node)), other_focus, 1e-8);
  }
  for (const Node& node : hyperboloid.parts[0].nodes) {
    // The focal distances differ by twice the semi-axis.
    EXPECT_NEAR(
        std::hypot(node.x, node.y) - std::hypot(node.x, node.y - other_focus), 2.0 * 0.0517, 1e-14);
  }
}

TEST(ConeWithApex, ShowsItsTwoDistancesAndHasOneTangentAtTheJoint) {
  const Rim rim{0.0925, 0.8};
  const Profile profile = make_profile(ConeWithApex{1.5, 6.0, 0.1714}, rim, 300).value();
  const double pinhole_height = rim.height - 0.1714;
  const Node& joint = profile.parts[1].nodes.front();
  const Node& end = profile.parts[1].nodes.back();
  const Node& before = profile.parts[0].nodes[299];

  EXPECT_NEAR(floor_distance(reflect(1, joint), pinhole_height).value(), 1.5, 1e-12);
  EXPECT_NEAR(floor_distance(reflect(1, end), pinhole_height).value(), 6.0, 1e-12);
  EXPECT_EQ(profile.parts[0].nodes.back(), joint);
  EXPECT_NEAR(end.slope, (end.y - joint.y) / (end.x - joint.x), 1e-13);
  // the sphere itself arrives with the cone's tangent: its centre is on the axis, across the
  // tangent
  const double centre = joint.y + joint.x / joint.slope;
  EXPECT_NEAR(
      std::hypot(before.x, before.y - centre), std::hypot(joint.x, joint.y - centre), 1e-15);
}

TEST(ConeWithApex, SaysWhenTheConeCannotSeeAsNearAsTheJoint) {
  const auto profile = make_profile(ConeWithApex{0.5, 6.0, 0.1714}, {0.0925, 0.8}, 10);

  ASSERT_FALSE(profile.has_value());
  EXPECT_EQ(profile.error().condition, Condition::kSolution);
  EXPECT_THAT(profile.error().text, HasSubstr("beyond the joint's 0.500 m"));
  EXPECT_NEAR(profile.error().amount, 0.55, 0.1);
}

TEST(ConeWithApex, SaysWhenTheCameraLooksTooFlat) {
  const auto profile = make_profile(ConeWithApex{1.5, 6.0, 0.01}, {0.0925, 0.8}, 10);

  ASSERT_FALSE(profile.has_value());
  EXPECT_THAT(profile.error().text, HasSubstr("deg flatter"));
}

TEST(Sphere, SaysWhenItIsSmallerThanTheRim) {
  const auto profile = make_profile(Sphere{0.1, 0.08}, kRim, 10);

  ASSERT_FALSE(profile.has_value());
  EXPECT_NEAR(profile.error().amount, 0.01, 1e-12);
  EXPECT_THAT(profile.error().text, HasSubstr("0.0100 m too wide"));
}

}  // namespace
}  // namespace teamsight::mirror
