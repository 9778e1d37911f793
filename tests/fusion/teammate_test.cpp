// tests/fusion/teammate_test.cpp: postures carried forward, jumps, restarts and two of one id.
#include "fusion/teammate.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "geometry/uncertainty.hpp"
#include "tests/fusion/scenario.hpp"

namespace teamsight::fusion {
namespace {

using test::at_second;

const TeammateParameters kParameters;
const Parameters kAll;

const Eigen::Matrix3d kSaidCov = Eigen::Vector3d(4e-4, 4e-4, 1e-4).asDiagonal();

PostureEstimate posture_at(double x, double y, double theta) {
  PostureEstimate posture;
  posture.status = PostureStatus::kOk;
  posture.X_FR = {x, y, theta};
  posture.cov = kSaidCov;
  return posture;
}

/// A second of postures at 30 Hz, moving evenly from (0, 0, theta).
PostureTrack moving(double vx, double omega, double theta) {
  PostureTrack track;
  for (int i = 0; i <= 30; ++i) {
    const double t = i / 30.0;
    take_posture(
        track, {posture_at(vx * t, 0.0, theta + omega * t), kSaidCov, at_second(t)}, kParameters);
  }
  return track;
}

TEST(PostureTrack, CarriesTheLastPostureForwardWithTheVelocityOfTheLastOnes) {
  const auto carried = carried_to(moving(2.0, 0.0, 0.0), at_second(1.1), kParameters);

  EXPECT_NEAR(carried.X_FR.x(), 2.2, 0.02);
  EXPECT_NEAR(carried.v_FR.x, 2.0, 0.1);
  EXPECT_TRUE(is_covariance(carried.cov));
}

TEST(PostureTrack, TurnsOnThroughHalfATurn) {
  const double theta = std::numbers::pi - 0.5;

  const auto carried = carried_to(moving(0.0, 1.0, theta), at_second(1.1), kParameters);

  EXPECT_NEAR(carried.X_FR.theta(), wrap_angle(theta + 1.1), 0.02);
}

TEST(PostureTrack, IsTheLastPostureAtItsOwnTime) {
  const PostureTrack track = moving(2.0, 0.5, 0.0);

  const auto carried = carried_to(track, at_second(1.0), kParameters);

  EXPECT_EQ(carried.X_FR, track.last.X_FR);
  EXPECT_EQ(carried.cov, track.last.cov);
}

TEST(PostureTrack, AJumpIsNoVelocity) {
  PostureTrack track = moving(0.0, 0.0, 0.0);

  take_posture(track, {posture_at(5.0, 3.0, 1.0), kSaidCov, at_second(1.03)}, kParameters);

  const auto carried = carried_to(track, at_second(1.03), kParameters);
  EXPECT_NEAR(carried.X_FR.x(), 5.0, 1e-12);
  EXPECT_DOUBLE_EQ(carried.v_FR.x, 0.0);
}

TEST(Teammate, ThatIsLostKeepsItsLastPostureAndSaysSo) {
  Teammate mate;
  take_frame(mate, {1, 7, 1}, {posture_at(1.0, 2.0, 0.0), kSaidCov, at_second(0.0)}, kAll);
  PostureEstimate lost;

  take_frame(mate, {1, 7, 1}, {lost, kSaidCov, at_second(0.1)}, kAll);

  EXPECT_EQ(mate.status, PostureStatus::kLost);
  EXPECT_EQ(mate.posture.last.X_FR.x(), 1.0);
  EXPECT_EQ(quarantine_of(mate, at_second(0.1), kParameters), Quarantine::kNoPosture);
}

TEST(Teammate, ThatWasRestartedIsNotADuplicate) {
  Teammate mate;
  take_frame(mate, {1, 7, 1}, {posture_at(1.0, 2.0, 0.0), kSaidCov, at_second(0.0)}, kAll);

  for (int i = 1; i < 5; ++i) {
    take_frame(mate, {1, 8, 1}, {posture_at(1.0, 2.0, 0.0), kSaidCov, at_second(0.1 * i)}, kAll);
  }

  EXPECT_EQ(quarantine_of(mate, at_second(0.5), kParameters), Quarantine::kNone);
}

TEST(Teammate, TwoProcessesThatSpeakInTurnAreADuplicateUntilOneStops) {
  Teammate mate;
  for (int i = 0; i < 6; ++i) {
    const auto boot = static_cast<std::uint32_t>(7 + i % 2);
    take_frame(mate,
               {1, boot, 1},
               {posture_at(1.0 * (i % 2), 2.0, 0.0), kSaidCov, at_second(0.1 * i)},
               kAll);
  }
  EXPECT_EQ(quarantine_of(mate, at_second(0.6), kParameters), Quarantine::kDuplicateId);

  take_frame(mate, {1, 8, 1}, {posture_at(1.0, 2.0, 0.0), kSaidCov, at_second(3.0)}, kAll);

  EXPECT_EQ(quarantine_of(mate, at_second(3.0), kParameters), Quarantine::kNone);
}

TEST(Teammate, AnAmbiguousPostureIsResolvedByItsOwnEvidenceOnly) {
  EXPECT_TRUE(is_resolved(PostureStatus::kOk, 0.0, kParameters));
  EXPECT_TRUE(is_resolved(PostureStatus::kAmbiguous, 3.5, kParameters));
  EXPECT_FALSE(is_resolved(PostureStatus::kAmbiguous, 0.0, kParameters));
  EXPECT_FALSE(is_resolved(PostureStatus::kAmbiguous, -3.5, kParameters));
  EXPECT_FALSE(is_resolved(PostureStatus::kLost, 9.0, kParameters));
}

}  // namespace
}  // namespace teamsight::fusion
