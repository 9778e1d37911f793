// tests/sim/render/shipped_sensors_test.cpp: the paper's five virtual sensors, as the simulated
// robots' camera file declares them, in rendered frames.
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "settings/load.hpp"
#include "sim/render/renderer.hpp"
#include "sim/show.hpp"
#include "tests/support/process.hpp"
#include "vision/perception.hpp"

namespace teamsight::sim {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

vision::CameraParameters camera() {
  return settings::load_camera(test::source_path("config/cameras/sim-640.textproto"));
}

/// The field with a blue and a yellow goal, and a robot that looks around on it.
class ShippedSensors : public ::testing::Test {
 protected:
  /// Whether each sensor triggers, by its name.
  std::map<std::string, bool> triggered(const Scene& scene) {
    std::vector<std::uint8_t> bytes;
    renderer_.draw(scene, random_, bytes);
    const auto seen = perception_.see({bytes, camera_.width_px, camera_.height_px, camera_.format},
                                      {scene.X_FR, {}, {}});
    std::map<std::string, bool> by_name;
    if (!seen) return by_name;
    for (const vision::SensorValue& sensor : (*seen)->sensors) {
      by_name[sensor.name] = sensor.triggered;
    }
    return by_name;
  }

  static PictureParameters with_body() {
    PictureParameters look;
    look.body = low_body();
    return look;
  }

  const vision::CameraParameters camera_ = camera();
  const FieldModel field_ =
      settings::load_field(test::source_path("config/fields/robocup-2001.textproto"));
  Renderer renderer_{camera_, field_, with_body()};
  vision::Perception perception_{camera_, field_};
  Random random_{11};
};

TEST_F(ShippedSensors, AreQuietOnTheEmptyCarpetAndKnowTheirLens) {
  for (const Pose<Field, Robot>& X_FR :
       {Pose<Field, Robot>{1.5, 1.2, 0.4}, Pose<Field, Robot>{-2.0, -1.0, 2.0}}) {
    Scene scene;
    scene.X_FR = X_FR;

    std::map<std::string, bool> triggers = triggered(scene);

    ASSERT_EQ(triggers.size(), 14U);
    EXPECT_TRUE(triggers["lens"]);
    EXPECT_FALSE(triggers["ball"]);
    EXPECT_FALSE(triggers["kick"]);
    for (int i = 1; i <= 9; ++i) EXPECT_FALSE(triggers["bumper-" + std::to_string(i)]) << i;
  }
}

TEST_F(ShippedSensors, FeelARobotWithTheBumperOnItsSideOnly) {
  for (int i = 0; i < 9; ++i) {
    Scene scene;
    scene.X_FR = {1.5, 1.2, 0.0};
    const double direction = kTurn * i / 9;  // to the left
    scene.robots.push_back(
        {{1.5 + 0.8 * std::cos(direction), 1.2 + 0.8 * std::sin(direction)}, {}});

    std::map<std::string, bool> triggers = triggered(scene);

    for (int k = 0; k < 9; ++k) {
      EXPECT_EQ(triggers["bumper-" + std::to_string(k + 1)], k == i) << "robot at " << i;
    }
  }
}

TEST_F(ShippedSensors, FreeTheKickOnlyForABallThatTouches) {
  Scene touching;
  touching.X_FR = {1.5, 1.2, 0.4};
  Scene ahead = touching;
  Scene beside = touching;
  const auto place = [&](double x, double y) {
    const Point<Field> p_FB = touching.X_FR * Point<Robot>{x, y};
    return SceneBall{{p_FB.x, p_FB.y, 0.11}, {}};
  };
  touching.balls.push_back(place(0.37, 0.0));
  ahead.balls.push_back(place(1.0, 0.0));
  beside.balls.push_back(place(0.0, 0.5));

  EXPECT_TRUE(triggered(touching)["kick"]);
  EXPECT_TRUE(triggered(touching)["ball"]);
  EXPECT_FALSE(triggered(ahead)["kick"]);
  EXPECT_TRUE(triggered(ahead)["ball"]);
  EXPECT_FALSE(triggered(beside)["kick"]);
}

TEST_F(ShippedSensors, SeeEachGoalInTheTopWindowsAlone) {
  const auto colour_ahead = [&](double theta) {
    Scene scene;
    scene.X_FR = {0.0, 0.0, theta};
    std::map<std::string, bool> triggers = triggered(scene);
    return std::pair(triggers["goal-blue"], triggers["goal-yellow"]);
  };
  const auto ahead = colour_ahead(0.0);
  const auto back = colour_ahead(std::numbers::pi);

  EXPECT_NE(ahead.first, ahead.second) << "one goal ahead";
  EXPECT_EQ(back, std::pair(ahead.second, ahead.first)) << "the other one behind";
  EXPECT_EQ(colour_ahead(0.5 * std::numbers::pi), std::pair(false, false)) << "none at the side";
}

}  // namespace
}  // namespace teamsight::sim
