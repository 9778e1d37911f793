// tests/fusion/posture_jitter_test.cpp: how much of a posture's error is new in each frame, and
// what becomes of a ball when it is all.
#include "fusion/posture_jitter.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "fusion/fusion.hpp"
#include "fusion/team_errors.hpp"
#include "tests/fusion/scenario.hpp"

namespace teamsight::fusion {
namespace {

using test::at_second;
using test::Eye;
using test::normal;
using test::Random;

constexpr double kFrame = 1.0 / 30.0;    // s
constexpr double kSigmaPlace = 0.03;     // m
constexpr double kSigmaHeading = 0.015;  // rad
const Eigen::Matrix3d kSaid =
    Eigen::Vector3d(
        kSigmaPlace * kSigmaPlace, kSigmaPlace* kSigmaPlace, kSigmaHeading* kSigmaHeading)
        .asDiagonal();

/// What of an error is left one frame later.
struct Lasting {
  double place{0.0};
  double heading{0.0};
};

/// A robot that drives in a circle at 2 m/s and says where it is.
class Robot30Hz {
 public:
  explicit Robot30Hz(const Lasting& lasting) : lasting_(lasting) {}

  void drive(PostureJitter& jitter, double seconds) {
    for (double end = time_ + seconds; time_ < end; time_ += kFrame) {
      step(error_.x(), lasting_.place, kSigmaPlace);
      step(error_.y(), lasting_.place, kSigmaPlace);
      step(error_.z(), lasting_.heading, kSigmaHeading);
      const double turned = time_ / 2.0;  // 4 m radius
      const Eigen::Vector3d truth(
          4.0 * std::cos(turned), 4.0 * std::sin(turned), turned + 0.5 * std::numbers::pi);
      const Eigen::Vector3d said = truth + error_;
      jitter.take({said.x(), said.y(), said.z()}, kSaid, at_second(time_), parameters_);
    }
  }

  /// The next frames come from elsewhere.
  void skip(double seconds) { time_ += seconds; }

 private:
  void step(double& error, double kept, double sigma) {
    error = kept * error + std::sqrt(1.0 - kept * kept) * normal(random_, sigma);
  }

  TeammateParameters parameters_;
  Lasting lasting_;
  Random random_{7};
  Eigen::Vector3d error_{Eigen::Vector3d::Zero()};
  double time_{0.0};
};

TEST(PostureJitter, IsNotKnownBeforeThreePostures) {
  PostureJitter jitter;
  Robot30Hz({}).drive(jitter, 1.5 * kFrame);

  EXPECT_EQ(jitter.shares()(0), 0.0);
  EXPECT_EQ(jitter.shares()(1), 0.0);
  EXPECT_EQ(jitter.lasting(kSaid), kSaid);
}

TEST(PostureJitter, IsAllOfAnErrorThatIsDrawnAnewInEachFrame) {
  PostureJitter jitter;
  Robot30Hz({}).drive(jitter, 20.0);

  EXPECT_GT(jitter.shares()(0), 0.75);
  EXPECT_GT(jitter.shares()(1), 0.75);
}

TEST(PostureJitter, IsNearlyNothingOfAnErrorThatLastsForASecond) {
  PostureJitter jitter;
  const double kept = std::exp(-kFrame);
  Robot30Hz({kept, kept}).drive(jitter, 20.0);

  EXPECT_LT(jitter.shares()(0), 0.05);
  EXPECT_LT(jitter.shares()(1), 0.10);
}

TEST(PostureJitter, IsToldApartForPlaceAndHeading) {
  PostureJitter jitter;
  Robot30Hz({std::exp(-kFrame), 0.0}).drive(jitter, 20.0);

  EXPECT_LT(jitter.shares()(0), 0.05);
  EXPECT_GT(jitter.shares()(1), 0.75);
}

TEST(PostureJitter, DoesNotCountWhatHappenedInAGapOrAnInterruption) {
  PostureJitter jitter;
  const double kept = std::exp(-kFrame);
  Robot30Hz robot({kept, kept});
  robot.drive(jitter, 5.0);
  const Eigen::Array2d before = jitter.shares();
  robot.skip(1.0);  // 2 m on, half a radian round
  robot.drive(jitter, 1.5 * kFrame);
  jitter.interrupt();
  robot.skip(0.15);
  robot.drive(jitter, 1.5 * kFrame);

  EXPECT_TRUE((jitter.shares() == before).all());
}

TEST(PostureJitter, PartsTheVarianceInTwo) {
  PostureJitter jitter;
  Robot30Hz({0.7, 0.9}).drive(jitter, 5.0);

  const Eigen::Matrix3d both = jitter.fresh(kSaid) + jitter.lasting(kSaid);

  EXPECT_GT(jitter.fresh(kSaid)(0, 0), 0.0);
  EXPECT_GT(jitter.lasting(kSaid)(0, 0), 0.0);
  EXPECT_LT((both - kSaid).norm(), 1e-12);
}

TEST(PostureJitter, OfARobotThatTakesAForgottenOnesPlaceIsNotKnown) {
  TeamErrors errors;
  Random random(3);
  PostureEstimate posture;
  posture.cov = kSaid;
  for (int frame = 0; frame < 60; ++frame) {
    for (int robot = 1; robot <= kMaxErrorRobots; ++robot) {
      posture.X_FR = {normal(random, kSigmaPlace), normal(random, kSigmaPlace), 0.0};
      errors.report(
          static_cast<RobotId>(robot), posture, at_second(kFrame * frame), {frame == 0, 0.0});
    }
  }
  ASSERT_GT(errors.fresh(0, posture)(0, 0), 0.0);

  const auto ninth = static_cast<RobotId>(kMaxErrorRobots + 1);
  errors.report(ninth, posture, at_second(60.0), {true, 0.0});

  ASSERT_NE(errors.place_of(ninth), kNoPlace);
  EXPECT_EQ(errors.fresh(errors.place_of(ninth), posture)(0, 0), 0.0);
}

/// Six robots stand around a ball that rolls in a circle, and see it and each other, each with an
/// error of its own in every frame.
class ShakingTeam {
 public:
  explicit ShakingTeam(std::uint64_t seed) : random_(seed) {}

  /// @return the ids of all balls that were listed first
  std::set<std::uint32_t> balls_listed(double seconds) {
    std::set<std::uint32_t> listed;
    for (double t = 0.0; t < seconds; t += kFrame / 6.0) {
      const auto who = static_cast<std::size_t>(turn_++ % 6);
      const double angle = std::numbers::pi / 8.0 * t + first_angle_;
      const Point<Field> ball{4.0 * std::cos(angle), 2.5 * std::sin(angle)};
      Eye& eye = eyes_.at(who);
      eye.look(kStands.at(who), at_second(t), &random_);
      eye.see_ball(ball, &random_);
      for (std::size_t other = 0; other < kStands.size(); ++other) {
        if (other != who) eye.see_obstacle(kStands.at(other).origin(), &random_);
      }
      fusion_.insert(eye.frame(), at_second(t));
      const WorldModel world = fusion_.world_at(at_second(t));
      // The first moments are those in which it is found out.
      if (t > 1.0 && !world.balls.empty()) listed.insert(world.balls.front().track);
    }
    return listed;
  }

 private:
  inline static const std::array<Pose<Field, Robot>, 6> kStands{Pose<Field, Robot>{-7.0, 0.0, 0.0},
                                                                Pose<Field, Robot>{-4.0, 4.0, -1.0},
                                                                Pose<Field, Robot>{-4.0, -4.0, 1.0},
                                                                Pose<Field, Robot>{3.0, 5.0, -2.0},
                                                                Pose<Field, Robot>{3.0, -5.0, 2.0},
                                                                Pose<Field, Robot>{7.0, 0.5, 3.0}};
  Fusion fusion_{Parameters{}, test::plain_field()};
  Random random_;
  double first_angle_{normal(random_, 3.0)};
  std::array<Eye, 6> eyes_{Eye{1, 11}, Eye{2, 22}, Eye{3, 33}, Eye{4, 44}, Eye{5, 55}, Eye{6, 66}};
  int turn_{0};
};

class ShakingTeams : public testing::TestWithParam<std::uint64_t> {};

TEST_P(ShakingTeams, SeeOneBall) {
  EXPECT_EQ(ShakingTeam(GetParam()).balls_listed(6.0).size(), 1U);
}

INSTANTIATE_TEST_SUITE_P(PostureJitter, ShakingTeams, testing::Range<std::uint64_t>(1, 9));

}  // namespace
}  // namespace teamsight::fusion
