// tests/agent/coloured_goals_test.cpp: from a picture with a coloured goal to the right half.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "agent/locator.hpp"
#include "bench/locate_score/rendered_view.hpp"
#include "settings/load.hpp"
#include "tests/support/geometry_matchers.hpp"
#include "tests/support/process.hpp"

namespace teamsight::agent {
namespace {

using testing_support::IsNear;

HostTime at(double seconds) {
  return HostTime{from_seconds(seconds)};
}

TEST(ColouredGoals, BringARobotThatBelievesTheWrongHalfToTheRightOne) {
  const auto camera = settings::load_camera(test::source_path("config/cameras/sim-640.textproto"));
  const auto field =
      settings::load_field(test::source_path("config/fields/robocup-2001.textproto"));
  locate_score::RenderedView view(camera, camera, field, 3.0);
  const Pose<Field, Robot> truth(2.0, 0.5, 0.3);
  view.draw(truth, {});
  const vision::Perception::Cues cues = view.cues();
  ASSERT_THAT(cues.goals, ::testing::Not(::testing::IsEmpty()));

  vision::LocalisationParameters parameters;
  parameters.tilt = view.head();
  Locator locator(field, parameters);
  const Pose<Field, Robot> wrong = mirrored(truth, field.centre);
  locator.place(wrong, 0.01 * Eigen::Matrix3d::Identity(), at(10.0));
  const PostureEstimate before = locator.see({cues.line_points, {}}, at(10.03)).estimate;
  PostureEstimate after;
  for (int i = 2; i < 60; ++i) after = locator.see(cues, at(10.0 + 0.033 * i)).estimate;

  EXPECT_THAT(before.X_FR.origin(), IsNear(wrong.origin(), 0.05));
  EXPECT_THAT(after.X_FR.origin(), IsNear(truth.origin(), 0.05));
  EXPECT_EQ(after.status, PostureStatus::kOk);
}

}  // namespace
}  // namespace teamsight::agent
