// tests/fusion/trust_test.cpp: who is believed when robots contradict each other.
#include "fusion/trust.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "fusion/fusion.hpp"
#include "tests/fusion/scenario.hpp"

namespace teamsight::fusion {
namespace {

using test::at_second;

constexpr int kTeam = 5;
constexpr double kSure = 6.0;  // own log-odds of a robot that knows its half
const TrustParameters kParameters;

/// A team of which some stand in the wrong half; each pair shares a sighting in every look.
class Team {
 public:
  explicit Team(std::vector<RobotId> turned) : turned_(std::move(turned)) {}

  /// One look at everybody. A turned robot is as sure of itself as `liars_odds`.
  void look(double t, double liars_odds = kSure) {
    for (RobotId robot = 1; robot <= kTeam; ++robot) {
      book.begin_look(robot, at_second(t), kParameters);
      book.note(robot, at_second(t), is_turned(robot) ? liars_odds : kSure, 1.0);
      for (RobotId other = 1; other <= kTeam; ++other) {
        if (other == robot) continue;
        const double sign = is_turned(robot) == is_turned(other) ? 1.0 : -1.0;
        book.add(robot, {other, sign, sign}, kParameters);
      }
      book.judge(at_second(t), kParameters);
    }
  }

  void set_right() { turned_.clear(); }

  void expect_mirrored(const std::vector<RobotId>& robots, double t) const {
    for (RobotId robot = 1; robot <= kTeam; ++robot) {
      const bool is_named = std::find(robots.begin(), robots.end(), robot) != robots.end();
      EXPECT_EQ(book.verdict(robot, at_second(t), kParameters),
                is_named ? Quarantine::kMirrored : Quarantine::kNone)
          << "robot " << int{robot};
    }
  }

  TrustBook book;

 private:
  [[nodiscard]] bool is_turned(RobotId robot) const {
    return std::find(turned_.begin(), turned_.end(), robot) != turned_.end();
  }

  std::vector<RobotId> turned_;
};

TEST(Trust, NamesTheOneInTheWrongHalfHoweverConvincedItIs) {
  Team team({3});

  for (int i = 0; i < 10; ++i) team.look(0.2 * i, 1000.0);

  team.expect_mirrored({3}, 1.8);
  EXPECT_LT(team.book.half_log_odds(3, kParameters), -kParameters.most_own);
  EXPECT_GT(team.book.half_log_odds(1, kParameters), kParameters.most_own);
}

TEST(Trust, IsNotTurnedOverByTwoOfFiveThatAgree) {
  Team team({2, 4});

  for (int i = 0; i < 10; ++i) team.look(0.2 * i, 1000.0);

  team.expect_mirrored({2, 4}, 1.8);
}

TEST(Trust, NamesNobodyWhileAllAgree) {
  Team team({});

  for (int i = 0; i < 50; ++i) team.look(0.2 * i);

  team.expect_mirrored({}, 9.8);
  for (RobotId robot = 1; robot <= kTeam; ++robot) {
    EXPECT_GT(team.book.trust(robot, at_second(9.8), kParameters), 0.9);
  }
}

TEST(Trust, NamesNeitherOfTwoThatContradictEachOther) {
  TrustBook book;
  for (int i = 0; i < 50; ++i) {
    const HostTime now = at_second(0.2 * i);
    for (const RobotId robot : {RobotId{1}, RobotId{2}}) {
      const RobotId other = robot == 1 ? 2 : 1;
      book.begin_look(robot, now, kParameters);
      book.note(robot, now, kSure, 1.0);
      book.add(robot, {other, -1.0, -1.0}, kParameters);
      book.judge(now, kParameters);
    }
  }

  EXPECT_EQ(book.verdict(1, at_second(9.8), kParameters), Quarantine::kNone);
  EXPECT_EQ(book.verdict(2, at_second(9.8), kParameters), Quarantine::kNone);
}

TEST(Trust, TakesBackWhoTurnedRoundAtOnce) {
  Team team({3});
  for (int i = 0; i < 10; ++i) team.look(0.2 * i);

  team.set_right();
  team.book.turn_over(3);
  for (int i = 10; i < 15; ++i) team.look(0.2 * i);

  team.expect_mirrored({}, 2.8);
}

/// Everybody looks once; robot 3's pairs get this evidence, the others agree.
void look_at_third(TrustBook& book, double t, const std::vector<PairEvidence>& of_third) {
  const HostTime now = at_second(t);
  for (RobotId robot = 1; robot <= kTeam; ++robot) {
    book.begin_look(robot, now, kParameters);
    book.note(robot, now, kSure, 1.0);
    if (robot == 3) {
      for (const PairEvidence& pair : of_third) book.add(3, pair, kParameters);
      continue;
    }
    for (RobotId other = robot + 1; other <= kTeam; ++other) {
      if (other != 3) book.add(robot, {other, 1.0, 1.0}, kParameters);
    }
  }
  book.judge(now, kParameters);
}

TEST(Trust, NamesTheOneThatTwoContradictHoweverLittleTheSecondSees) {
  TrustBook one;
  TrustBook two;
  for (int i = 0; i < 10; ++i) {
    look_at_third(one, 0.2 * i, {{1, -1.5, 0.0}});
    look_at_third(two, 0.2 * i, {{1, -1.5, 0.0}, {2, -0.4, 0.0}});
  }

  EXPECT_EQ(one.verdict(3, at_second(1.8), kParameters), Quarantine::kNone);
  EXPECT_EQ(two.verdict(3, at_second(1.8), kParameters), Quarantine::kKidnapped);
  EXPECT_EQ(two.verdict(1, at_second(1.8), kParameters), Quarantine::kNone);
}

TEST(Trust, KeepsACarriedOneAsideUntilOthersAgreeWithIt) {
  TrustBook book;
  for (int i = 0; i < 10; ++i) look_at_third(book, 0.2 * i, {{1, -1.5, 0.0}, {2, -1.5, 0.0}});
  for (int i = 10; i < 200; ++i) look_at_third(book, 0.2 * i, {});
  EXPECT_EQ(book.verdict(3, at_second(39.8), kParameters), Quarantine::kKidnapped);

  for (int i = 200; i < 215; ++i) look_at_third(book, 0.2 * i, {{1, 1.0, 0.0}, {2, 1.0, 0.0}});

  EXPECT_EQ(book.verdict(3, at_second(42.8), kParameters), Quarantine::kNone);
}

TEST(Trust, BelievesACarriedOneAgainOnceItsPostureJumped) {
  TrustBook book;
  for (int i = 0; i < 10; ++i) look_at_third(book, 0.2 * i, {{1, -1.5, 0.0}, {2, -1.5, 0.0}});

  book.forget(3);
  look_at_third(book, 2.0, {});

  EXPECT_EQ(book.verdict(3, at_second(2.0), kParameters), Quarantine::kNone);
}

TEST(Trust, CallsWhoFitsNeitherPlaceNorMirrorImageCarriedAway) {
  TrustBook book;
  const double here = -1.5;
  const double there = -0.5;
  for (int i = 0; i < 20; ++i) {
    look_at_third(book, 0.2 * i, {{1, here, here - there}, {2, here, here - there}});
  }
  EXPECT_LT(book.half_log_odds(3, kParameters), 0.0);

  EXPECT_EQ(book.verdict(3, at_second(3.8), kParameters), Quarantine::kKidnapped);
}

TEST(Trust, DoesNotBelieveWhoSaysThatItStandsBeyondTheCarpet) {
  const FieldModel field = test::plain_field();
  const auto verdict_at = [&](double beyond_carpet) {
    Fusion fusion(Parameters{}, field);
    test::Eye eye(1, 11);
    const double x = field.centre.x + 0.5 * field.length + field.surround + beyond_carpet;
    eye.look({x, 0.0, 3.0}, at_second(0.0));
    EXPECT_EQ(fusion.insert(eye.frame(), at_second(0.01)), Intake::kAccepted);
    return fusion.world_at(at_second(0.01)).teammates.at(0).quarantine;
  };

  EXPECT_EQ(verdict_at(0.0), Quarantine::kNone);
  EXPECT_EQ(verdict_at(2.0), Quarantine::kKidnapped);
}

TEST(Trust, TrustsWhoIsSeenAsideLess) {
  TrustBook book;
  for (int i = 0; i < 20; ++i) book.note(2, at_second(0.2 * i), kSure, i < 10 ? 1.0 : 100.0);

  EXPECT_NEAR(book.trust(2, at_second(3.8), kParameters), 0.5, 0.01);
  EXPECT_EQ(book.verdict(2, at_second(3.8), kParameters), Quarantine::kNone);
}

TEST(Trust, HoldsWhoStandsAsideUnlessItIsWorse) {
  TrustBook book;
  book.set_aside(2, at_second(1.0));
  book.banish(3, at_second(1.0));
  book.set_aside(3, at_second(1.0));

  EXPECT_EQ(book.verdict(2, at_second(1.5), kParameters), Quarantine::kBiased);
  EXPECT_EQ(book.trust(2, at_second(1.5), kParameters), 0.0);
  EXPECT_EQ(book.verdict(2, at_second(2.0), kParameters), Quarantine::kNone);
  EXPECT_EQ(book.verdict(3, at_second(1.5), kParameters), Quarantine::kKidnapped);
}

TEST(Trust, BanishesWhoIsFoundElsewhereInTwoLooksInARow) {
  TrustBook book;
  book.note_elsewhere(2, at_second(0.0), 9.0, kParameters);
  book.note_elsewhere(3, at_second(0.0), 9.0, kParameters);
  book.note_elsewhere(3, at_second(0.2), 1.0, kParameters);
  book.note_elsewhere(3, at_second(0.4), 9.0, kParameters);
  EXPECT_EQ(book.verdict(2, at_second(0.2), kParameters), Quarantine::kNone);
  book.note_elsewhere(2, at_second(0.2), 9.0, kParameters);

  EXPECT_EQ(book.verdict(2, at_second(0.4), kParameters), Quarantine::kKidnapped);
  EXPECT_EQ(book.verdict(3, at_second(0.4), kParameters), Quarantine::kNone);
}

/// A ball that robots 1 and 2 have seen, each ten times in `until` seconds.
TrackBook seen_by_two(double until, const TrackParameters& parameters) {
  TrackBook book = first_page(7, {1, at_second(0.0), 0.9}, parameters);
  for (int i = 0; i < 10; ++i) {
    for (const RobotId robot : {RobotId{1}, RobotId{2}}) {
      write_hit(book, {robot, at_second(0.1 * until * (i + 1)), 0.9}, 1.0, parameters);
    }
  }
  return book;
}

TEST(TakeBack, LeavesWhatTheOthersSawAtTheSameTime) {
  const TrackParameters parameters = default_ball_parameters();
  TrackBook book = seen_by_two(1.0, parameters);

  take_back(book, 2, parameters);

  EXPECT_NEAR(log_odds_of(book), parameters.most_vote, 1e-9);
}

TEST(TakeBack, LeavesNothingOfATrackThatTheRobotLedAwayFromWhatTheOthersSaw) {
  const TrackParameters parameters = default_ball_parameters();
  TrackBook book = seen_by_two(1.0, parameters);
  for (int i = 1; i <= 10; ++i) {
    write_hit(book, {2, at_second(1.0 + 0.04 * i), 0.9}, 1.0, parameters);
  }

  take_back(book, 2, parameters);
  const double once = log_odds_of(book);
  take_back(book, 2, parameters);

  EXPECT_LE(once, 0.0);
  EXPECT_EQ(book.proven, 0.0);
  EXPECT_EQ(log_odds_of(book), once);
}

}  // namespace
}  // namespace teamsight::fusion
