// tests/vision/virtual_sensors_test.cpp: the founding paper's five sensors on painted windows.
#include "vision/virtual_sensors.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "vision/ball_detector.hpp"

namespace teamsight::vision {
namespace {

constexpr std::uint32_t kSide = 64;

/// A grey-green picture on which squares can be painted; BGR.
class Picture {
 public:
  Picture() { paint(0, 0, kSide, {60, 140, 70}); }

  void paint(std::uint32_t u,
             std::uint32_t v,
             std::uint32_t side,
             std::array<std::uint8_t, 3> bgr) {
    for (std::uint32_t y = v; y < v + side; ++y) {
      for (std::uint32_t x = u; x < u + side; ++x) {
        std::copy(bgr.begin(), bgr.end(), bytes_.begin() + 3 * (y * kSide + x));
      }
    }
  }

  [[nodiscard]] PixelReader reader() const {
    return PixelReader({bytes_, kSide, kSide, PixelFormat::kBgr});
  }

 private:
  std::vector<std::uint8_t> bytes_ = std::vector<std::uint8_t>(3 * kSide * kSide);
};

constexpr std::array<std::uint8_t, 3> kBlack{10, 10, 10};
constexpr std::array<std::uint8_t, 3> kWhite{240, 240, 240};
constexpr std::array<std::uint8_t, 3> kBlue{220, 60, 30};

ColourClasses colours() {
  ColourParameters parameters;
  parameters.sectors = {{ColourClass::kGreen, -3.0, -1.5, 10, 255},
                        {ColourClass::kBlue, -0.9, 0.4, 25, 255}};
  return ColourClasses(parameters);
}

Polygon square(double u, double v, double side) {
  return {{u, v}, {u + side, v}, {u + side, v + side}, {u, v + side}};
}

SensorValue read_one(const SensorWindows& windows,
                     const Picture& picture,
                     std::span<const BallCandidate> balls = {}) {
  VirtualSensors sensors({windows}, kSide, kSide);
  return sensors.read(picture.reader(), colours(), balls).front();
}

BallCandidate ball_at(double u, double v) {
  BallCandidate ball;
  ball.pixels = {u, v, 4.0, true};
  ball.ray.confidence = 0.8;
  return ball;
}

TEST(VirtualSensors, ABumperSumsUpBlackAndWhite) {
  const SensorWindows bumper{"1",
                             SensorKind::kBumper,
                             {ColourClass::kBlack, ColourClass::kWhite},
                             {square(20, 20, 10)},
                             0.4};
  Picture picture;
  EXPECT_FALSE(read_one(bumper, picture).triggered);

  picture.paint(20, 20, 5, kBlack);
  picture.paint(25, 25, 5, kWhite);

  const SensorValue value = read_one(bumper, picture);
  EXPECT_NEAR(value.value, 0.5, 0.1);
  EXPECT_TRUE(value.triggered);
}

TEST(VirtualSensors, AGoalCountsOnlyInsideItsWindows) {
  const SensorWindows goal{"goal",
                           SensorKind::kGoal,
                           {ColourClass::kBlue},
                           {square(0, 0, 16), square(24, 0, 16), square(48, 0, 16)},
                           0.2};
  Picture beside;
  beside.paint(24, 40, 16, kBlue);
  Picture inside;
  inside.paint(24, 0, 16, kBlue);

  EXPECT_EQ(read_one(goal, beside).value, 0.0);
  EXPECT_NEAR(read_one(goal, inside).value, 1.0 / 3.0, 0.05);
  EXPECT_TRUE(read_one(goal, inside).triggered);
}

TEST(VirtualSensors, TheKickIsFreeOnlyWithTheBallsCentreInItsWindow) {
  const SensorWindows kick{"kick", SensorKind::kKick, {}, {square(28, 10, 8)}, 0.5};
  const std::vector<BallCandidate> near{ball_at(31.0, 15.0)};
  const std::vector<BallCandidate> far{ball_at(31.0, 30.0)};

  EXPECT_TRUE(read_one(kick, {}, near).triggered);
  EXPECT_FALSE(read_one(kick, {}, far).triggered);
}

TEST(VirtualSensors, CalibrationFailsWhenTheLensHasMoved) {
  const SensorWindows lens{"lens", SensorKind::kCalibration, {}, {square(26, 26, 12)}, 0.8};
  Picture in_place;
  in_place.paint(28, 28, 8, kBlack);
  Picture moved;
  moved.paint(34, 28, 8, kBlack);

  EXPECT_TRUE(read_one(lens, in_place).triggered);
  EXPECT_FALSE(read_one(lens, moved).triggered);
  EXPECT_FALSE(read_one(lens, {}).triggered);
}

TEST(VirtualSensors, WindowsMayLeaveTheImage) {
  const SensorWindows sensor{"rim",
                             SensorKind::kColour,
                             {ColourClass::kGreen},
                             {square(-20, -20, 40), square(100, 100, 9)},
                             0.5};

  EXPECT_NEAR(read_one(sensor, {}).value, 1.0, 1e-9);
}

}  // namespace
}  // namespace teamsight::vision
