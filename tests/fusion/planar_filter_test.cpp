// tests/fusion/planar_filter_test.cpp: the information filter is the Kalman filter, written
// otherwise.
#include "fusion/planar_filter.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace teamsight::fusion {
namespace {

PlanarMoments some_moments() {
  PlanarMoments moments;
  moments.mean << 1.0, -2.0, 0.5, 0.25;
  moments.cov << 0.04, 0.01, 0.01, 0.0,  //
      0.01, 0.09, 0.0, 0.02,             //
      0.01, 0.0, 0.25, 0.05,             //
      0.0, 0.02, 0.05, 0.36;
  return moments;
}

PlanarMeasurement some_measurement() {
  PlanarMeasurement measurement;
  measurement.p_F << 1.2, -1.9;
  measurement.cov_F << 0.02, -0.005, -0.005, 0.03;
  return measurement;
}

TEST(PlanarFilter, GivesBackWhatItWasMadeFrom) {
  const auto moments = PlanarFilter::from(some_moments()).moments();

  EXPECT_TRUE(moments.mean.isApprox(some_moments().mean, 1e-12));
  EXPECT_TRUE(moments.cov.isApprox(some_moments().cov, 1e-12));
}

TEST(PlanarFilter, UpdatesAsTheKalmanFilterDoes) {
  const PlanarMoments before = some_moments();
  const PlanarMeasurement measurement = some_measurement();
  PlanarFilter filter = PlanarFilter::from(before);

  filter.update(measurement);

  const Eigen::Matrix2d cov_gap = before.cov.topLeftCorner<2, 2>() + measurement.cov_F;
  const Eigen::Matrix<double, 4, 2> gain = before.cov.leftCols<2>() * cov_gap.inverse();
  const Eigen::Vector4d mean = before.mean + gain * (measurement.p_F - before.mean.head<2>());
  const Eigen::Matrix4d cov = before.cov - gain * before.cov.topRows<2>();
  EXPECT_TRUE(filter.moments().mean.isApprox(mean, 1e-10));
  EXPECT_TRUE(filter.moments().cov.isApprox(cov, 1e-10));
}

TEST(PlanarFilter, PredictionInStepsIsPredictionInOne) {
  const PlanarMotion motion{2.0, 0.0};
  PlanarFilter once = PlanarFilter::from(some_moments());
  PlanarFilter stepwise = once;

  once.predict(0.3, motion);
  for (int i = 0; i < 30; ++i) stepwise.predict(0.01, motion);

  EXPECT_TRUE(once.moments().mean.isApprox(stepwise.moments().mean, 1e-9));
  EXPECT_TRUE(once.moments().cov.isApprox(stepwise.moments().cov, 1e-9));
}

TEST(PlanarFilter, VelocityFadesAndThePositionFollows) {
  const PlanarMotion motion{1.0, 0.5};

  const auto later = predicted(some_moments(), 2.0, motion);

  EXPECT_NEAR(later.mean(2), 0.5 * std::exp(-1.0), 1e-12);
  EXPECT_NEAR(later.mean(0), 1.0 + 0.5 * (1.0 - std::exp(-1.0)) / 0.5, 1e-12);
}

TEST(PlanarFilter, DoesNotGoBackInTime) {
  EXPECT_EQ(predicted(some_moments(), -0.1, {}).mean, some_moments().mean);
}

}  // namespace
}  // namespace teamsight::fusion
