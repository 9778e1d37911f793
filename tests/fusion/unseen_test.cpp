// tests/fusion/unseen_test.cpp: where obstacles may stand unseen, and what is made of newcomers.
#include "fusion/unseen.hpp"

#include <array>

#include <gtest/gtest.h>

#include "fusion/fusion.hpp"
#include "tests/fusion/scenario.hpp"

namespace teamsight::fusion {
namespace {

using test::at_second;
using test::Eye;
using test::plain_field;

constexpr double kFrame = 0.04;  // s
const Eigen::Vector2d kBeside(2.0, 0.0);
const Eigen::Vector2d kFar(9.0, 5.0);

/// A robot in the middle of the field that shows what it is told to.
class Unseen : public ::testing::Test {
 protected:
  void watch_for(double seconds, const CandidateList& hiding = {}) {
    const Scene scene{glance_, errors_, hiding};
    for (double t = 0.0; t < seconds; t += kFrame) {
      glance_.exposure += from_seconds(kFrame);
      map_.wander_to(glance_.exposure, carpet_, parameters_.newcomer);
      map_.watch(scene, carpet_, parameters_.obstacle);
    }
  }

  [[nodiscard]] double share_at(const Eigen::Vector2d& p_F) const {
    return map_.share_at(p_F, carpet_);
  }

  Parameters parameters_;
  Carpet carpet_ = Carpet::of(plain_field(), parameters_.carpet_margin);
  Glance glance_{1, at_second(0.0), Duration{0}, {}};
  TeamErrors errors_;
  UnseenMap map_;
};

TEST_F(Unseen, ExpectsAsMuchEverywhereBeforeAnybodyLooked) {
  EXPECT_EQ(share_at(kBeside), 1.0);
  EXPECT_EQ(share_at(kFar), 1.0);
}

TEST_F(Unseen, ExpectsLittleWhereARobotHasLookedAndAsMuchAsBeforeElsewhere) {
  watch_for(2.0);

  EXPECT_LT(share_at(kBeside), 0.1);
  EXPECT_GT(share_at(kFar), 0.9);
}

TEST_F(Unseen, ExpectsMoreBehindSomebodyThanInTheOpen) {
  Candidate body;
  body.distance = 1.0;
  body.azimuth = 0.0;
  body.half_angle = 0.5;
  CandidateList hiding;
  hiding.push_back(body);

  watch_for(2.0, hiding);

  EXPECT_GT(share_at(kBeside), 3.0 * share_at(-kBeside));
}

TEST_F(Unseen, ForgetsWhatNobodyLooksAtAnyMore) {
  watch_for(2.0);
  const double watched = share_at(kBeside);

  map_.wander_to(glance_.exposure + std::chrono::seconds(3), carpet_, parameters_.newcomer);
  const double later = share_at(kBeside);
  map_.wander_to(glance_.exposure + std::chrono::hours(1), carpet_, parameters_.newcomer);

  EXPECT_GT(later, 3.0 * watched);
  EXPECT_EQ(share_at(kBeside), 1.0);
}

TEST_F(Unseen, DoubtsNothingWhereNobodyLookedAndMostWhereEverybodyDid) {
  EXPECT_EQ(doubt_of_newcomer(1.0, 0.3, parameters_), 0.0);
  EXPECT_GT(doubt_of_newcomer(1e-3, 0.3, parameters_), doubt_of_newcomer(1e-2, 0.3, parameters_));
  EXPECT_LE(doubt_of_newcomer(0.0, 0.0, parameters_), parameters_.newcomer.most_doubt);
}

/// Three robots around an empty place; from a moment on something is reported there.
class Newcomer : public ::testing::Test {
 protected:
  /// @param witnesses  how many of the robots report it
  /// @return how long after its first report it is in the world model; s
  double listed_after(int witnesses) {
    constexpr double kFrom = 3.0;
    Fusion fusion(Parameters{}, plain_field());
    for (double t = 0.0; t < kFrom + 10.0; t += kFrame / 3.0) {
      const auto who = static_cast<std::size_t>(turn_++ % 3);
      Eye& eye = eyes_.at(who);
      eye.look(stands_.at(who), at_second(t));
      // They see each other, so that nobody takes them for lost.
      for (std::size_t i = 0; i < stands_.size(); ++i) {
        if (i != who) eye.see_obstacle(stands_.at(i).origin());
      }
      if (t >= kFrom && static_cast<int>(who) < witnesses) eye.see_obstacle({0.0, 0.0});
      fusion.insert(eye.frame(), at_second(t));
      if (!fusion.world_at(at_second(t)).obstacles.empty()) return t - kFrom;
    }
    return 1e9;
  }

  std::array<Eye, 3> eyes_{Eye{1, 11}, Eye{2, 22}, Eye{3, 33}};
  std::array<Pose<Field, Robot>, 3> stands_{Pose<Field, Robot>{-2.0, 0.0, 0.0},
                                            Pose<Field, Robot>{1.0, 1.7, -2.1},
                                            Pose<Field, Robot>{1.0, -1.7, 2.1}};
  int turn_{0};
};

TEST_F(Newcomer, IsBelievedAtOnceIfTwoRobotsSeeIt) {
  EXPECT_LT(listed_after(2), 0.3);
}

TEST_F(Newcomer, IsNotBelievedForASecondIfOnlyOneOfThreeThatWatchTheSpotSeesIt) {
  EXPECT_GT(listed_after(1), 1.0);
}

}  // namespace
}  // namespace teamsight::fusion
