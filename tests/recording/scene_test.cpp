// tests/recording/scene_test.cpp: field and world as scenes.
#include "recording/scene.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include <gmock/gmock.h>

#include "foxglove.pb.h"
#include "settings/load.hpp"
#include "tests/bus/samples.hpp"
#include "tests/support/process.hpp"

namespace teamsight::recording {
namespace {

using ::testing::ElementsAre;

constexpr std::int64_t kLogNs = 1'700'000'000'250'000'000;

template <class Message>
Message parsed(const std::string& bytes) {
  Message message;
  EXPECT_TRUE(message.ParseFromString(bytes));
  return message;
}

foxglove::SceneUpdate scene_of(const std::string& bytes) {
  return parsed<foxglove::SceneUpdate>(bytes);
}

/// A world with one of everything at known places.
WorldModel small_world() {
  WorldModel world;
  WorldBall ball;
  ball.track = 7;
  ball.p_FB = {1.0, 2.0, 0.11};
  ball.v_FB = {0.0, 3.0, 0.0};
  ball.cov_p = Eigen::Vector3d(0.04, 0.01, 0.01).asDiagonal();
  ball.existence = 0.5;
  ball.supporters = robot_bit(2) | robot_bit(5);
  world.balls.push_back(ball);
  WorldTeammate mate;
  mate.robot = 3;
  mate.X_FR = {-4.0, 1.0, std::numbers::pi / 2};
  mate.cov = Eigen::Vector3d(0.01, 0.01, 0.01).asDiagonal();
  mate.status = PostureStatus::kOk;
  world.teammates.push_back(mate);
  mate.robot = 4;
  mate.status = PostureStatus::kLost;
  world.teammates.push_back(mate);
  WorldObstacle obstacle;
  obstacle.track = 12;
  obstacle.p_FO = {5.0, -1.0};
  obstacle.radius = 0.25;
  obstacle.cov_p = Eigen::Matrix2d::Identity() * 0.01;
  world.obstacles.push_back(obstacle);
  return world;
}

TEST(Scene, DrawsTheBallWithVelocityEllipseAndWhoSawIt) {
  const foxglove::SceneUpdate scene = scene_of(ball_scene(small_world(), kLogNs));

  ASSERT_EQ(scene.entities_size(), 1);
  const foxglove::SceneEntity& ball = scene.entities(0);
  EXPECT_EQ(ball.id(), "ball_7");
  EXPECT_EQ(ball.frame_id(), "field");
  EXPECT_EQ(ball.timestamp().seconds(), 1'700'000'000);
  EXPECT_EQ(ball.timestamp().nanos(), 250'000'000);
  EXPECT_EQ(ball.lifetime().nanos(), 500'000'000);
  EXPECT_EQ(ball.spheres(0).pose().position().y(), 2.0);
  EXPECT_EQ(ball.spheres(0).size().x(), 0.22);
  EXPECT_NEAR(ball.arrows(0).shaft_length() + ball.arrows(0).head_length(), 3.0, 1e-12);
  EXPECT_NEAR(ball.arrows(0).pose().orientation().z(), std::sin(std::numbers::pi / 4), 1e-12);
  const foxglove::CylinderPrimitive& ellipse = ball.cylinders(0);
  const double longest = std::max(ellipse.size().x(), ellipse.size().y());
  EXPECT_NEAR(longest, 2 * 2.4477 * 0.2, 1e-9) << "95 % in two dimensions";
  EXPECT_EQ(ball.metadata(1).value(), "2 5");
}

TEST(Scene, DrawsRobotsThatKnowWhereTheyAreAndTheirFrames) {
  const foxglove::SceneUpdate scene = scene_of(robot_scene(small_world(), kLogNs));
  const auto frames = parsed<foxglove::FrameTransforms>(robot_frames(small_world(), kLogNs));

  ASSERT_EQ(scene.entities_size(), 1);
  EXPECT_EQ(scene.entities(0).id(), "robot_3");
  EXPECT_EQ(scene.entities(0).cylinders(0).pose().position().x(), -4.0);
  ASSERT_EQ(frames.transforms_size(), 1);
  EXPECT_EQ(frames.transforms(0).parent_frame_id(), "field");
  EXPECT_EQ(frames.transforms(0).child_frame_id(), "robot_3");
  EXPECT_NEAR(frames.transforms(0).rotation().z(), std::sin(std::numbers::pi / 4), 1e-12);
}

TEST(Scene, DrawsNoEllipseWithoutACovariance) {
  WorldModel world = small_world();
  world.obstacles[0].cov_p.setZero();

  const foxglove::SceneUpdate scene = scene_of(obstacle_scene(world, kLogNs));

  EXPECT_EQ(scene.entities(0).id(), "obstacle_12");
  EXPECT_EQ(scene.entities(0).cylinders_size(), 1) << "the obstacle itself";
}

TEST(Scene, DrawsTheFieldOnceAndForAll) {
  const FieldModel field =
      settings::load_field(test::source_path("config/fields/msl-2024.textproto"));

  const foxglove::SceneUpdate scene = scene_of(field_scene(field, kLogNs));

  const foxglove::SceneEntity& drawn = scene.entities(0);
  EXPECT_EQ(drawn.lifetime().seconds() + drawn.lifetime().nanos(), 0);
  EXPECT_EQ(static_cast<std::size_t>(drawn.lines(0).points_size()), 2 * field.lines.size());
  EXPECT_EQ(static_cast<std::size_t>(drawn.lines_size()),
            1 + field.arcs.size() + field.goals.size());
}

/// Keeps what is written, and wants only some channels.
class Notebook : public MessageSink {
 public:
  ChannelId add_channel(Channel channel) override {
    topics.push_back(channel.topic);
    return topics.size() - 1;
  }

  [[nodiscard]] bool is_wanted(ChannelId channel) const override {
    return topics[channel] == wanted;
  }

  void write(ChannelId channel,
             HostTime /*received*/,
             PeerTime stamp,
             std::string payload) override {
    written[topics[channel]] = payload;
    newest = stamp;
  }

  [[nodiscard]] Duration log_minus_host() const override { return std::chrono::seconds(5); }

  std::string wanted;
  std::vector<std::string> topics;
  std::map<std::string, std::string> written;
  PeerTime newest;
};

TEST(SceneChannels, MakeOnlyWhatSomebodyWantsAndFileItByArrival) {
  Notebook sink;
  SceneChannels scenes(sink);
  sink.wanted = "scene/robots";
  WorldModel world = small_world();
  world.stamp = PeerTime(std::chrono::seconds(99));

  scenes.write(world, HostTime(std::chrono::seconds(3)));

  ASSERT_EQ(sink.written.size(), 1U);
  const auto scene = scene_of(sink.written["scene/robots"]);
  EXPECT_EQ(scene.entities(0).timestamp().seconds(), 8);
  EXPECT_EQ(sink.newest, world.stamp);
  EXPECT_THAT(
      sink.topics,
      ElementsAre("scene/field", "scene/ball", "scene/robots", "scene/obstacles", "scene/frames"));
}

TEST(LogEntry, IsFoxglovesLog) {
  const auto entry =
      parsed<foxglove::Log>(log_entry(LogLevel::kWarning, "station", "Robot 2 is silent", kLogNs));

  EXPECT_EQ(entry.level(), foxglove::Log::WARNING);
  EXPECT_EQ(entry.message(), "Robot 2 is silent");
  EXPECT_EQ(log_channel().schema.name, "foxglove.Log");
}

}  // namespace
}  // namespace teamsight::recording
