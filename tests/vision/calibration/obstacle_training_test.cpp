// tests/vision/calibration/obstacle_training_test.cpp: a model learns what tells two kinds apart.
#include "vision/calibration/obstacle_training.hpp"

#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace teamsight::vision {
namespace {

// Trait 3 tells robots from the rest, the others are noise, 7 never changes.
std::vector<ObstacleSample> samples_of(std::uint32_t seed, int count) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 1.0);
  std::vector<ObstacleSample> samples;
  for (int i = 0; i < count; ++i) {
    ObstacleSample sample;
    for (double& trait : sample.traits) trait = noise(random);
    sample.is_robot = i % 3 == 0;
    sample.traits[3] = 10.0 + 0.1 * noise(random) + (sample.is_robot ? 0.4 : 0.0);
    sample.traits[7] = 5.0;
    samples.push_back(sample);
  }
  return samples;
}

TEST(ObstacleTraining, TellsTheKindsApartInNewSamples) {
  const auto model = train_obstacle_model(samples_of(1, 300));

  ASSERT_TRUE(model);
  int right = 0;
  const auto unseen = samples_of(2, 300);
  for (const ObstacleSample& sample : unseen) {
    if ((probability(*model, sample.traits) >= 0.5) == sample.is_robot) ++right;
  }
  EXPECT_GT(right, 285);  // four sigma apart: 97.7 % at best
}

TEST(ObstacleTraining, FindsThatAPriorOfTheCommonerKindIsAllThereIsWithoutTraits) {
  std::vector<ObstacleSample> samples(40);
  for (std::size_t i = 0; i < 10; ++i) samples[i].is_robot = true;

  const auto model = train_obstacle_model(samples);

  ASSERT_TRUE(model);
  EXPECT_NEAR(probability(*model, {}), 0.25, 1e-3);
}

TEST(ObstacleTraining, NeedsBothKinds) {
  const std::vector<ObstacleSample> robots(5, ObstacleSample{{}, true});

  EXPECT_FALSE(train_obstacle_model(robots));
  EXPECT_FALSE(train_obstacle_model({}));
}

}  // namespace
}  // namespace teamsight::vision
