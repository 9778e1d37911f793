// tests/vision/mirror/isometric_test.cpp: the isometric part satisfies its equation, both ways.
#include "vision/mirror/isometric.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>

namespace teamsight::mirror {
namespace {

using testing::DoubleNear;
using testing::Lt;

const IsometricParameters kParameters{16.983016983, 0.628571428571, 0.131437698502, 0.353294117647};

/// The floor distance that a point of the profile shows, by the law of reflection.
double floor_of(const Node& node) {
  const double psi = std::atan2(node.x, node.y) + 2.0 * std::atan(node.slope);
  return node.x + (node.y + kParameters.pinhole_height) * std::tan(psi);
}

TEST(Isometric, MapsTheFloorToTheImageAtOneScale) {
  const auto nodes = integrate_isometric(kParameters, 400);

  ASSERT_TRUE(nodes.has_value());
  for (const Node& node : *nodes) {
    EXPECT_THAT(floor_of(node), DoubleNear(kParameters.eta * node.x / node.y, 1e-9));
  }
}

TEST(Isometric, HasTheSlopeOfItsOwnPoints) {
  const auto nodes = integrate_isometric(kParameters, 2000).value();
  double worst = 0.0;

  for (std::size_t i = 2; i + 2 < nodes.size(); ++i) {
    // Parametrised by the image, where the nodes are equally spaced: fourth order in y and in x.
    const auto rate = [&](auto member) {
      return 8.0 * (nodes[i + 1].*member - nodes[i - 1].*member) -
             (nodes[i + 2].*member - nodes[i - 2].*member);
    };
    worst = std::max(worst, std::abs(rate(&Node::y) / rate(&Node::x) - nodes[i].slope));
  }

  EXPECT_THAT(worst, Lt(1e-9));
}

TEST(Isometric, BeginsFlatWithTheCurvatureOfTheEquation) {
  const auto [eta, H, Y0, end] = kParameters;
  const double curvature = 0.5 * ((eta - Y0) / (Y0 * (Y0 + H)) - 1.0 / Y0);

  const auto nodes = integrate_isometric(kParameters, 4000).value();

  EXPECT_EQ(nodes[0], (Node{0.0, Y0, 0.0}));
  EXPECT_NEAR(nodes[1].slope / nodes[1].x, curvature, 1e-3 * curvature);
  EXPECT_NEAR(1.0 / curvature, 0.012416, 1e-6);
}

TEST(Isometric, IsConvexFirstAndSlightlyConcaveOutside) {
  const auto nodes = integrate_isometric(kParameters, 4000).value();

  const auto steepest = std::max_element(
      nodes.begin(), nodes.end(), [](const Node& a, const Node& b) { return a.slope < b.slope; });

  EXPECT_NEAR(steepest->x, 0.03113, 1e-4);
  EXPECT_NEAR(std::atan(steepest->slope) * 180.0 / std::numbers::pi, 32.881, 1e-3);
  EXPECT_NEAR(floor_of(*steepest), 3.58, 0.02);
}

TEST(Isometric, DoesNotDependOnTheNumberOfNodes) {
  const auto few = integrate_isometric(kParameters, 1).value();
  const auto many = integrate_isometric(kParameters, 3000).value();

  EXPECT_NEAR(few.back().y, many.back().y, 1e-12);
  EXPECT_NEAR(few.back().slope, many.back().slope, 1e-10);
}

TEST(Isometric, LocalConstructionConvergesAtFirstOrder) {
  const auto coarse = compare_integrations(kParameters, 500).value();
  const auto fine = compare_integrations(kParameters, 1000).value();

  EXPECT_NEAR(coarse.profile / fine.profile, 2.0, 0.05);
  EXPECT_NEAR(coarse.ground / fine.ground, 2.0, 0.05);
}

TEST(Isometric, OneFacetPerPixelIsWrongByMoreThanAPixelAtTheEdge) {
  const auto difference = compare_integrations(kParameters, 345).value();

  EXPECT_NEAR(difference.profile, 52.4e-6, 0.1e-6);
  EXPECT_NEAR(difference.ground, 0.0251, 1e-4);
  EXPECT_NEAR(difference.ground_range, 6.0, 1e-9);
}

TEST(Isometric, LocalConstructionSendsEachCornersRayToItsPlace) {
  const auto corners = construct_isometric(kParameters, 345).value();

  for (const Node& corner : corners) {
    EXPECT_THAT(floor_of(corner), DoubleNear(kParameters.eta * corner.x / corner.y, 1e-9));
  }
}

TEST(Isometric, HasNoProfileForWhatIsNotANumber) {
  IsometricParameters p = kParameters;
  p.eta = std::numeric_limits<double>::quiet_NaN();

  EXPECT_FALSE(integrate_isometric(p, 10).has_value());
  EXPECT_FALSE(construct_isometric(p, 10).has_value());
  EXPECT_FALSE(compare_integrations(p, 10).has_value());
}

}  // namespace
}  // namespace teamsight::mirror
