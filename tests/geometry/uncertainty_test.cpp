// tests/geometry/uncertainty_test.cpp: what may be called a covariance; gates against the tables.
#include "geometry/uncertainty.hpp"

#include <limits>
#include <tuple>

#include <gtest/gtest.h>

namespace teamsight {
namespace {

Eigen::Matrix2d matrix(double xx, double xy, double yx, double yy) {
  return (Eigen::Matrix2d() << xx, xy, yx, yy).finished();
}

TEST(IsCovariance, TakesSymmetricPositiveDefinite) {
  EXPECT_TRUE(is_covariance(matrix(2.0, 0.5, 0.5, 1.0)));
  EXPECT_TRUE(is_covariance(Eigen::Matrix3d::Identity() * 1e-4));
}

TEST(IsCovariance, RefusesWhatIsNotFinite) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();

  EXPECT_FALSE(is_covariance(matrix(kNan, 0.0, 0.0, 1.0)));
  EXPECT_FALSE(is_covariance(matrix(1.0, kNan, kNan, 1.0)));
  EXPECT_FALSE(is_covariance(matrix(kInfinity, 0.0, 0.0, 1.0)));
}

TEST(IsCovariance, RefusesNegativeZeroAndAbsurdVariances) {
  EXPECT_FALSE(is_covariance(matrix(-1.0, 0.0, 0.0, 1.0)));
  EXPECT_FALSE(is_covariance(matrix(0.0, 0.0, 0.0, 1.0)));
  EXPECT_FALSE(is_covariance(matrix(1e-13, 0.0, 0.0, 1.0)));
  EXPECT_FALSE(is_covariance(matrix(1e13, 0.0, 0.0, 1.0)));
}

TEST(IsCovariance, RefusesCorrelationOfOneAndMore) {
  EXPECT_FALSE(is_covariance(matrix(1.0, 1.1, 1.1, 1.0)));
  EXPECT_FALSE(is_covariance(matrix(1.0, 1.0, 1.0, 1.0)));
}

TEST(IsCovariance, RefusesAsymmetry) {
  EXPECT_FALSE(is_covariance(matrix(1.0, 0.2, 0.1, 1.0)));
}

TEST(IsCovariance, RefusesAsymmetryBetweenSmallPartsBesideALargeOne) {
  Eigen::Matrix3d cov = Eigen::Vector3d(1e4, 1e-4, 1e-4).asDiagonal();
  cov(1, 2) = 5e-5;
  cov(2, 1) = -5e-5;

  EXPECT_FALSE(is_covariance(cov));
}

TEST(IsCovariance, RefusesShapesThatAreNotSquare) {
  EXPECT_FALSE(is_covariance(Eigen::MatrixXd::Ones(2, 3)));
  EXPECT_FALSE(is_covariance(Eigen::MatrixXd(0, 0)));
}

TEST(SquaredMahalanobis, WeighsByTheInverse) {
  EXPECT_NEAR(
      squared_mahalanobis(Eigen::Vector2d(2.0, 3.0), matrix(4.0, 0.0, 0.0, 9.0)), 2.0, 1e-12);
  EXPECT_NEAR(
      squared_mahalanobis(Eigen::Vector2d(1.0, 1.0), matrix(2.0, 1.0, 1.0, 2.0)), 2.0 / 3.0, 1e-12);
}

struct TableEntry {
  int degrees_of_freedom;
  double probability;
  double value;
};

// Printed tables of the chi-square distribution.
constexpr TableEntry kTable[] = {
    {1, 0.90, 2.706},  {1, 0.95, 3.841},  {1, 0.99, 6.635},  {1, 0.999, 10.828},
    {2, 0.90, 4.605},  {2, 0.95, 5.991},  {2, 0.99, 9.210},  {2, 0.999, 13.816},
    {3, 0.90, 6.251},  {3, 0.95, 7.815},  {3, 0.99, 11.345}, {3, 0.999, 16.266},
    {4, 0.95, 9.488},  {4, 0.99, 13.277}, {5, 0.99, 15.086}, {6, 0.95, 12.592},
    {6, 0.99, 16.812}, {9, 0.95, 16.919}, {9, 0.99, 21.666}, {30, 0.99, 50.892},
};

TEST(ChiSquareGate, AgreesWithTheTables) {
  for (const TableEntry& entry : kTable) {
    EXPECT_NEAR(
        chi_square_gate(entry.degrees_of_freedom, entry.probability) / entry.value, 1.0, 2e-4)
        << entry.degrees_of_freedom << " degrees, " << entry.probability;
  }
}

TEST(ChiSquareGate, GrowsWithProbabilityFarIntoTheTail) {
  double before = 0.0;

  for (const double probability : {1e-6, 0.1, 0.5, 0.9, 0.99, 0.9999, 1.0 - 1e-9}) {
    const double gate = chi_square_gate(3, probability);
    EXPECT_GT(gate, before);
    before = gate;
  }
}

TEST(ChiSquareGateDeathTest, RefusesACertainty) {
  EXPECT_DEATH(std::ignore = chi_square_gate(2, 1.0), "expected: degrees_of_freedom");
}

}  // namespace
}  // namespace teamsight
