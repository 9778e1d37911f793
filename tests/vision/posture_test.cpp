// tests/vision/posture_test.cpp: tracking, search, symmetry, and refusing to answer.
#include "vision/posture.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/vision/synthetic_points.hpp"

namespace teamsight::vision {
namespace {

double distance(const Pose<Field, Robot>& a, const Pose<Field, Robot>& b) {
  return (a.origin().vector() - b.origin().vector()).norm();
}

MotionPrior prior_at(const Pose<Field, Robot>& X_FR, double half_log_odds) {
  MotionPrior prior;
  prior.X_FR = X_FR;
  prior.cov = Eigen::Vector3d(0.04, 0.04, 0.02).asDiagonal();
  prior.half_log_odds = half_log_odds;
  return prior;
}

TEST(LineResidual, HasTheNumericalJacobian) {
  const LineMap map(test_field());
  LinePoint point;
  point.p_R = {1.3, 0.4};
  for (const double theta : {-3.1415, -1.0, 0.0, 1e-7, 2.2, 3.1415}) {
    const Eigen::Vector3d at(0.35, 1.1, theta);
    const auto residual = [&](const Eigen::Vector3d& x) {
      return line_residual(map, {x.x(), x.y(), x.z()}, point);
    };

    const LineResidual here = residual(at);

    for (int k = 0; k < 3; ++k) {
      constexpr double kNudge = 1e-6;
      const Eigen::Vector3d nudge = kNudge * Eigen::Vector3d::Unit(k);
      const double numeric =
          (residual(at + nudge).distance - residual(at - nudge).distance) / (2.0 * kNudge);
      EXPECT_NEAR(here.jacobian(k), numeric, 1e-5) << "theta " << theta << ", parameter " << k;
    }
  }
}

TEST(LineMap, LeavesOutWhatOnlyMarksTheFootOfAWallOrAGoal) {
  FieldModel field;
  field.length = 9.0;
  field.width = 4.5;
  field.lines = {{"centre line", {0.0, 2.25}, {0.0, -2.25}},
                 {"wall foot", {-4.5, 2.25}, {4.5, 2.25}},
                 {"goal side", {4.5, 1.0}, {5.0, 1.0}},
                 {"goal line", {4.5, 2.25}, {4.5, -2.25}}};
  field.walls = {{"wall", {-4.5, 2.25}, {4.5, 2.25}, 0.5}};
  field.goals = {{"goal", {4.5, 1.0}, {4.5, -1.0}, 0.9, 0.5, GoalColour::kYellow}};

  const LineMap map(field);

  EXPECT_NEAR(std::abs(map.nearest({1.0, 2.25}).distance), 1.0, 1e-9);  // the centre line
  EXPECT_NEAR(std::abs(map.nearest({4.8, 1.0}).distance), 0.3, 1e-9);   // the goal line
  EXPECT_EQ(map.field(), field);
}

TEST(LineMap, KeepsTheFootOfAWallWhereThereIsNoOtherPaint) {
  FieldModel field;
  field.length = 9.0;
  field.width = 4.5;
  field.lines = {{"wall foot", {-4.5, 2.25}, {4.5, 2.25}}};
  field.walls = {{"wall", {-4.5, 2.25}, {4.5, 2.25}, 0.5}};

  const LineMap map(field);

  EXPECT_NEAR(std::abs(map.nearest({1.0, 2.0}).distance), 0.25, 1e-9);
}

TEST(LineMap, NamesTheNearestPaint) {
  const FieldModel field = test_field();
  const LineMap map(field);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-5.0, 5.0);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector2d p{place(random), place(random)};
    const auto exact = nearest_line(field, Point<Field>::from(p));

    // The grid's choice may differ between two paints that are equally near to within a cell.
    EXPECT_NEAR(std::abs(map.nearest(p).distance), std::abs(exact->distance), 0.08);
  }
}

TEST(LineMap, IsExactOnTheLineOrArcThatItNames) {
  FieldModel field;
  field.length = 9.0;
  field.width = 6.0;
  field.lines = {{"slanting", {-3.0, -1.0}, {-1.0, 1.5}}};
  field.arcs = {{"circle", {0.0, 0.0}, 0.6, 0.0, 2.0 * std::numbers::pi},
                {"quarter", {4.5, -3.0}, 1.0, 0.5 * std::numbers::pi, 0.5 * std::numbers::pi},
                {"most of a circle", {2.0, 1.5}, 1.0, 5.5, 1.5 * std::numbers::pi}};
  const LineMap map(field);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> place(-5.0, 5.0);
  std::array<int, 4> ends{};
  for (int i = 0; i < 2000; ++i) {
    const Eigen::Vector2d p{place(random), place(random)};

    const NearestLine named = map.nearest(p);

    const NearestLine exact = line_at(field, named.primitive, Point<Field>::from(p));
    EXPECT_NEAR(named.distance, exact.distance, 1e-12);
    EXPECT_LT((named.closest_F - exact.closest_F).norm(), 1e-12);
    EXPECT_LT((named.normal_F - exact.normal_F).norm(), 1e-12);
    ASSERT_EQ(named.is_end, exact.is_end);
    if (named.is_end) ++ends.at(named.primitive);
  }
  EXPECT_GT(ends[0], 50);
  EXPECT_EQ(ends[1], 0);
  EXPECT_GT(ends[2], 50);
  EXPECT_GT(ends[3], 20);
}

TEST(PostureEstimator, TracksFromANearbyPrior) {
  std::mt19937 random(5);
  const Pose<Field, Robot> truth(1.0, -1.2, 0.4);
  const auto points = line_points_from(test_field(), truth, 0.01, 0.2, random);
  PostureEstimator estimator(test_field());

  const auto result = estimator.estimate(points, prior_at({1.1, -1.1, 0.45}, 4.0));

  EXPECT_EQ(result.estimate.status, PostureStatus::kOk);
  EXPECT_FALSE(result.searched_globally);
  EXPECT_LT(distance(result.estimate.X_FR, truth), 0.02);
}

TEST(PostureEstimator, FindsThePostureWithoutAPriorUpToSymmetry) {
  std::mt19937 random(6);
  PostureEstimator estimator(test_field());
  int found = 0;
  constexpr int kTrials = 15;
  for (int i = 0; i < kTrials; ++i) {
    const Pose<Field, Robot> truth = random_pose(test_field(), random);
    const auto points = line_points_from(test_field(), truth, 0.01, 0.1, random);

    const auto result = estimator.estimate(points, {});

    const auto& X_FR = result.estimate.X_FR;
    const bool near = std::min(distance(X_FR, truth), distance(X_FR, mirrored(truth))) < 0.05;
    EXPECT_NE(result.estimate.status, PostureStatus::kOk) << "a symmetric field leaves two";
    if (near && result.estimate.status == PostureStatus::kAmbiguous) ++found;
  }
  EXPECT_GE(found, kTrials - 1);
}

TEST(PostureEstimator, LeavesAWrongPrior) {
  std::mt19937 random(7);
  const Pose<Field, Robot> truth(-2.0, 1.0, -2.5);
  const auto points = line_points_from(test_field(), truth, 0.01, 0.1, random);
  PostureEstimator estimator(test_field());

  const auto result = estimator.estimate(points, prior_at({2.5, -2.0, 0.3}, 4.0));

  EXPECT_TRUE(result.searched_globally);
  EXPECT_NE(result.estimate.status, PostureStatus::kLost);
  EXPECT_LT(std::min(distance(result.estimate.X_FR, truth),
                     distance(result.estimate.X_FR, mirrored(truth))),
            0.05);
}

TEST(PostureEstimator, FollowsAFieldThatIsPaintedElsewhere) {
  const Eigen::Vector2d offset{1.0, 0.5};
  const Pose<Field, Robot> truth(-2.0, 1.0, 0.7);
  std::mt19937 random(8);
  const auto points = line_points_from(test_field(), truth, 0.005, 0.0, random);
  PostureEstimator here(test_field());
  PostureEstimator there(shifted(test_field(), offset));

  const auto a = here.estimate(points, {}).estimate;
  const auto b = there.estimate(points, {}).estimate;

  EXPECT_LT((a.X_FR.origin().vector() + offset - b.X_FR.origin().vector()).norm(), 1e-3);
  EXPECT_NEAR(angle_difference(a.X_FR.theta(), b.X_FR.theta()), 0.0, 1e-3);
}

TEST(PostureEstimator, TakesTheHalfInWhichTheRobotStarts) {
  const Pose<Field, Robot> truth(2.5, 1.0, 0.7);
  std::mt19937 random(9);
  const auto points = line_points_from(test_field(), truth, 0.005, 0.0, random);
  PostureEstimator estimator(test_field());
  MotionPrior own;
  own.start_side = StartSide::kOwnHalf;
  MotionPrior opponent;
  opponent.start_side = StartSide::kOpponentHalf;

  const auto a = estimator.estimate(points, own).estimate;
  const auto b = estimator.estimate(points, opponent).estimate;

  EXPECT_EQ(a.status, PostureStatus::kOk);
  EXPECT_EQ(b.status, PostureStatus::kOk);
  EXPECT_LT(distance(a.X_FR, mirrored(truth)), 0.02);
  EXPECT_LT(distance(b.X_FR, truth), 0.02);
}

TEST(PostureEstimator, IsLostInNoiseAndOnAlmostNothing) {
  std::mt19937 random(10);
  std::uniform_real_distribution<double> anywhere(-5.0, 5.0);
  std::vector<LinePoint> noise(120);
  for (LinePoint& point : noise) {
    point.p_R = {anywhere(random), anywhere(random)};
    point.cov_R = 1e-4 * Eigen::Matrix2d::Identity();
  }
  PostureEstimator estimator(test_field());

  EXPECT_EQ(estimator.estimate(noise, {}).estimate.status, PostureStatus::kLost);
  EXPECT_EQ(estimator.estimate({}, {}).estimate.status, PostureStatus::kLost);
}

TEST(PostureEstimator, IsLostOnOneStraightLine) {
  std::vector<LinePoint> points(60);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].p_R = {1.0, -1.0 + 0.03 * static_cast<double>(i)};
    points[i].cov_R = 1e-4 * Eigen::Matrix2d::Identity();
  }
  PostureEstimator estimator(test_field());

  // Half a line of two metres fits in many places.
  EXPECT_NE(estimator.estimate(points, {}).estimate.status, PostureStatus::kOk);
}

TEST(HalfLogOdds, KeepThePriorsNearItAndFadeFarFromBoth) {
  const MotionPrior prior = prior_at({2.0, 1.0, 0.3}, 3.0);

  EXPECT_NEAR(half_log_odds_from_prior({2.0, 1.0, 0.3}, prior, {}), 3.0, 0.05);
  EXPECT_NEAR(half_log_odds_from_prior(mirrored({2.0, 1.0, 0.3}), prior, {}), -3.0, 0.05);
  EXPECT_NEAR(half_log_odds_from_prior({-4.0, 3.0, 2.0}, prior, {}), 0.0, 0.05);
}

TEST(HalfLogOdds, SayNothingOnTheCentreLine) {
  EXPECT_NEAR(half_log_odds_from_side({0.0, 2.0, 0.0}, 0.02, StartSide::kOwnHalf, {}), 0.0, 1e-9);
  EXPECT_GT(half_log_odds_from_side({-1.0, 2.0, 0.0}, 0.02, StartSide::kOwnHalf, {}), 4.0);
  EXPECT_LT(half_log_odds_from_side({1.0, 2.0, 0.0}, 0.02, StartSide::kOwnHalf, {}), -4.0);
}

}  // namespace
}  // namespace teamsight::vision
