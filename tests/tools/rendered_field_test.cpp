// tests/tools/rendered_field_test.cpp: what is asked for in a rendered scene, and what is not.
#include "tools/rendered_field.hpp"

#include <gtest/gtest.h>

#include "settings/load.hpp"
#include "tests/support/process.hpp"
#include "tests/vision/synthetic_points.hpp"

namespace teamsight::tools {
namespace {

sim::Renderer eye() {
  const auto camera = settings::load_camera(test::source_path("config/cameras/sim-640.textproto"));
  return {camera, vision::test_field(), {}};
}

sim::SceneRobot robot_at(double x, double y) {
  sim::SceneRobot robot;
  robot.p_F = {x, y};
  return robot;
}

sim::Scene with_ball_at(double x, double y) {
  sim::Scene scene;
  scene.balls = {{{x, y, 0.11}, {}, 0.11, {240, 110, 20}}};
  return scene;
}

TEST(RenderedLabels, AskForABallThatIsFreeAndNotForOneBehindARobot) {
  const sim::Renderer renderer = eye();
  sim::Scene scene = with_ball_at(3.0, 0.0);

  const ImageLabels alone = labels_of(scene, renderer, {});
  scene.robots = {robot_at(1.5, 0.1)};
  const ImageLabels behind = labels_of(scene, renderer, {});

  ASSERT_EQ(alone.balls.size(), 1U);
  EXPECT_TRUE(alone.balls[0].counts);
  ASSERT_EQ(behind.balls.size(), 1U);
  EXPECT_FALSE(behind.balls[0].counts);
  EXPECT_TRUE(behind.robots.at(0).counts);
}

TEST(RenderedLabels, DoNotAskBeyondReach) {
  const ImageLabels labels = labels_of(with_ball_at(5.0, 0.0), eye(), {4.0, 4.0});

  ASSERT_EQ(labels.balls.size(), 1U);
  EXPECT_FALSE(labels.balls[0].counts);
}

TEST(RenderedLabels, MarkARobotWhereItStandsNearestToTheEye) {
  const sim::Renderer renderer = eye();
  sim::Scene scene;
  scene.robots = {robot_at(2.0, 0.0)};

  const ImageLabels labels = labels_of(scene, renderer, {});

  const auto foot = renderer.find({1.75, 0.0, 0.0});
  ASSERT_TRUE(foot);
  EXPECT_NEAR(labels.robots.at(0).u, foot->u, 1e-6);
  EXPECT_NEAR(labels.robots.at(0).v, foot->v, 1e-6);
}

TEST(RenderedScene, IsTheSameForTheSameSeedAndStandsInNothingElse) {
  sim::Random first(3);
  sim::Random second(3);

  const sim::Scene a = random_scene(vision::test_field(), first);
  const sim::Scene b = random_scene(vision::test_field(), second);

  EXPECT_EQ(a.X_FR, b.X_FR);
  ASSERT_EQ(a.robots.size(), 5U);
  for (std::size_t i = 0; i < a.robots.size(); ++i) {
    EXPECT_EQ(a.robots[i].p_F, b.robots[i].p_F);
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_GT((a.robots[i].p_F.vector() - a.robots[k].p_F.vector()).norm(), 0.5);
    }
  }
}

}  // namespace
}  // namespace teamsight::tools
