// tests/bus/wire_property_test.cpp: round trips of random messages, and random bytes as wire
// samples.
#include <array>
#include <cstring>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "bus/wire.hpp"
#include "tests/bus/samples.hpp"
#include "tests/support/property.hpp"

namespace teamsight::bus {
namespace {

using testing_support::holds_for_all;

constexpr std::uint64_t kSeed = 20240607;

double number(double low, double high) {
  const auto steps = *rc::gen::inRange<std::int64_t>(0, 1'000'000'001);
  return low + (high - low) * static_cast<double>(steps) / 1e9;
}

template <int Size>
Eigen::Matrix<double, Size, Size> covariance() {
  Eigen::Matrix<double, Size, Size> root;
  for (double& element : root.reshaped()) element = number(-3.0, 3.0);
  return root * root.transpose() + 1e-2 * Eigen::Matrix<double, Size, Size>::Identity();
}

ObservationId any_id() {
  return {*rc::gen::inRange<RobotId>(1, 17),
          *rc::gen::inRange<std::uint32_t>(1, 0xFFFFFFFF),
          *rc::gen::inRange<std::uint32_t>(1, 0xFFFFFFFF)};
}

PostureEstimate any_posture() {
  PostureEstimate posture;
  posture.status = static_cast<PostureStatus>(*rc::gen::inRange(0, 3));
  posture.X_FR = {number(-20, 20), number(-20, 20), number(-10, 10)};
  posture.cov = covariance<3>();
  posture.half_log_odds = number(-50, 50);
  posture.inlier_ratio = number(0, 1);
  posture.line_points = *rc::gen::arbitrary<std::uint16_t>();
  return posture;
}

BallRay any_ball() {
  BallRay ball;
  ball.ray_R.origin = {number(-0.5, 0.5), number(-0.5, 0.5), number(0, 1)};
  ball.ray_R.direction = Eigen::Vector3d(number(0.1, 1), number(-1, 1), number(-1, 1)).normalized();
  ball.angular_radius = number(0, 1.5);
  ball.cov_direction = covariance<2>();
  ball.sigma_angular_radius = number(0, 1);
  ball.confidence = number(0, 1);
  ball.colour = static_cast<BallColour>(*rc::gen::inRange(0, 5));
  return ball;
}

Sightings any_sightings() {
  Sightings m;
  m.id = any_id();
  m.exposure = testing::at_ms(*rc::gen::inRange<std::int64_t>(0, 1'000'000'000));
  m.published = m.exposure + Duration{*rc::gen::inRange(0, 1'000'000'000)};
  m.posture = any_posture();
  m.light = static_cast<Light>(*rc::gen::inRange(0, 5));
  m.balls.resize(*rc::gen::inRange<std::size_t>(0, kMaxBallRays + 1));
  for (BallRay& ball : m.balls) ball = any_ball();
  m.obstacles.resize(*rc::gen::inRange<std::size_t>(0, kMaxObstacleSightings + 1));
  for (ObstacleSighting& o : m.obstacles) {
    o = {{number(-30, 30), number(-30, 30)}, covariance<2>(), number(0, 2), number(0, 1), 0.5};
  }
  return m;
}

WorldModel any_world() {
  WorldModel m;
  m.id = any_id();
  m.strength = *rc::gen::arbitrary<std::uint16_t>();
  m.stamp = testing::at_ms(*rc::gen::inRange<std::int64_t>(0, 1'000'000'000));
  m.balls.resize(*rc::gen::inRange<std::size_t>(0, kMaxWorldBalls + 1));
  for (WorldBall& ball : m.balls) {
    ball.p_FB = {number(-20, 20), number(-20, 20), number(0, 4)};
    ball.v_FB = {number(-20, 20), number(-20, 20), number(-9, 9)};
    ball.cov_p = covariance<3>();
    ball.cov_v = covariance<3>();
    ball.existence = number(0, 1);
    ball.age = Duration{*rc::gen::inRange<std::int64_t>(0, 60'000'000'000)};
    ball.supporters = *rc::gen::arbitrary<RobotMask>();
  }
  m.obstacles.resize(*rc::gen::inRange<std::size_t>(0, kMaxWorldObstacles + 1));
  for (WorldObstacle& o : m.obstacles) {
    o.p_FO = {number(-20, 20), number(-20, 20)};
    o.cov_p = covariance<2>();
    o.radius = number(0, 60);
    o.existence = number(0, 1);
    o.age = Duration{*rc::gen::inRange<std::int64_t>(0, 60'000'000'000)};
  }
  return m;
}

template <class Message>
Message through_the_wire(const Message& message) {
  WireSample<Message> wire;
  RC_ASSERT(!to_wire(message, wire));
  const auto back = from_wire<Message>(wire.sample);
  RC_ASSERT(back.has_value());
  return *back;
}

TEST(WireProperty, SightingsArriveAsExactlyAsTheirTypes) {
  holds_for_all(kSeed, [] {
    const Sightings sent = any_sightings();

    const Sightings got = through_the_wire(sent);

    RC_ASSERT(got.id == sent.id && got.exposure == sent.exposure && got.light == sent.light);
    RC_ASSERT(std::abs(got.posture.X_FR.x() - sent.posture.X_FR.x()) < 1e-5);
    RC_ASSERT(got.posture.cov.isApprox(sent.posture.cov, 1e-6));
    RC_ASSERT(got.balls.size() == sent.balls.size());
    for (std::size_t i = 0; i < got.balls.size(); ++i) {
      RC_ASSERT(got.balls[i].ray_R.direction.isApprox(sent.balls[i].ray_R.direction, 1e-6));
      RC_ASSERT(std::abs(got.balls[i].ray_R.direction.norm() - 1.0) < 1e-12);
      RC_ASSERT(got.balls[i].colour == sent.balls[i].colour);
    }
    RC_ASSERT(got.obstacles.size() == sent.obstacles.size());
    for (std::size_t i = 0; i < got.obstacles.size(); ++i) {
      RC_ASSERT(std::abs(got.obstacles[i].p_RO.y - sent.obstacles[i].p_RO.y) < 1e-5);
      RC_ASSERT(std::abs(got.obstacles[i].confidence - sent.obstacles[i].confidence) <= 0.00501);
    }
  });
}

TEST(WireProperty, WhatWentThroughTheWireOnceGoesThroughUnchanged) {
  holds_for_all(kSeed, [] {
    const WorldModel once = through_the_wire(any_world());

    RC_ASSERT(through_the_wire(once) == once);
  });
}

TEST(WireProperty, WorldsArriveAsExactlyAsTheirTypes) {
  holds_for_all(kSeed, [] {
    const WorldModel sent = any_world();

    const WorldModel got = through_the_wire(sent);

    RC_ASSERT(got.id == sent.id && got.stamp == sent.stamp && got.strength == sent.strength);
    RC_ASSERT(got.balls.size() == sent.balls.size());
    for (std::size_t i = 0; i < got.balls.size(); ++i) {
      RC_ASSERT((got.balls[i].p_FB.vector() - sent.balls[i].p_FB.vector()).norm() < 1e-5);
      RC_ASSERT(std::chrono::abs(got.balls[i].age - sent.balls[i].age) <=
                std::chrono::microseconds(500));
    }
    for (std::size_t i = 0; i < got.obstacles.size(); ++i) {
      RC_ASSERT(std::abs(got.obstacles[i].radius - sent.obstacles[i].radius) <= 0.000501);
    }
  });
}

/// Overwrites some bytes of a full wire sample, its pointers aside, and reads it.
template <class Message>
void damaged_samples_are_refused_or_valid() {
  holds_for_all(kSeed, [] {
    WireSample<Message> wire;
    RC_ASSERT(!to_wire(testing::full<Message>(), wire));
    const auto hits = *rc::gen::container<std::vector<std::pair<std::size_t, std::uint8_t>>>(
        rc::gen::pair(rc::gen::inRange<std::size_t>(0, sizeof wire.sample),
                      rc::gen::arbitrary<std::uint8_t>()));
    auto copy = wire.sample;
    auto* const damaged = reinterpret_cast<unsigned char*>(&copy);
    for (const auto& [at, value] : hits) damaged[at] = value;
    if constexpr (requires { copy.balls; }) copy.balls._buffer = wire.sample.balls._buffer;
    if constexpr (requires { copy.obstacles; }) {
      copy.obstacles._buffer = wire.sample.obstacles._buffer;
    }
    if constexpr (requires { copy.teammates; }) {
      copy.teammates._buffer = wire.sample.teammates._buffer;
    }
    if constexpr (requires { copy.counters; }) copy.counters._buffer = wire.sample.counters._buffer;

    const auto result = from_wire<Message>(copy);

    if (result) {
      WireSample<Message> again;
      RC_ASSERT(!to_wire(*result, again));
    }
  });
}

TEST(WireProperty, DamagedRobotStatesAreRefusedOrValid) {
  damaged_samples_are_refused_or_valid<RobotState>();
}

TEST(WireProperty, DamagedSightingsAreRefusedOrValid) {
  damaged_samples_are_refused_or_valid<Sightings>();
}

TEST(WireProperty, DamagedWorldModelsAreRefusedOrValid) {
  damaged_samples_are_refused_or_valid<WorldModel>();
}

TEST(WireProperty, DamagedDiagnosticsAreRefusedOrValid) {
  damaged_samples_are_refused_or_valid<Diagnostics>();
}

}  // namespace
}  // namespace teamsight::bus
