// tests/vision/posture_consistency_test.cpp: the covariance of the posture is true, and near the
// bound.
#include <cmath>
#include <random>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "geometry/angle.hpp"
#include "geometry/uncertainty.hpp"
#include "tests/vision/synthetic_points.hpp"
#include "vision/posture.hpp"

namespace teamsight::vision {
namespace {

// Points of a camera whose file is exactly right.
SharedError exact_camera() {
  return {0.0, 1e-5, 1e-5};
}

struct Figures {
  double nees{0.0};         // mean, per degree of freedom
  double bound_ratio{0.0};  // RMS position error over the Cramer-Rao bound's
  int runs{0};
};

// The bound of the true inliers [state of the art: information of the line normals].
Eigen::Matrix3d bound_of(const LineMap& map,
                         const std::vector<LinePoint>& points,
                         const Pose<Field, Robot>& truth,
                         double inliers) {
  Eigen::Matrix3d info = Eigen::Matrix3d::Zero();
  for (const LinePoint& point : points) {
    const LineResidual r = line_residual(map, truth, point);
    info += inliers * r.jacobian * r.jacobian.transpose() / r.var;
  }
  return info.inverse();
}

Figures measure(double sigma, double outliers, unsigned seed) {
  const FieldModel field = test_field();
  PostureEstimator estimator(field, {}, exact_camera());
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Figures figures;
  double squares = 0.0;
  double bounds = 0.0;
  for (int i = 0; i < 150; ++i) {
    const Pose<Field, Robot> truth = random_pose(field, random);
    const auto points = line_points_from(field, truth, sigma, outliers, random);
    MotionPrior prior;
    prior.X_FR = Pose<Field, Robot>(truth.x() + 0.05 * normal(random),
                                    truth.y() + 0.05 * normal(random),
                                    truth.theta() + 0.03 * normal(random));
    prior.cov = Eigen::Vector3d(0.01, 0.01, 0.003).asDiagonal();
    prior.half_log_odds = 4.0;
    const auto result = estimator.estimate(points, prior).estimate;
    EXPECT_EQ(result.status, PostureStatus::kOk);
    Eigen::Vector3d off = result.X_FR.vector() - truth.vector();
    off.z() = wrap_angle(off.z());
    figures.nees += squared_mahalanobis(off, result.cov) / 3.0;
    squares += off.head<2>().squaredNorm();
    bounds +=
        bound_of(estimator.map(), points, truth, 1.0 - outliers).topLeftCorner<2, 2>().trace();
    ++figures.runs;
  }
  figures.nees /= figures.runs;
  figures.bound_ratio = std::sqrt(squares / bounds);
  return figures;
}

TEST(PostureConsistency, HoldsItsCovarianceUnderCleanNoise) {
  const Figures figures = measure(0.01, 0.0, 21);

  RecordProperty("nees_per_dof", std::to_string(figures.nees));
  RecordProperty("ratio_to_bound", std::to_string(figures.bound_ratio));
  // 450 degrees of freedom: 99.9 % of means lie within 1 +- 0.22; the sandwich adds its own spread.
  EXPECT_GT(figures.nees, 0.75);
  EXPECT_LT(figures.nees, 1.30);
  EXPECT_LT(figures.bound_ratio, 1.15);
}

TEST(PostureConsistency, HoldsItsCovarianceUnderOutliers) {
  const Figures figures = measure(0.01, 0.3, 22);

  RecordProperty("nees_per_dof", std::to_string(figures.nees));
  RecordProperty("ratio_to_bound", std::to_string(figures.bound_ratio));
  EXPECT_GT(figures.nees, 0.70);
  EXPECT_LT(figures.nees, 1.35);
  EXPECT_LT(figures.bound_ratio, 1.30);
}

TEST(PostureConsistency, MeasuresTheNoiseWhenTheDetectorClaimsTooLittle) {
  const FieldModel field = test_field();
  PostureEstimator estimator(field, {}, exact_camera());
  std::mt19937 random(23);
  double nees = 0.0;
  constexpr int kRuns = 100;
  for (int i = 0; i < kRuns; ++i) {
    const Pose<Field, Robot> truth = random_pose(field, random);
    auto points = line_points_from(field, truth, 0.02, 0.0, random);
    for (LinePoint& point : points) point.cov_R *= 0.25;
    MotionPrior prior;
    prior.X_FR = truth;
    prior.cov = Eigen::Vector3d(0.04, 0.04, 0.01).asDiagonal();
    const auto result = estimator.estimate(points, prior).estimate;
    Eigen::Vector3d off = result.X_FR.vector() - truth.vector();
    off.z() = wrap_angle(off.z());
    nees += squared_mahalanobis(off, result.cov) / 3.0 / kRuns;
  }
  EXPECT_GT(nees, 0.7);
  EXPECT_LT(nees, 1.4);
}

TEST(PostureProperty, MirroringThePriorMirrorsTheResult) {
  const FieldModel field = test_field();
  PostureEstimator estimator(field, {}, exact_camera());
  std::mt19937 random(24);
  for (int i = 0; i < 40; ++i) {
    const Pose<Field, Robot> truth = random_pose(field, random);
    const auto points = line_points_from(field, truth, 0.01, 0.1, random);
    MotionPrior prior;
    prior.X_FR = truth;
    prior.cov = Eigen::Vector3d(0.01, 0.01, 0.01).asDiagonal();
    prior.half_log_odds = 4.0;
    const auto here = estimator.estimate(points, prior).estimate;
    prior.X_FR = mirrored(truth);
    const auto there = estimator.estimate(points, prior).estimate;

    EXPECT_TRUE(is_covariance(here.cov));
    EXPECT_TRUE(is_covariance(there.cov));
    EXPECT_LT((mirrored(here.X_FR).origin().vector() - there.X_FR.origin().vector()).norm(), 2e-3);
  }
}

// Every point by its own sigma times what one wrong camera file does to all of them.
std::vector<LinePoint> seen_wrongly(std::vector<LinePoint> points, std::mt19937& random) {
  std::normal_distribution<double> third(0.0, std::sqrt(1.0 / 3.0));
  const double right = third(random);
  const double up = third(random);
  const double larger = third(random);
  const double oval = third(random);
  const double slanted = third(random);
  const double turn = third(random);
  for (LinePoint& point : points) {
    const double range = point.p_R.vector().norm();
    const double azimuth = std::atan2(point.p_R.y, point.p_R.x);
    const double sigma = std::sqrt(point.cov_R(0, 0));
    const double radial = right * std::cos(azimuth) + up * std::sin(azimuth) + larger +
                          oval * std::cos(2.0 * azimuth) + slanted * std::sin(2.0 * azimuth);
    const double tangential = up * std::cos(azimuth) - right * std::sin(azimuth) + turn;
    const double r = range + sigma * radial;
    const double a = azimuth + sigma * tangential / range;
    point.p_R = {r * std::cos(a), r * std::sin(a)};
  }
  return points;
}

TEST(PostureConsistency, KnowsWhatAnErrorThatAllPointsShareDoes) {
  const FieldModel field = test_field();
  const LineMap map(field);
  PostureFitter fitter;
  std::mt19937 random(24);
  double nees = 0.0;
  constexpr int kRuns = 300;
  for (int i = 0; i < kRuns; ++i) {
    const Pose<Field, Robot> truth = random_pose(field, random);
    auto points = line_points_from(field, truth, 1e-6, 0.0, random);
    for (LinePoint& point : points) point.cov_R = 1e-4 * Eigen::Matrix2d::Identity();

    const PostureFit fit = fitter.fit(map, seen_wrongly(points, random), {truth, 0.06, {}, 1.0});

    Eigen::Vector3d off = fit.X_FR.vector() - truth.vector();
    off.z() = wrap_angle(off.z());
    const Eigen::Matrix3d cov =
        fit.cov_shared + Eigen::Vector3d(1e-8, 1e-8, 1e-9).asDiagonal().toDenseMatrix();
    nees += squared_mahalanobis(off, cov) / 3.0 / kRuns;
  }

  RecordProperty("nees_per_dof", std::to_string(nees));
  // 900 degrees of freedom: 99.9 % of means lie within 1 +- 0.16; the fit is linear but nearly.
  EXPECT_GT(nees, 0.75);
  EXPECT_LT(nees, 1.25);
}

// Points on a long side line, and some on the line across that alone hold the robot along it.
PostureFit fit_beside_a_line(int across) {
  FieldModel field;
  field.length = 12.0;
  field.width = 8.0;
  field.surround = 1.0;
  field.line_width = 0.125;
  field.lines = {{"along", {-6.0, 0.0}, {6.0, 0.0}}, {"across", {0.0, 4.0}, {0.0, -4.0}}};
  std::vector<LinePoint> points;
  const auto add = [&points](double x, double y) {
    LinePoint point;
    point.p_R = {x, y};
    point.cov_R = 1e-4 * Eigen::Matrix2d::Identity();
    points.push_back(point);
  };
  for (int i = 0; i < 40; ++i) add(0.1 * i - 2.0, 1.0);
  for (int i = 0; i < across; ++i) add(1.0, 1.5 + 0.05 * i);
  PostureFitter fitter;
  return fitter.fit(LineMap(field), points, {{-1.0, -1.0, 0.0}, 0.06, {}, 1.0});
}

TEST(PostureFit, IsNoSurerThanOnePointMayBeTrusted) {
  const PostureFit one = fit_beside_a_line(1);
  const PostureFit many = fit_beside_a_line(20);

  // Wrong in a quarter of all cases, and then up to a kernel's width away.
  EXPECT_GT(std::sqrt(one.cov(0, 0)), 0.08);
  EXPECT_LT(std::sqrt(one.cov(0, 0)), 0.2);
  EXPECT_LT(std::sqrt(one.cov(1, 1)), 0.02);
  EXPECT_LT(std::sqrt(many.cov(0, 0)), 0.5 * std::sqrt(one.cov(0, 0)));
  EXPECT_TRUE(is_covariance(one.cov_doubtful + 1e-12 * Eigen::Matrix3d::Identity()));
}

}  // namespace
}  // namespace teamsight::vision
