// tests/vision/calibration/trait_training_test.cpp: a model learns what tells two kinds apart.
#include "vision/calibration/trait_training.hpp"

#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace teamsight::vision {
namespace {

using Sample = TraitSample<9>;

std::optional<TraitModel<9>> train_on(const std::vector<Sample>& samples) {
  return train<9>(samples, 0.5);
}

// Trait 3 tells what is wanted from the rest, the others are noise, 7 never changes.
std::vector<Sample> samples_of(std::uint32_t seed, int count) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 1.0);
  std::vector<Sample> samples;
  for (int i = 0; i < count; ++i) {
    Sample sample;
    for (double& trait : sample.traits) trait = noise(random);
    sample.is_wanted = i % 3 == 0;
    sample.traits[3] = 10.0 + 0.1 * noise(random) + (sample.is_wanted ? 0.4 : 0.0);
    sample.traits[7] = 5.0;
    samples.push_back(sample);
  }
  return samples;
}

TEST(TraitTraining, TellsTheKindsApartInNewSamples) {
  const auto model = train_on(samples_of(1, 300));

  ASSERT_TRUE(model);
  int right = 0;
  const auto unseen = samples_of(2, 300);
  for (const Sample& sample : unseen) {
    if ((probability(*model, sample.traits) >= 0.5) == sample.is_wanted) ++right;
  }
  EXPECT_GT(right, 285);  // four sigma apart: 97.7 % at best
}

TEST(TraitTraining, FindsThatAPriorOfTheCommonerKindIsAllThereIsWithoutTraits) {
  std::vector<Sample> samples(40);
  for (std::size_t i = 0; i < 10; ++i) samples[i].is_wanted = true;

  const auto model = train_on(samples);

  ASSERT_TRUE(model);
  EXPECT_NEAR(probability(*model, {}), 0.25, 1e-3);
}

TEST(TraitTraining, NeedsBothKinds) {
  const std::vector<Sample> wanted(5, Sample{{}, true});

  EXPECT_FALSE(train_on(wanted));
  EXPECT_FALSE(train_on({}));
}

}  // namespace
}  // namespace teamsight::vision
