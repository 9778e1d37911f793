// tests/fusion/sighted_test.cpp: what sightings of team mates teach of the robots' own errors.
#include "fusion/sighted.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/fusion/scenario.hpp"

namespace teamsight::fusion {
namespace {

using test::at_second;
using test::Eye;

/// Mean, over two robots that look at each other for five seconds, of the share by which they are
/// thought to see too far away. Their looks err by a tenth of the distance, to either side.
double scale_learned(std::uint64_t seed) {
  constexpr double kApart = 5.0;  // m
  const test::EyeNoise noise{0.005, 0.1 * kApart, 0.03, 0.01};
  const std::array<Pose<Field, Robot>, 2> stands{Pose<Field, Robot>(-0.5 * kApart, 0.0, 0.0),
                                                 Pose<Field, Robot>(0.5 * kApart, 0.0, 3.0)};
  const Setting setting{Parameters{}, test::plain_field()};
  test::Random random(seed);
  State state;
  std::array<Eye, 2> eyes{Eye(1, 11, noise), Eye(2, 12, noise)};
  for (double t = 0.0; t < 5.0; t += 0.033) {
    for (const std::size_t i : {0U, 1U}) {
      eyes[i].look(stands[i], at_second(t + 0.01 * static_cast<double>(i)), &random);
      eyes[i].see_obstacle(stands[1 - i].origin(), &random);
      advance(state, eyes[i].frame(), setting);
    }
  }
  return 0.5 * (state.errors.mean(0)(3) + state.errors.mean(1)(3));
}

TEST(Sighted, LooksThatErrToEitherSideTeachNoScale) {
  constexpr int kSeeds = 40;
  double sum = 0.0;
  double squares = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const double scale = scale_learned(seed);
    sum += scale;
    squares += scale * scale;
  }
  const double mean = sum / kSeeds;
  const double error = std::sqrt((squares / kSeeds - mean * mean) / kSeeds);

  EXPECT_LT(std::abs(mean), 3.0 * error) << "mean " << mean << ", standard error " << error;
}

}  // namespace
}  // namespace teamsight::fusion
