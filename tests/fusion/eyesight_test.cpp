// tests/fusion/eyesight_test.cpp: what a robot's silence is worth.
#include "fusion/eyesight.hpp"

#include <gtest/gtest.h>

#include "fusion/fusion.hpp"
#include "fusion/track_book.hpp"
#include "tests/fusion/scenario.hpp"

namespace teamsight::fusion {
namespace {

using test::at_second;
using test::Eye;
using test::plain_field;

const Parameters kParameters;

double probability(const Eyesight& eyes, double distance) {
  return eyes.probability(distance, kParameters.obstacle, kParameters.eyesight);
}

TEST(Eyesight, IsAsGivenUntilSomethingIsKnown) {
  EXPECT_NEAR(probability(Eyesight{}, 2.5), 0.25, 1e-12);
  EXPECT_EQ(probability(Eyesight{}, 5.5), 0.0);
  EXPECT_EQ(probability(Eyesight{}, 100.0), 0.0);
}

TEST(Eyesight, LearnsHowOftenARobotReportsByDistance) {
  Eyesight eyes;
  for (int i = 0; i < 2000; ++i) {
    eyes.note(2.5, i % 10 != 0);
    eyes.note(5.5, i % 4 == 0);
  }

  EXPECT_NEAR(probability(eyes, 2.5), 0.9, 0.02);
  EXPECT_NEAR(probability(eyes, 5.5), 0.25, 0.02);
  EXPECT_NEAR(probability(eyes, 3.5), 0.15, 1e-12);
}

TEST(Eyesight, ForgetsWhatWasLongAgo) {
  Eyesight eyes;
  eyes.turn_to(at_second(0.0), kParameters.eyesight);
  for (int i = 0; i < 2000; ++i) eyes.note(2.5, true);
  eyes.turn_to(at_second(3600.0), kParameters.eyesight);

  EXPECT_NEAR(probability(eyes, 2.5), 0.25, 1e-6);
}

TEST(Eyesight, TakesFramesInQuickSuccessionForOneLook) {
  Eyesight eyes;
  eyes.turn_to(at_second(1.0), kParameters.eyesight);

  EXPECT_NEAR(eyes.news_of(at_second(1.02), kParameters.eyesight), 0.2, 1e-6);
  EXPECT_EQ(eyes.news_of(at_second(2.0), kParameters.eyesight), 1.0);
  EXPECT_EQ(eyes.news_of(at_second(0.5), kParameters.eyesight), 0.0);
}

TEST(Eyesight, SeesNothingBehindAKnownBodyThatTheFrameDoesNotShow) {
  const Glance glance{1, at_second(0.0), Duration{0}, {}};
  const TeamErrors errors;
  const CandidateList nothing;
  Sight sight;
  sight.shadows.push_back(shadow_of({1.5, 0.0}, 0.25, {0.0, 0.0}));
  const Scene scene{glance, errors, nothing, sight};

  EXPECT_EQ(shown_probability({3.0, 0.0}, scene, kParameters.obstacle), 0.0);
  EXPECT_GT(shown_probability({1.5, 0.0}, scene, kParameters.obstacle), 0.3) << "it hides itself";
  EXPECT_GT(shown_probability({0.0, 3.0}, scene, kParameters.obstacle), 0.1);
}

/// Two robots watch an opponent; from a moment on only the one that is near it goes on to look.
class Watched : public ::testing::Test {
 protected:
  /// @param is_seeing  whether the near robot reports what it should while the opponent is there
  /// @return for how long the opponent is held for half probable after it has gone; s
  double listed_for(bool is_seeing) {
    constexpr int kGone = 100;
    constexpr int kEnd = 175;
    Parameters parameters;
    parameters.obstacle.least_existence = 0.5;
    Fusion fusion(parameters, plain_field());
    for (int i = 0; i < kEnd; ++i) {
      const HostTime now = at_second(kFrame * i);
      look(fusion, near_, {0.0, 0.0, 0.0}, now, i < kGone && is_seeing);
      look(fusion, far_, {7.0, 0.0, 3.14}, now, i < kGone);
      if (i > kGone && fusion.world_at(now).obstacles.empty()) return kFrame * (i - kGone);
    }
    return 1e9;
  }

 private:
  static constexpr double kFrame = 0.04;  // s

  static void look(
      Fusion& fusion, Eye& eye, const Pose<Field, Robot>& X_FR, HostTime now, bool is_shown) {
    eye.look(X_FR, now);
    if (is_shown) eye.see_obstacle({4.5, 0.0});
    fusion.insert(eye.frame(), now);
  }

  Eye near_{1, 11};
  Eye far_{2, 22};
};

TEST_F(Watched, GoesSoonerIfTheRobotThatMissesItHasReportedWhatIsThere) {
  const double by_good_eyes = listed_for(true);
  const double by_bad_eyes = listed_for(false);

  EXPECT_LT(by_good_eyes, 0.5);
  EXPECT_LT(by_good_eyes, 0.7 * by_bad_eyes);
}

}  // namespace
}  // namespace teamsight::fusion
