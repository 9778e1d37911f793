// tests/vision/hough2001/hough2001_test.cpp: the founding paper's steps, one by one.
#include "vision/hough2001/hough2001.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "bench/locate_score/line_view.hpp"
#include "bench/locate_score/rendered_view.hpp"
#include "geometry/angle.hpp"
#include "settings/load.hpp"

namespace teamsight::vision {
namespace {

std::string config(const std::string& file) {
  // A test has one thread when it reads its environment.
  // NOLINTNEXTLINE(concurrency-mt-unsafe)
  const char* source = std::getenv("TEAMSIGHT_SOURCE_DIR");
  return std::string(source) + "/config/" + file + ".textproto";
}

FieldModel field_file(const std::string& name) {
  return settings::load_field(config("fields/" + name));
}

std::vector<Point<Robot>> transitions_at(const FieldModel& field,
                                         const Pose<Field, Robot>& X_FR,
                                         unsigned seed) {
  std::mt19937 random(seed);
  locate_score::LineViewParameters view;
  view.rays = 240;
  std::vector<Point<Robot>> transitions;
  for (const LinePoint& point : locate_score::look_at_lines(field, X_FR, view, {}, random)) {
    transitions.push_back(point.p_R);
  }
  return transitions;
}

TEST(LineHough, FindsALineByItsNormal) {
  std::vector<Point<Robot>> points;
  for (int i = -20; i <= 20; ++i) points.push_back({2.0, 0.1 * i});
  LineHough hough(0.025, 6.0);
  hough.vote(points);

  const auto lines = hough.strongest(3);

  ASSERT_FALSE(lines.empty());
  EXPECT_NEAR(lines[0].phi, 0.0, 1e-9);
  EXPECT_NEAR(lines[0].rho, 2.0, 0.013);
  EXPECT_EQ(lines[0].votes, 41);
}

TEST(LineHough, WrapsAround180Degrees) {
  std::vector<Point<Robot>> points;
  for (int i = -20; i <= 20; ++i) points.push_back({2.0, 0.1 * i});
  LineHough hough(0.025, 6.0);
  hough.vote(points);

  // The same line's normal, seen from a column just below 180 degrees.
  const auto lines = hough.strongest_around(std::numbers::pi - 0.01, 3, 6);

  ASSERT_FALSE(lines.empty());
  EXPECT_NEAR(lines[0].rho, -2.0, 0.013);
}

TEST(FieldLines, AreThePapersFiveVerticalAndSixHorizontal) {
  const FieldLines lines = field_lines_of(field_file("robocup-2001"));

  EXPECT_EQ(lines.vertical.size(), 5U);
  EXPECT_EQ(lines.horizontal.size(), 6U);
}

TEST(Relevance, GradesParallelLinesAtKnownDistances) {
  const FieldLines lines = field_lines_of(field_file("robocup-2001"));

  EXPECT_DOUBLE_EQ(relevance_of_angle(0.0), 100.0);
  EXPECT_NEAR(relevance_of_angle(std::numbers::pi - 1e-6), 100.0, 0.01);
  EXPECT_DOUBLE_EQ(relevance_of_angle(std::numbers::pi / 2), 0.0);
  EXPECT_DOUBLE_EQ(relevance_of_distance(lines, 4.5), 100.0);
  EXPECT_NEAR(relevance_of_distance(lines, 4.575), 50.0, 1e-6);
}

// How often the best candidate is within 0.2 m and 2 degrees, up to half a turn.
double share_found(const std::string& name, int tries) {
  const FieldModel field = field_file(name);
  const FieldLines lines = field_lines_of(field);
  LineHough hough(0.025, 6.0);
  std::mt19937 random(7);
  int found = 0;
  for (int i = 0; i < tries; ++i) {
    const Pose<Field, Robot> truth = locate_score::draw_pose(field, 0.5, random);
    const auto candidates = hough2001_candidates(
        hough, lines, transitions_at(field, truth, static_cast<unsigned>(i)), {});
    if (candidates.empty()) continue;
    const Pose<Field, Robot>& X_FR = candidates.front().X_FR;
    const bool is_right = std::ranges::any_of(
        std::array{truth, mirrored(truth)}, [&](const Pose<Field, Robot>& image) {
          return (X_FR.origin().vector() - image.origin().vector()).norm() < 0.2 &&
                 std::abs(angle_difference(X_FR.theta(), image.theta())) < 0.035;
        });
    if (is_right) ++found;
  }
  return static_cast<double>(found) / tries;
}

TEST(Hough2001, FindsMostPlacesOnThePapersField) {
  EXPECT_GT(share_found("robocup-2001", 40), 0.8);
}

TEST(Hough2001, RunsOnTheFieldOfTodayAsFarAsItCan) {
  EXPECT_GT(share_found("msl-2024", 40), 0.15);
}

// Beside a corner of the goal area two goal lines, two area fronts and the centre line can be laid
// over each other in four ways that match alike: only the goals' colours tell them apart.
TEST(Hough2001, AsksTheGoalsWhichOfEqualMaximaIsRight) {
  const FieldModel field = field_file("robocup-2001");
  const CameraParameters camera = settings::load_camera(config("cameras/sim-640"));
  locate_score::RenderedView view(camera, camera, field, 2.0);
  Hough2001 hough(camera, field);
  for (const double x : {-2.97, 2.97}) {
    for (int heading = 0; heading < 8; ++heading) {
      const Pose<Field, Robot> truth(x, 1.35, heading * std::numbers::pi / 4.0 + 0.05);
      view.draw(truth, {});

      const Hough2001Result found = hough.locate(view.image());

      EXPECT_EQ(found.status, PostureStatus::kOk) << x << ", heading " << heading;
      EXPECT_LT((found.X_FR.origin().vector() - truth.origin().vector()).norm(), 0.15);
      EXPECT_LT(std::abs(angle_difference(found.X_FR.theta(), truth.theta())), 0.035);
    }
  }
}

TEST(Hough2001, SaysNothingWithoutTransitions) {
  LineHough hough(0.025, 6.0);

  EXPECT_TRUE(hough2001_candidates(hough, field_lines_of(field_file("msl-2024")), {}, {}).empty());
}

}  // namespace
}  // namespace teamsight::vision
