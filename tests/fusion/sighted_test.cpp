// tests/fusion/sighted_test.cpp: what sightings of team mates teach of the robots' own errors.
#include "fusion/sighted.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "fusion/assignment.hpp"
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

/// What a robot at the origin sees 2 m ahead of it, at that width.
Candidate seen_at_width(double width) {
  Eye eye(1, 11, {0.005, 0.03, 0.001, 0.0001});
  eye.look({0.0, 0.0, 0.0}, at_second(0.0));
  eye.see_obstacle({2.0, 0.0});
  eye.frame().obstacles[0].width = width;
  const Sighted sighted =
      sighted_in(eye.frame(), TeamErrors{}, {Parameters{}, test::plain_field()});
  EXPECT_EQ(sighted.obstacles.size(), 1U);
  return sighted.obstacles[0];
}

TEST(Sighted, TheAxisOfWhatIsPartlyHiddenOrTwoSideBySideIsUnsureAside) {
  const Candidate whole = seen_at_width(0.45);
  const Candidate hidden = seen_at_width(0.15);
  const Candidate two = seen_at_width(0.85);

  for (const Candidate& seen : {whole, hidden, two}) {
    EXPECT_NEAR(seen.measurement.p_F.x(), 2.0, 1e-6);  // a robot's radius behind its foot
    EXPECT_NEAR(seen.measurement.p_F.y(), 0.0, 1e-6);
  }
  EXPECT_NEAR(std::sqrt(whole.cov_own(1, 1)), 0.03, 0.002);  // as it says
  // Of a hidden one the middle of what is seen lies 0.14 m aside, of two 0.21 m.
  EXPECT_NEAR(std::sqrt(hidden.cov_own(1, 1)), 0.14, 0.02);
  EXPECT_NEAR(std::sqrt(two.cov_own(1, 1)), 0.21, 0.02);
  EXPECT_GT(two.half_angle, whole.half_angle);  // it hides as much as it is wide
}

/// The index of what a robot sees so far from where another says that it stands: in `mate_of`, in
/// `beside`, or in neither.
MateSightings mates_when_seen_at(double distance, double sigma_position = 0.01) {
  const test::EyeNoise sure{0.005, 0.04, 0.01, 0.005};
  const Setting setting{Parameters{}, test::plain_field()};
  State state;
  Eye mate(2, 12, {0.005, 0.04, sigma_position, 0.005});
  Eye eye(1, 11, sure);
  for (const double t : {0.0, 0.1, 0.2}) {
    mate.look({2.0, 0.0, 0.0}, at_second(t));
    advance(state, mate.frame(), setting);
    eye.look({0.0, 0.0, 0.0}, at_second(t + 0.01));
    advance(state, eye.frame(), setting);
  }
  eye.look({0.0, 0.0, 0.0}, at_second(0.25));
  eye.see_obstacle({2.0, distance});
  const Sighted sighted = sighted_in(eye.frame(), state.errors, setting);
  return find_teammates(sighted.obstacles, state, eye.frame(), setting.parameters);
}

TEST(Sighted, WhatStandsBesideATeammateIsNotTheTeammate) {
  EXPECT_NE(mates_when_seen_at(0.1).mate_of[0], kUnassigned);
  EXPECT_EQ(mates_when_seen_at(0.1).beside[0], kUnassigned);
  // Nothing else can stand so near.
  EXPECT_NE(mates_when_seen_at(0.3).mate_of[0], kUnassigned);
  EXPECT_EQ(mates_when_seen_at(0.52).mate_of[0], kUnassigned);
  EXPECT_NE(mates_when_seen_at(0.52).beside[0], kUnassigned);
  EXPECT_EQ(mates_when_seen_at(0.8).mate_of[0], kUnassigned);
  EXPECT_EQ(mates_when_seen_at(0.8).beside[0], kUnassigned);
}

// It would never be told where it is otherwise.
TEST(Sighted, WhoDoesNotKnowWhereItStandsIsFoundAside) {
  EXPECT_NE(mates_when_seen_at(0.9, 0.5).mate_of[0], kUnassigned);
}

}  // namespace
}  // namespace teamsight::fusion
