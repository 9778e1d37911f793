// tests/bench/locate_score_test.cpp: how answers are counted, and what is done to line points.
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "bench/locate_score/point_errors.hpp"
#include "bench/locate_score/spoils.hpp"
#include "bench/locate_score/tally.hpp"

namespace teamsight::locate_score {
namespace {

// Long aslant and turned with it: every element of the covariance counts.
Eigen::Matrix3d aslant() {
  Eigen::Matrix3d cov;
  cov << 0.04, 0.01, 0.002, 0.01, 0.01, -0.001, 0.002, -0.001, 0.001;
  return cov;
}

TEST(LocateTally, CountsAMirroredAnswerAsItsImage) {
  const Point<Field> centre{1.0, -0.5};
  const Pose<Field, Robot> truth(2.0, 1.0, 0.4);
  const Pose<Field, Robot> answer(2.2, 1.1, 0.42);
  Eigen::Matrix3d cov_image = aslant();
  cov_image.block<2, 1>(0, 2) *= -1.0;
  cov_image.block<1, 2>(2, 0) *= -1.0;
  Tally straight;
  Tally turned;

  straight.add({answer, aslant(), 0.0}, truth, Eigen::Vector2d::Zero(), centre);
  turned.add({mirrored(answer, centre), cov_image, 0.0}, truth, Eigen::Vector2d::Zero(), centre);

  ASSERT_TRUE(straight.nees().has_value());
  ASSERT_TRUE(turned.nees().has_value());
  EXPECT_EQ(straight.failures() + turned.failures(), 0U);
  EXPECT_NEAR(*turned.nees(), *straight.nees(), 1e-9);
  EXPECT_NEAR(turned.mean().x(), straight.mean().x(), 1e-9);
}

TEST(LocateTally, CountsTheImageAsWrongForWhoKnowsTheHalf) {
  const Pose<Field, Robot> truth(2.0, 1.0, 0.4);
  Tally tally;

  tally.add({mirrored(truth, {0.0, 0.0}), {}, 0.0}, truth, Eigen::Vector2d::Zero(), std::nullopt);

  EXPECT_EQ(tally.failures(), 1U);
}

TEST(LocatePointErrors, MeasureDistancesFromThePaintAtTheTruth) {
  FieldModel field;
  field.length = 10.0;
  field.width = 10.0;
  field.line_width = 0.125;
  field.lines.push_back({"middle", {0.0, -4.0}, {0.0, 4.0}, LineFamily::kOther});
  const vision::LineMap map(field);
  std::vector<vision::LinePoint> points(4);
  const std::array<double, 4> offsets{0.01, -0.02, 0.03, 1.5};  // the last one is on no paint
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].p_R = {1.0 + offsets[i], 0.2};
    points[i].cov_R = 1e-4 * Eigen::Matrix2d::Identity();
  }
  PointErrors errors;

  errors.add(map, {-1.0, 0.0, 0.0}, points, 0.75);

  EXPECT_DOUBLE_EQ(errors.points_per_frame(), 4.0);
  EXPECT_DOUBLE_EQ(errors.share_off_paint(), 0.25);
  EXPECT_NEAR(errors.quantile(0.5), 0.02, 1e-9);
  EXPECT_NEAR(errors.rms(), std::sqrt(14e-4 / 3.0), 1e-9);
  ASSERT_TRUE(errors.over_claimed().has_value());
  EXPECT_NEAR(*errors.over_claimed(), std::sqrt(14.0 / 3.0), 0.01);
}

std::vector<vision::LinePoint> a_carpet_of_points() {
  std::vector<vision::LinePoint> points;
  for (int i = -50; i < 50; ++i) {
    for (int j = -50; j < 50; ++j) {
      vision::LinePoint point;
      point.p_R = {0.1 * i + 0.05, 0.1 * j + 0.05};
      points.push_back(point);
    }
  }
  return points;
}

TEST(Spoils, HideWholeMetresAndAboutTheShare) {
  std::mt19937 random(1);
  double kept = 0.0;
  for (int look = 0; look < 20; ++look) {
    auto points = a_carpet_of_points();
    hide(0.7)(points, {0.0, 0.0, 0.0}, random);
    kept += static_cast<double>(points.size()) / 20.0;
    EXPECT_EQ(points.size() % 100, 0U);
  }

  EXPECT_NEAR(kept / 10000.0, 0.3, 0.06);
}

TEST(Spoils, FalsifyUntilTheShareIsFalse) {
  std::mt19937 random(2);
  auto points = a_carpet_of_points();
  points.resize(300);

  falsify(0.25)(points, {0.0, 0.0, 0.0}, random);

  EXPECT_EQ(points.size(), 400U);
}

TEST(Spoils, AnEyeThatIsExactChangesNothingWithinItsRange) {
  std::mt19937 random(3);
  const Eye eye({.shift = 0.0, .turn = 0.0, .scale = 0.0, .bend = 0.0, .tilt = 0.0}, 0.75, random);
  auto points = a_carpet_of_points();
  auto expected = points;
  std::erase_if(expected, [](const auto& point) { return point.p_R.vector().norm() > 6.0; });

  eye.look(points);

  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LT((points[i].p_R.vector() - expected[i].p_R.vector()).norm(), 1e-9);
  }
}

TEST(Spoils, ALeaningHeadSeesFarPointsElsewhere) {
  std::mt19937 random(4);
  const Eye eye({.shift = 0.0, .turn = 0.0, .scale = 0.0, .bend = 0.0, .tilt = 0.0}, 0.75, random);
  std::vector<vision::LinePoint> points(2);
  points[0].p_R = {1.0, 0.0};
  points[1].p_R = {4.0, 0.0};

  eye.look(points, {0.0, 0.01});

  // d = r^2 tilt / h.
  EXPECT_NEAR(points[0].p_R.x - 1.0, 0.0133, 0.0005);
  EXPECT_NEAR(points[1].p_R.x - 4.0, 0.2133, 0.02);
}

}  // namespace
}  // namespace teamsight::locate_score
