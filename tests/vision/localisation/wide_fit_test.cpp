// tests/vision/localisation/wide_fit_test.cpp: where one fit is enough, and where it is not.
#include "vision/localisation/wide_fit.hpp"

#include <cmath>
#include <iostream>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "bench/locate_score/line_view.hpp"
#include "tests/vision/localisation/fields.hpp"

namespace teamsight::vision {
namespace {

using locate_score::draw_pose;
using locate_score::look_at_lines;

// Beside the truth by so many sigmas, and that uncertain.
Hypothesis beside(const Pose<Field, Robot>& truth, const Eigen::Vector3d& sigmas) {
  const Eigen::Vector3d sigma(0.2, 0.2, 0.08);
  const Eigen::Vector3d gap = sigma.cwiseProduct(sigmas);
  Hypothesis hypothesis;
  hypothesis.X_FR = {truth.x() + gap.x(), truth.y() + gap.y(), truth.theta() + gap.z()};
  hypothesis.cov.topLeftCorner<3, 3>() = sigma.cwiseAbs2().asDiagonal();
  return hypothesis;
}

// As a mirror's pixels grow outwards.
void claim_as_a_mirror(LinePoint& point) {
  const double sigma = 0.01 + 0.001 * point.p_R.vector().squaredNorm();
  point.cov_R = sigma * sigma * Eigen::Matrix2d::Identity();
}

double distance(const Pose<Field, Robot>& a, const Pose<Field, Robot>& b) {
  return (a.origin().vector() - b.origin().vector()).norm();
}

TEST(WideFitter, LeavesAFrameThatIsExplainedToOneFit) {
  const LineMap map(league_field());
  std::mt19937 random(1);
  const Pose<Field, Robot> truth(2.0, 1.0, 0.5);
  const auto points = look_at_lines(league_field(), truth, {.sigma = 0.005}, {}, random);
  const Hypothesis hypothesis = beside(truth, {0.25, -0.25, 0.2});
  PostureFitter once;
  WideFitter wide;

  const PostureFit expected = once.fit(map, points, {hypothesis.X_FR, 0.25, {}, 1.0});
  const PostureFit found = wide.fit(map, points, hypothesis, {}, 1.0);

  EXPECT_EQ(found.X_FR, expected.X_FR);
  EXPECT_EQ(found.cov, expected.cov);
}

TEST(WideFitter, FindsThePlaceThatOneFitMissesAmongFalsePoints) {
  const LineMap map(league_field());
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  PostureFitter once;
  WideFitter wide;
  const HeadTilt tilt{.sigma = Eigen::Vector2d::Constant(0.0052)};
  int missed_by_one = 0;
  int missed_by_wide = 0;
  for (int i = 0; i < 300; ++i) {
    const Pose<Field, Robot> truth = draw_pose(league_field(), 0.5, random);
    auto points =
        look_at_lines(league_field(), truth, {.outliers = 0.5, .hidden = 0.3}, {}, random);
    for (LinePoint& point : points) claim_as_a_mirror(point);
    const Eigen::Vector3d sigmas(normal(random), normal(random), normal(random));
    const Hypothesis hypothesis = beside(truth, sigmas);

    const PostureFit one = once.fit(map, points, {hypothesis.X_FR, 0.25, tilt, 1.0});
    const PostureFit found = wide.fit(map, points, hypothesis, tilt, 1.0);

    if (distance(one.X_FR, truth) > 0.1) ++missed_by_one;
    if (distance(found.X_FR, truth) > 0.1) ++missed_by_wide;
  }

  RecordProperty("missed_by_one_fit", missed_by_one);
  RecordProperty("missed_by_wide_fit", missed_by_wide);
  std::cout << "missed by one fit: " << missed_by_one << ", by the wide one: " << missed_by_wide
            << " of 300\n";
  EXPECT_GE(missed_by_one, 6);
  EXPECT_LE(3 * missed_by_wide, missed_by_one);
}

TEST(WideFitter, FindsThePlaceBehindAHeadThatLeansFurtherThanAnyFitExpects) {
  const LineMap map(league_field());
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  PostureFitter once;
  WideFitter wide;
  const HeadTilt tilt{.eye_height = 0.75, .sigma = Eigen::Vector2d::Constant(0.0052)};
  int missed_by_one = 0;
  int missed_by_wide = 0;
  for (int i = 0; i < 300; ++i) {
    const Pose<Field, Robot> truth = draw_pose(league_field(), 0.5, random);
    const double side = 2.0 * std::numbers::pi * i / 300.0;
    const locate_score::LineViewParameters view{
        .sigma = 0.005, .roll = 0.03 * std::cos(side), .pitch = 0.03 * std::sin(side)};
    auto points = look_at_lines(league_field(), truth, view, {}, random);
    for (LinePoint& point : points) point.cov_R = 1e-4 * Eigen::Matrix2d::Identity();
    const Eigen::Vector3d sigmas(normal(random), normal(random), normal(random));
    const Hypothesis hypothesis = beside(truth, sigmas);

    const PostureFit one = once.fit(map, points, {hypothesis.X_FR, 0.25, tilt, 1.0});
    const PostureFit found = wide.fit(map, points, hypothesis, tilt, 1.0);

    if (distance(one.X_FR, truth) > 0.1) ++missed_by_one;
    if (distance(found.X_FR, truth) > 0.1) ++missed_by_wide;
  }

  RecordProperty("missed_by_one_fit", missed_by_one);
  RecordProperty("missed_by_wide_fit", missed_by_wide);
  std::cout << "leaning, missed by one fit: " << missed_by_one
            << ", by the wide one: " << missed_by_wide << " of 300\n";
  EXPECT_GE(missed_by_one, 6);
  EXPECT_LE(3 * missed_by_wide, missed_by_one);
}

TEST(WideFitter, IsUnsureWhereTwoPlacesExplainThePointsAlike) {
  FieldModel field;
  field.length = 12.0;
  field.width = 8.0;
  field.surround = 1.0;
  field.line_width = 0.125;
  field.lines = {{"one", {-6.0, 0.15}, {6.0, 0.15}},
                 {"other", {-6.0, -0.15}, {6.0, -0.15}},
                 {"across", {0.0, 4.0}, {0.0, 0.5}}};
  const LineMap map(field);
  std::vector<LinePoint> points;
  // One line at the left, half way between the two of the field, the line across, and what is on
  // none.
  for (int i = 0; i < 60; ++i) {
    LinePoint point;
    point.p_R = {0.1 * i - 3.0, 1.0};
    if (i % 3 == 1) point.p_R = {0.5, 2.0 + 0.04 * i};
    if (i % 10 == 0) point.p_R = {-2.0, 3.0 + 0.02 * i};
    point.cov_R = 1e-4 * Eigen::Matrix2d::Identity();
    points.push_back(point);
  }
  Hypothesis hypothesis = beside({-0.5, -1.0, 0.0}, Eigen::Vector3d::Zero());
  hypothesis.cov(1, 1) = 0.1 * 0.1;
  PostureFitter once;
  WideFitter wide;

  const PostureFit one = once.fit(map, points, {hypothesis.X_FR, 0.25, {}, 1.0});
  const PostureFit found = wide.fit(map, points, hypothesis, {}, 1.0);

  EXPECT_LT(std::sqrt(one.cov(1, 1)), 0.01);
  EXPECT_GT(std::sqrt(found.cov(1, 1)), 0.1);
}

}  // namespace
}  // namespace teamsight::vision
