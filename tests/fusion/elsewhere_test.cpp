// tests/fusion/elsewhere_test.cpp: fusion/elsewhere.hpp.
#include "fusion/elsewhere.hpp"

#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace teamsight::fusion {
namespace {

const TrustParameters kParameters;
const Eigen::Vector2d kCentre{0.0, 0.0};
const Eigen::Vector2d kSaid{-3.0, 1.0};
const std::vector<Eigen::Vector2d> kPlaces{
    {-5.0, 0.0}, {-2.5, 3.0}, {-1.0, -2.0}, {0.5, 1.5}, {-4.5, 3.5}, {-2.0, -0.5}, {1.0, -1.0}};

/// Two others say what stands where.
ClaimList claims_at(const std::vector<Eigen::Vector2d>& places, bool is_of_two = true) {
  ClaimList claims;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const RobotId claimant = is_of_two && i % 2 == 0 ? 2 : 3;
    claims.push_back({places[i], 0.01 * Eigen::Matrix2d::Identity(), robot_bit(claimant), false});
  }
  return claims;
}

/// What robot 1 seems to see, if all that it sees is moved like this.
double odds(const ClaimList& claims, double turn, const Eigen::Vector2d& way) {
  CandidateList obstacles;
  for (const Eigen::Vector2d& place : kPlaces) {
    Candidate candidate;
    candidate.measurement.p_F = kSaid + Eigen::Rotation2Dd(turn) * (place - kSaid) + way;
    candidate.measurement.cov_F = 0.01 * Eigen::Matrix2d::Identity();
    obstacles.push_back(candidate);
  }
  const Testimony testimony{1, kSaid + way, {}, obstacles, {}};
  return log_odds_elsewhere(testimony, claims, kCentre, kParameters);
}

TEST(Elsewhere, IsFoundWhereAllThatIsSeenFitsAnotherPosture) {
  EXPECT_GT(odds(claims_at(kPlaces), 1.0, {4.0, -2.0}), 5.5);
}

TEST(Elsewhere, IsNotFoundWhereTheSaidPostureFits) {
  EXPECT_EQ(odds(claims_at(kPlaces), 0.0, {0.0, 0.0}), 0.0);
}

TEST(Elsewhere, IsNotFoundForABiasOrAMirrorImage) {
  EXPECT_LT(odds(claims_at(kPlaces), 0.0, {0.5, 0.0}), 5.5);
  EXPECT_LT(odds(claims_at(kPlaces), std::numbers::pi, -2.0 * kSaid), 5.5);
}

TEST(Elsewhere, IsNotFoundByOneOthersWordAlone) {
  EXPECT_EQ(odds(claims_at(kPlaces, false), 1.0, {4.0, -2.0}), 0.0);
}

TEST(Elsewhere, IsNotFoundByTheFewThingsThatFitAnywhere) {
  EXPECT_LT(odds(claims_at({kPlaces.begin(), kPlaces.begin() + 3}), 1.0, {4.0, -2.0}), 5.5);
}

}  // namespace
}  // namespace teamsight::fusion
