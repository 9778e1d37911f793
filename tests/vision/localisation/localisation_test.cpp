// tests/vision/localisation/localisation_test.cpp: what the localisation does with good and bad
// input.
#include "vision/localisation/localisation.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/vision/localisation/fields.hpp"
#include "tests/vision/localisation/ride.hpp"

namespace teamsight::vision {
namespace {

using std::chrono::milliseconds;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

locate_score::DriveParameters standing() {
  locate_score::DriveParameters parameters;
  parameters.standing = true;
  return parameters;
}

// Rides some frames and says the last.
Located ride_on(Ride& ride, int frames) {
  Located located;
  for (int i = 0; i < frames; ++i) located = ride.frame();
  return located;
}

std::vector<LinePoint> one_straight_line() {
  std::vector<LinePoint> points(60);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].p_R = {1.0, -1.0 + 0.03 * static_cast<double>(i)};
    points[i].cov_R = 1e-4 * Eigen::Matrix2d::Identity();
  }
  return points;
}

TEST(Localisation, StaysAmbiguousOnASymmetricFieldUntilSomethingTellsTheHalf) {
  Ride ride(league_field(), {}, standing(), 3);

  const Located unknown = ride_on(ride, 10);
  ride.localiser().point(ride.state(), {ride.drive().now(), ride.truth().theta(), 0.3});
  const Located told = ride_on(ride, 8);

  EXPECT_EQ(unknown.posture.status, PostureStatus::kAmbiguous);
  EXPECT_LT(ride.miss(unknown, true), 0.05);
  EXPECT_EQ(told.posture.status, PostureStatus::kOk);
  EXPECT_LT(ride.miss(told, false), 0.05);
}

TEST(Localisation, TurnsOverWhenTheCompassContradictsForFiveFrames) {
  Ride ride(league_field(), {}, standing(), 4);
  ride.place_at_truth();
  ride_on(ride, 5);
  for (int i = 0; i < 10; ++i) {
    ride.localiser().point(
        ride.state(),
        {ride.drive().now() + i * std::chrono::seconds(1), ride.truth().theta() + M_PI, 0.3});
  }

  const Located located = ride_on(ride, 10);

  EXPECT_EQ(ride.state().counts.flips, 1U);
  EXPECT_GT(ride.miss(located, false), 1.0);
  EXPECT_LT(ride.miss(located, true), 0.05);
}

TEST(Localisation, NoticesThatItWasCarriedAwayAndFindsItselfAgain) {
  Ride ride(league_field(), {}, {}, 5);
  ride.place_at_truth();
  ride_on(ride, 30);
  ride.drive().kidnap({-5.0, 3.0, 2.0});

  int sure_but_wrong = 0;
  Located located;
  for (int i = 0; i < 30; ++i) {
    located = ride.frame();
    const bool is_wrong = ride.miss(located, false) > 0.5;
    if (is_wrong && located.posture.status == PostureStatus::kOk) ++sure_but_wrong;
  }

  EXPECT_LE(sure_but_wrong, 9);  // 0.3 s
  EXPECT_LT(ride.miss(located, true), 0.05);
}

TEST(Localisation, IsNotSureOfItsHalfWhereItWasCarriedBesideItsMirrorImage) {
  Ride ride(league_field(), {}, standing(), 18);
  ride.drive().kidnap({5.2, 3.9, 1.3});
  ride.place_at_truth();
  ride_on(ride, 30);
  // The mirror image of a place that is 1.1 m from the old one: too far to be pushed in a frame.
  ride.drive().kidnap(mirrored(Pose<Field, Robot>(5.3, 2.8, 2.0)));

  int sure_but_wrong = 0;
  Located located;
  for (int i = 0; i < 60; ++i) {
    located = ride.frame();
    const bool is_wrong = ride.miss(located, false) > 0.5;
    if (is_wrong && located.posture.status == PostureStatus::kOk) ++sure_but_wrong;
  }
  ride.localiser().point(ride.state(), {ride.drive().now(), ride.truth().theta(), 0.3});
  const Located told = ride_on(ride, 8);

  EXPECT_LE(sure_but_wrong, 9);  // 0.3 s
  EXPECT_LT(ride.miss(located, true), 0.05);
  EXPECT_EQ(located.posture.status, PostureStatus::kAmbiguous);
  EXPECT_EQ(told.posture.status, PostureStatus::kOk);
  EXPECT_LT(ride.miss(told, false), 0.05);
}

// Stands, is moved within a frame to where no search is needed to find it, and is seen for a
// second.
Located after_a_step_to(Ride& ride, const Pose<Field, Robot>& X_FR) {
  ride.drive().kidnap({-2.2, 1.8, -1.4});
  ride.place_at_truth();
  ride_on(ride, 30);
  ride.drive().kidnap(X_FR);
  return ride_on(ride, 30);
}

TEST(Localisation, IsNotSureOfItsHalfWhereAFitFollowedFurtherThanAPush) {
  Ride ride(league_field(), {}, standing(), 19);

  const Located located = after_a_step_to(ride, mirrored(Pose<Field, Robot>(-3.0, 1.2, -1.4)));

  EXPECT_EQ(ride.state().counts.jumps, 0U);
  EXPECT_LT(ride.miss(located, true), 0.05);
  EXPECT_EQ(located.posture.status, PostureStatus::kAmbiguous);
}

TEST(Localisation, KeepsItsHalfThroughAPush) {
  Ride ride(league_field(), {}, standing(), 19);

  const Located located = after_a_step_to(ride, {-2.45, 1.6, -1.3});

  EXPECT_LT(ride.miss(located, false), 0.05);
  EXPECT_EQ(located.posture.status, PostureStatus::kOk);
}

TEST(Localisation, NoticesSlippingWheels) {
  locate_score::DriveParameters drive;
  drive.slips_per_second = 0.5;
  Ride ride(league_field(), {}, drive, 6);
  ride.place_at_truth();

  double worst = 0.0;
  for (int i = 0; i < 200; ++i) worst = std::max(worst, ride.miss(ride.frame(), false));

  EXPECT_GT(ride.state().counts.slips, 0U);
  EXPECT_LT(worst, 0.1);
}

TEST(Localisation, IsAsUnsureAsASurpriseWasLargeUntilASearchConfirmsIt) {
  Ride ride(league_field(), {}, standing(), 7);
  ride.has_wheels = false;  // with wheels it would be a slip
  ride.place_at_truth();
  ride_on(ride, 20);
  const Located before = ride_on(ride, 1);
  const Pose<Field, Robot> aside(ride.truth().x() + 0.2, ride.truth().y(), ride.truth().theta());
  ride.drive().kidnap(aside);

  const Located surprised = ride_on(ride, 1);
  const Located settled = ride_on(ride, 10);

  EXPECT_LT(std::sqrt(before.posture.cov(0, 0)), 0.01);
  EXPECT_LT(ride.miss(settled, false), 0.02);
  EXPECT_EQ(surprised.posture.status, PostureStatus::kAmbiguous);
  EXPECT_NEAR(std::sqrt(surprised.posture.cov(0, 0)), 0.2, 0.02);
  EXPECT_EQ(settled.posture.status, PostureStatus::kOk);
  EXPECT_LT(std::sqrt(settled.posture.cov(0, 0)), 0.01);
}

TEST(Localisation, LearnsTheHeadsTiltAtRestFromManyFramesNotFromItsFirstLean) {
  Ride ride(league_field(), {}, standing(), 16);
  ride.has_wheels = false;  // nothing tells whether it accelerates
  ride.view.pitch = 0.01;
  ride.place_at_truth();

  ride_on(ride, 1);
  const double after_one_look = ride.state().tilt.y();
  ride_on(ride, 150);  // five seconds
  const double after_many = ride.state().tilt.y();

  EXPECT_LT(std::abs(after_one_look), 0.0025);
  EXPECT_NEAR(after_many, 0.01, 0.002);
}

TEST(Localisation, CoastsThroughASecondWithoutLines) {
  Ride ride(league_field(), {}, {}, 7);
  ride.place_at_truth();
  const Located before = ride_on(ride, 30);
  ride.spoil = [](std::vector<LinePoint>& points) {
    points.clear();
  };

  const Located blind = ride_on(ride, 30);

  EXPECT_NE(blind.posture.status, PostureStatus::kLost);
  EXPECT_GT(blind.posture.cov(0, 0), 4.0 * before.posture.cov(0, 0));
  EXPECT_LT(ride.miss(blind, false), 0.3);
}

TEST(Localisation, IsLostWithoutLinesAndRecovers) {
  Ride ride(league_field(), {.start_side = StartSide::kUnknown}, standing(), 8);
  ride.spoil = [](std::vector<LinePoint>& points) {
    points.clear();
  };
  const Located blind = ride_on(ride, 10);
  ride.spoil = nullptr;

  const Located seeing = ride_on(ride, 10);

  EXPECT_EQ(blind.posture.status, PostureStatus::kLost);
  EXPECT_LT(ride.miss(seeing, true), 0.05);
}

TEST(Localisation, SaysNeitherPlaceNorCertaintyOnOneStraightLine) {
  Ride ride(league_field(), {}, standing(), 9);
  ride.spoil = [](std::vector<LinePoint>& points) {
    points = one_straight_line();
  };

  const Located located = ride_on(ride, 30);

  EXPECT_NE(located.posture.status, PostureStatus::kOk);
}

TEST(Localisation, ShowsTheOpenDirectionAsALongEllipse) {
  Ride ride(league_field(), {}, standing(), 10);
  ride.drive().kidnap({3.5, 5.0, 0.3});
  ride.has_wheels = false;
  ride.place_at_truth();
  ride_on(ride, 10);
  // Only what lies on the nearest side line is seen: the way along it is open.
  ride.spoil = [&](std::vector<LinePoint>& points) {
    std::erase_if(points, [&](const LinePoint& point) {
      const Point<Field> p_F = ride.truth() * point.p_R;
      return std::abs(std::abs(p_F.y) - 7.0) > 0.05 || std::abs(p_F.x) > 10.0;
    });
  };

  const Located located = ride_on(ride, 30);

  EXPECT_GT(ride.points().size(), 20U);
  EXPECT_GT(located.posture.cov(0, 0), 10.0 * located.posture.cov(1, 1));
}

TEST(Localisation, KnowsNothingOnAFieldOfOneLine) {
  FieldModel field;
  field.length = 9.0;
  field.width = 6.0;
  field.line_width = 0.1;
  field.lines.push_back({"only", {-4.5, 0.0}, {4.5, 0.0}, LineFamily::kOther});
  Ride ride(field, {}, standing(), 11);
  ride.view.range = 3.0;

  for (int i = 0; i < 20; ++i) {
    const Located located = ride.frame();
    EXPECT_NE(located.posture.status, PostureStatus::kOk);
  }
}

TEST(Localisation, CountsBadInputAndGoesOn) {
  Ride ride(league_field(), {}, {}, 12);
  ride.place_at_truth();
  ride_on(ride, 10);
  Localiser& localiser = ride.localiser();
  LocalisationState& state = ride.state();
  WheelReading wheels;
  wheels.stamp = ride.drive().now();
  wheels.v_R = {kNan, 0.0};
  localiser.roll(state, wheels);
  localiser.turn(state, {ride.drive().now(), kNan, 0.1});
  localiser.point(state, {ride.drive().now(), kNan, 0.1});
  localiser.hear_team(state, kNan);
  localiser.place(state, {kNan, 0.0, 0.0}, Eigen::Matrix3d::Identity(), ride.drive().now());
  std::vector<LinePoint> points = ride.points();
  points[3].p_R.x = kNan;
  localiser.see(state, {ride.drive().now() + milliseconds(5), points});

  const Located located = ride_on(ride, 10);

  EXPECT_EQ(state.counts.inputs_not_finite, 5U);
  EXPECT_EQ(state.counts.frames_not_finite, 1U);
  EXPECT_EQ(located.posture.status, PostureStatus::kOk);
  EXPECT_LT(ride.miss(located, false), 0.05);
}

TEST(Localisation, DropsFramesThatAreOlderThanItsMemory) {
  Ride ride(league_field(), {}, {}, 13);
  ride.place_at_truth();
  ride_on(ride, 20);
  const LocalisationState before = ride.state();

  const auto old = ride.drive().now() - std::chrono::seconds(5);
  ride.localiser().see(ride.state(), {old, ride.points()});

  EXPECT_EQ(ride.state().counts.frames_backwards, 1U);
  EXPECT_EQ(ride.state().belief.places[0].X_FR, before.belief.places[0].X_FR);
}

TEST(Localisation, BeginsAgainWhenTheCamerasClockDid) {
  Ride ride(league_field(), {}, standing(), 14);
  ride.place_at_truth();
  ride_on(ride, 20);
  LocalisationState& state = ride.state();
  Located located;
  for (int i = 0; i < 30; ++i) {
    const HostTime exposure{std::chrono::seconds(1) + i * milliseconds(33)};
    located = ride.localiser().see(state, {exposure, ride.points()});
  }

  EXPECT_GT(state.counts.frames_backwards, 5U);
  EXPECT_LT(ride.miss(located, false), 0.05);
}

TEST(Localisation, TakesALateFrameInAtItsOwnTime) {
  Ride ride(league_field(), {.shared = {.sigma_place = 1e-6}}, standing(), 15);
  ride.place_at_truth();
  ride_on(ride, 12);
  std::mt19937 random(1);
  const HostTime now = ride.drive().now();
  std::vector<std::vector<LinePoint>> frames;
  for (int i = 0; i < 3; ++i) {
    frames.push_back(locate_score::look_at_lines(league_field(), ride.truth(), {}, {}, random));
  }
  const auto see = [&](LocalisationState state, std::vector<int> order) {
    for (const int i : order) {
      ride.localiser().see(state, {now + (i + 1) * milliseconds(33), frames[std::size_t(i)]});
    }
    return state;
  };

  const LocalisationState in_order = see(ride.state(), {0, 1, 2});
  const LocalisationState late = see(ride.state(), {0, 2, 1});

  EXPECT_EQ(late.counts.frames_late, 1U);
  const Eigen::Vector3d gap =
      late.belief.places[0].X_FR.vector() - in_order.belief.places[0].X_FR.vector();
  EXPECT_LT(gap.norm(), 1e-3);
  EXPECT_EQ(late.belief.at, in_order.belief.at);
}

}  // namespace
}  // namespace teamsight::vision
