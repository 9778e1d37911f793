// tests/sim/render/ball_look_test.cpp: how much of a ball its panels cover, and where.
#include "sim/render/ball_look.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/match/random.hpp"

namespace teamsight::sim {
namespace {

// Of places all over the ball.
double share_in_panels(BallPattern pattern) {
  constexpr int kPlaces = 20000;
  Random random(1);
  int inside = 0;
  for (int i = 0; i < kPlaces; ++i) {
    const Eigen::Vector3d place(random.normal(1.0), random.normal(1.0), random.normal(1.0));
    if (depth_in_panels(pattern, place.normalized().cast<float>()) > 0.0F) ++inside;
  }
  return static_cast<double>(inside) / kPlaces;
}

// A face's solid angle is its area times its height over the cube of the way, about: twelve
// pentagons of 1.72 beside twenty hexagons of 2.60 squares of the edge.
TEST(BallPattern, HasPentagonsOnMoreThanAQuarterOfAFootball) {
  EXPECT_NEAR(share_in_panels(BallPattern::kFootball), 12 * 1.72 / (12 * 1.72 + 20 * 2.6), 0.02);
}

TEST(BallPattern, HasOctantsOnAHalf) {
  EXPECT_NEAR(share_in_panels(BallPattern::kOctants), 0.5, 0.02);
}

TEST(BallPattern, IsNowhereOnAPlainBall) {
  EXPECT_EQ(share_in_panels(BallPattern::kPlain), 0.0);
}

// From the middle of a pentagon to its corners, where the next one is, it is 20.1 degrees, 0.35
// rad.
TEST(BallPattern, EndsWhereAPentagonsCornerIs) {
  const Eigen::Vector3f middle = Eigen::Vector3f(0.0F, 1.0F, 1.618034F).normalized();
  const Eigen::Vector3f beside = Eigen::Vector3f(0.0F, -1.0F, 1.618034F).normalized();
  const Eigen::Vector3f across = (beside - beside.dot(middle) * middle).normalized();
  const auto depth = [&](float angle) {
    return depth_in_panels(BallPattern::kFootball,
                           std::cos(angle) * middle + std::sin(angle) * across);
  };

  EXPECT_GT(depth(0.0F), 0.2F);
  EXPECT_GT(depth(0.32F), 0.0F);
  EXPECT_LT(depth(0.38F), 0.0F);
}

}  // namespace
}  // namespace teamsight::sim
