// tests/fusion/fusion_property_test.cpp: what holds for every set of observations.
#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "fusion/fusion.hpp"
#include "geometry/uncertainty.hpp"
#include "tests/fusion/scenario.hpp"
#include "tests/fusion/seeded_check.hpp"

namespace teamsight::fusion {
namespace {

using test::at_second;
using test::Eye;
using test::Random;

double any_in(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

Point<Field> any_place(Random& random) {
  return {any_in(random, -4, 4), any_in(random, -4, 4)};
}

/// `frames` frames of each of three robots within `span` seconds: a ball, obstacles, false ones,
/// and now and then a robot without a posture.
std::vector<Observation> any_observations(std::uint64_t seed, int frames, double span) {
  Random random(seed);
  const Point<Field> ball = any_place(random);
  const Point<Field> opponent = any_place(random);
  std::vector<Observation> observations;
  for (RobotId robot = 1; robot <= 3; ++robot) {
    Eye eye(robot, 100U + robot);
    const Point<Field> stand = any_place(random);
    for (int i = 0; i < frames; ++i) {
      const double t = span * (i + any_in(random, 0.0, 0.9)) / frames;
      eye.look({stand.x, stand.y, any_in(random, -3, 3)}, at_second(t), &random);
      eye.see_ball(ball, &random);
      eye.see_obstacle(opponent, &random);
      if (any_in(random, 0, 1) < 0.3) eye.see_ball(any_place(random), &random);
      if (any_in(random, 0, 1) < 0.3) eye.see_obstacle(any_place(random), &random);
      if (any_in(random, 0, 1) < 0.1) eye.frame().posture.status = PostureStatus::kLost;
      observations.push_back(eye.frame());
    }
  }
  return observations;
}

Fusion make_fusion() {
  return Fusion(Parameters{}, test::plain_field());
}

WorldModel world_of_all(const std::vector<Observation>& observations, HostTime now) {
  Fusion fusion = make_fusion();
  for (const Observation& observation : observations) fusion.insert(observation, now);
  return fusion.world_at(now);
}

TEST(FusionProperty, IgnoresOrderOfArrivalAndDuplicatesToTheLastBit) {
  test::check_property(20010802, 15, [] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const auto observations = any_observations(seed, 8, 0.45);
    auto shuffled = observations;
    Random random(seed + 1);
    for (int i = 0; i < 10; ++i) {
      shuffled.push_back(observations[random() % observations.size()]);
    }
    std::shuffle(shuffled.begin(), shuffled.end(), random);

    const WorldModel straight = world_of_all(observations, at_second(0.46));

    RC_ASSERT(!straight.teammates.empty());
    RC_ASSERT(straight == world_of_all(shuffled, at_second(0.46)));
  });
}

struct Arrival {
  HostTime time;
  std::size_t index;
};

WorldModel world_after_arrivals(const std::vector<Observation>& observations,
                                Random& random,
                                HostTime end) {
  std::vector<Arrival> arrivals;
  for (std::size_t i = 0; i < observations.size(); ++i) {
    // Up to 0.4 s under way, and every third comes a second time.
    const HostTime sent = observations[i].exposure;
    arrivals.push_back({sent + from_seconds(any_in(random, 0.0, 0.4)), i});
    if (i % 3 == 0) arrivals.push_back({sent + from_seconds(any_in(random, 0.0, 0.4)), i});
  }
  std::sort(arrivals.begin(), arrivals.end(), [](const Arrival& a, const Arrival& b) {
    return a.time < b.time;
  });
  Fusion fusion = make_fusion();
  for (const Arrival& arrival : arrivals) {
    fusion.insert(observations[arrival.index], arrival.time);
  }
  return fusion.world_at(end);
}

TEST(FusionProperty, DelaysWithinTheLagChangeNothingOverSeconds) {
  test::check_property(20010803, 4, [] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    const auto observations = any_observations(seed, 40, 2.0);
    Random one(seed + 1);
    Random other(seed + 2);

    RC_ASSERT(world_after_arrivals(observations, one, at_second(2.5)) ==
              world_after_arrivals(observations, other, at_second(2.5)));
  });
}

TEST(FusionProperty, MirroringTheFieldMirrorsTheWorld) {
  test::check_property(20010804, 8, [] {
    const auto observations = any_observations(*rc::gen::arbitrary<std::uint64_t>(), 12, 0.45);
    auto turned = observations;
    const Eigen::Vector3d signs(-1.0, -1.0, 1.0);
    for (Observation& observation : turned) {
      observation.posture.X_FR = mirrored(observation.posture.X_FR);
      observation.posture.cov = signs.asDiagonal() * observation.posture.cov * signs.asDiagonal();
    }

    const WorldModel world = world_of_all(observations, at_second(0.46));
    const WorldModel other = world_of_all(turned, at_second(0.46));

    RC_ASSERT(world.balls.size() == other.balls.size());
    RC_ASSERT(world.obstacles.size() == other.obstacles.size());
    for (std::size_t i = 0; i < world.balls.size(); ++i) {
      RC_ASSERT((world.balls[i].p_FB.on_floor().vector() + other.balls[i].p_FB.on_floor().vector())
                    .norm() < 1e-6);
    }
    for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
      RC_ASSERT((world.obstacles[i].p_FO.vector() + other.obstacles[i].p_FO.vector()).norm() <
                1e-6);
    }
  });
}

TEST(FusionProperty, EveryCovarianceStaysACovarianceAndEveryProbabilityOne) {
  test::check_property(20010805, 8, [] {
    const auto observations = any_observations(*rc::gen::arbitrary<std::uint64_t>(), 12, 0.45);
    const double later = *rc::gen::inRange(0, 2000) / 1000.0;
    Fusion fusion = make_fusion();
    for (const auto& observation : observations) fusion.insert(observation, at_second(0.46));

    const WorldModel world = fusion.world_at(at_second(0.46 + later));

    for (const WorldBall& ball : world.balls) {
      RC_ASSERT(is_covariance(ball.cov_p) && is_covariance(ball.cov_v));
      RC_ASSERT(ball.existence >= 0.0 && ball.existence <= 1.0);
    }
    for (const WorldObstacle& obstacle : world.obstacles) {
      RC_ASSERT(is_covariance(obstacle.cov_p));
      RC_ASSERT(obstacle.existence >= 0.0 && obstacle.existence <= 1.0);
    }
    for (const WorldTeammate& mate : world.teammates) RC_ASSERT(is_covariance(mate.cov));
  });
}

}  // namespace
}  // namespace teamsight::fusion
