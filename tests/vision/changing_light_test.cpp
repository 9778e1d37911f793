// tests/vision/changing_light_test.cpp: the light of a rendered hall changes its colour and
// brightness, and comes back; what is on the field stays in sight.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "settings/load.hpp"
#include "sim/match/random.hpp"
#include "sim/render/renderer.hpp"
#include "tests/support/process.hpp"
#include "tests/vision/synthetic_points.hpp"
#include "vision/light_adaptation.hpp"
#include "vision/perception.hpp"

namespace teamsight::vision {
namespace {

constexpr double kStep = 0.4;      // s
constexpr double kEvening = 10.0;  // s; until then the light changes
constexpr double kBack = 20.0;     // s; by then it is as before
constexpr double kEnd = 23.0;      // s
const Pose<Field, Robot> kX_FR{-1.2, 0.8, 0.6};
const Point3<Field> kBall{0.3, 0.6, 0.11};

/// What the light comes to.
struct Change {
  const char* name;
  LightGains gains;
};

LightGains light_at(double seconds, const LightGains& most) {
  const double share = seconds < kEvening ? seconds / kEvening
                                          : std::max(0.0, (kBack - seconds) / (kBack - kEvening));
  return {std::pow(most.red, share), std::pow(most.green, share), std::pow(most.blue, share)};
}

std::vector<std::uint8_t> in_light(std::vector<std::uint8_t> bgr, const LightGains& gains) {
  const double gain[3] = {gains.blue, gains.green, gains.red};
  for (std::size_t i = 0; i < bgr.size(); ++i) {
    bgr[i] = static_cast<std::uint8_t>(std::min(255.0, std::round(gain[i % 3] * bgr[i])));
  }
  return bgr;
}

CameraParameters colour_camera() {
  CameraParameters camera =
      settings::load_camera(test::source_path("config/cameras/sim-640.textproto"));
  camera.format = PixelFormat::kBgr;
  return camera;
}

/// A hall, and an eye in it that may follow the light.
class Hall {
 public:
  Hall(bool follows, const LightGains& most)
      : most_(most),
        camera_(colour_camera()),
        perception_(camera_, test_field()),
        renderer_(camera_, test_field(), {}),
        follows_(follows),
        adaptation_(perception_.field_colours(view_of(picture({})))) {}

  const FrameObservation& look(double seconds) {
    const ImageView frame = view_of(picture(light_at(seconds, most_)));
    if (follows_) {
      adaptation_.take(perception_.field_colours(frame), kStep);
      perception_.adapt(adaptation_.state().gains);
    }
    MotionPrior prior;
    prior.X_FR = kX_FR;
    return *perception_.see(frame, prior).value();
  }

  [[nodiscard]] const LightState& light() const { return adaptation_.state(); }

 private:
  const std::vector<std::uint8_t>& picture(const LightGains& gains) {
    sim::Scene scene;
    scene.X_FR = kX_FR;
    scene.balls = {{kBall, {}, 0.11, {240, 110, 20}}};
    renderer_.draw(scene, random_, drawn_);
    shown_ = in_light(drawn_, gains);
    return shown_;
  }

  [[nodiscard]] ImageView view_of(const std::vector<std::uint8_t>& bytes) const {
    return {bytes, camera_.width_px, camera_.height_px, camera_.format};
  }

  LightGains most_;
  CameraParameters camera_;
  Perception perception_;
  sim::Renderer renderer_;
  sim::Random random_{5};
  std::vector<std::uint8_t> drawn_;
  std::vector<std::uint8_t> shown_;
  bool follows_;
  LightAdaptation adaptation_;
};

bool sees_the_ball(const FrameObservation& seen) {
  const Point3<Robot> p_RB = [] {
    const Point<Robot> floor = kX_FR.inverse() * Point<Field>{kBall.x, kBall.y};
    return Point3<Robot>{floor.x, floor.y, kBall.z};
  }();
  return std::ranges::any_of(seen.balls, [&](const BallRay& ball) {
    const Eigen::Vector3d way = (p_RB.vector() - ball.ray_R.origin.vector()).normalized();
    return ball.confidence > 0.5 && std::acos(ball.ray_R.direction.dot(way)) < 0.02;
  });
}

struct Seen {
  int frames{0};
  int balls{0};
  int postures{0};
  std::size_t fewest_line_points{1000};
};

Seen play(Hall& hall, double from, double until) {
  Seen seen;
  for (double t = from; t < until; t += kStep) {
    const FrameObservation& frame = hall.look(t);
    ++seen.frames;
    if (sees_the_ball(frame)) ++seen.balls;
    if (frame.posture.status != PostureStatus::kLost) ++seen.postures;
    seen.fewest_line_points = std::min(seen.fewest_line_points, frame.line_points.size());
  }
  return seen;
}

class ChangingLight : public testing::TestWithParam<Change> {};

TEST_P(ChangingLight, IsFollowedThereAndBack) {
  const LightGains& most = GetParam().gains;
  Hall hall(true, most);
  const std::size_t at_first = hall.look(0.0).line_points.size();

  const Seen there = play(hall, kStep, kEvening);
  const LightGains changed = hall.light().gains;
  const Seen back = play(hall, kEvening, kEnd);

  EXPECT_EQ(there.balls + back.balls, there.frames + back.frames);
  EXPECT_EQ(there.postures + back.postures, there.frames + back.frames);
  EXPECT_GT(std::min(there.fewest_line_points, back.fewest_line_points), at_first / 2);
  EXPECT_NEAR(changed.red / changed.blue, most.red / most.blue, 0.1);
  EXPECT_NEAR(exposure_of(changed) / exposure_of(most), 1.0, 0.1);
  EXPECT_NEAR(hall.light().gains.red, 1.0, 0.02);
  EXPECT_NEAR(hall.light().gains.blue, 1.0, 0.02);
  EXPECT_GT(hall.light().confidence, 0.9);
}

// Or the test before would show nothing.
TEST_P(ChangingLight, IsTooMuchForClassesThatStayAsTheyAre) {
  Hall hall(false, GetParam().gains);
  const std::size_t at_first = hall.look(0.0).line_points.size();

  const Seen changed = play(hall, 0.9 * kEvening, 1.1 * kEvening);

  EXPECT_TRUE(changed.balls < changed.frames || changed.fewest_line_points < at_first / 2);
}

class ShippedLight : public testing::TestWithParam<const char*> {};

// An agent with this file would else begin by taking a hall for another light.
TEST_P(ShippedLight, IsThatOfTheSimulatedHall) {
  const CameraParameters camera =
      settings::load_camera(test::source_path(std::string("config/cameras/") + GetParam()));
  Perception perception(camera, test_field());
  sim::Renderer renderer(camera, test_field(), {});
  sim::Random random(5);
  LightAdaptation adaptation(perception.light());
  std::vector<std::uint8_t> bytes;
  for (int i = 0; i < 20; ++i) {
    sim::Scene scene;
    scene.X_FR = {0.2 * i - 2.0, 0.8, 0.3 * i};
    renderer.draw(scene, random, bytes);
    adaptation.take(
        perception.field_colours({bytes, camera.width_px, camera.height_px, camera.format}), kStep);
  }

  EXPECT_EQ(adaptation.state().status, LightStatus::kFollowing);
  EXPECT_NEAR(exposure_of(adaptation.state().gains), 1.0, 0.04);
  EXPECT_NEAR(adaptation.state().gains.red / adaptation.state().gains.green, 1.0, 0.04);
  EXPECT_NEAR(adaptation.state().gains.blue / adaptation.state().gains.green, 1.0, 0.04);
}

INSTANTIATE_TEST_SUITE_P(Cameras,
                         ShippedLight,
                         testing::Values("sim-640.textproto", "sim-isometric.textproto"),
                         [](const auto& test) {
                           const std::string file = test.param;
                           return std::string(file == "sim-640.textproto" ? "Sim640" : "Isometric");
                         });

INSTANTIATE_TEST_SUITE_P(Halls,
                         ChangingLight,
                         testing::Values(Change{"ColdDusk", {0.42, 0.55, 0.8}},
                                         Change{"Sun", {1.7, 1.7, 1.7}},
                                         Change{"PinkLamps", {0.9, 0.55, 0.9}}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace teamsight::vision
