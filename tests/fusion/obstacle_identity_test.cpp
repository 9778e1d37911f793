// tests/fusion/obstacle_identity_test.cpp: which obstacle a track is, and what it keeps its id
// through.
#include "fusion/obstacle_identity.hpp"

#include <gtest/gtest.h>

#include "fusion/fusion.hpp"
#include "tests/fusion/scenario.hpp"

namespace teamsight::fusion {
namespace {

using test::at_second;
using test::Eye;

Track track_at(std::uint32_t key, double x, double t) {
  Track track;
  track.book.key = key;
  track.book.born = track.book.last_hit = track.book.time = at_second(t);
  track.book.is_confirmed = true;
  track.book.proven = 6.0;
  track.state.mean << x, 0.0, 0.0, 0.0;
  track.state.cov = Eigen::Vector4d(0.01, 0.01, 0.1, 0.1).asDiagonal();
  return track;
}

/// One obstacle is lost at 1 s, another found a second later.
struct LossAndFind {
  explicit LossAndFind(const Track& lost_one) {
    TrackList tracks;
    tracks.push_back(lost_one);
    recognise({}, tracks, 1.1);
  }

  /// @return the key of the found one, after this
  std::uint32_t find(const Track& found, double t = 2.0) {
    TrackList tracks;
    tracks.push_back(found);
    recognise(tracks, {}, t);
    doubt = tracks[0].book.doubt;
    return tracks[0].book.key;
  }

  void recognise(TrackList&& tracks, const TrackList& before, double t) {
    recognise(tracks, before, t);
  }

  void recognise(TrackList& tracks, const TrackList& before, double t) {
    fusion::recognise(tracks, known_obstacles(before), lost, at_second(t), Parameters{});
  }

  KnownObstacles lost;
  double doubt{0.0};
};

TEST(ObstacleIdentity, WhatIsFoundWhereTheLostOneMayBeKeepsItsId) {
  LossAndFind game(track_at(7, 0.0, 1.0));
  Track found = track_at(8, 0.8, 2.0);
  found.book.doubt = 5.0;
  EXPECT_EQ(game.find(found), 7U);
  EXPECT_EQ(game.doubt, 0.0);       // several had vouched for it
  EXPECT_EQ(game.find(found), 8U);  // it is lost no more
}

TEST(ObstacleIdentity, WhatOnlyOneRobotVouchedForIsFoundAgainAsDoubtfulAsANewcomer) {
  Track lost = track_at(7, 0.0, 1.0);
  lost.book.proven = 1.0;
  LossAndFind game(lost);
  Track found = track_at(8, 0.8, 2.0);
  found.book.doubt = 5.0;
  EXPECT_EQ(game.find(found), 7U);
  EXPECT_EQ(game.doubt, 5.0);
}

TEST(ObstacleIdentity, AnotherOneHasAnIdOfItsOwn) {
  EXPECT_EQ(LossAndFind(track_at(7, 0.0, 1.0)).find(track_at(8, 6.0, 2.0)), 8U);       // too far
  EXPECT_EQ(LossAndFind(track_at(7, 0.0, 1.0)).find(track_at(8, 0.8, 9.0), 9.0), 8U);  // forgotten
  // Both were seen at once.
  EXPECT_EQ(LossAndFind(track_at(7, 0.0, 1.0)).find(track_at(8, 0.8, 0.5)), 8U);
  Track never_believed = track_at(7, 0.0, 1.0);
  never_believed.book.proven = 0.0;
  EXPECT_EQ(LossAndFind(never_believed).find(track_at(8, 0.8, 2.0)), 8U);
}

TEST(ObstacleIdentity, OfTwoLostOnesTheLikelierIsFound) {
  LossAndFind game(track_at(7, 0.0, 1.0));
  TrackList other;
  other.push_back(track_at(9, 1.5, 1.0));
  game.recognise({}, other, 1.1);
  EXPECT_EQ(game.find(track_at(8, 1.3, 2.0)), 9U);
}

TEST(ObstacleIdentity, ADoubleThatWasDroppedWasNotLost) {
  TrackList before;
  before.push_back(track_at(7, 0.0, 1.0));
  before.push_back(track_at(8, 0.1, 1.0));
  TrackList after;
  after.push_back(before[0]);
  KnownObstacles lost;
  recognise(after, known_obstacles(before), lost, at_second(1.0), Parameters{});
  EXPECT_TRUE(lost.empty());
}

/// Two robots that watch one place, and what they publish.
class Watchers {
 public:
  /// Until then, every 40 ms.
  void watch(double until, const std::vector<Point<Field>>& obstacles) {
    for (; t_ < until; t_ += 0.04) {
      for (std::size_t i = 0; i < eyes_.size(); ++i) {
        eyes_[i].look(stands_[i], at_second(t_));
        for (const Point<Field>& p_FO : obstacles) eyes_[i].see_obstacle(p_FO);
        fusion_.insert(eyes_[i].frame(), at_second(t_));
      }
    }
  }

  [[nodiscard]] std::vector<WorldObstacle> obstacles() const {
    return fusion_.world_at(at_second(t_)).obstacles;
  }

 private:
  Fusion fusion_{Parameters{}, test::plain_field()};
  std::array<Eye, 2> eyes_{Eye(1, 11), Eye(2, 12)};
  std::array<Pose<Field, Robot>, 2> stands_{Pose<Field, Robot>(-2.0, 0.0, 0.0),
                                            Pose<Field, Robot>(-2.0, 2.0, 0.0)};
  double t_{0.0};
};

TEST(ObstacleIdentity, OneThatHidesForTwoSecondsComesBackUnderItsId) {
  Watchers watchers;
  watchers.watch(2.0, {{0.0, 0.0}});
  const auto before = watchers.obstacles();
  ASSERT_EQ(before.size(), 1U);
  watchers.watch(4.2, {});
  EXPECT_TRUE(watchers.obstacles().empty());
  watchers.watch(5.0, {{0.5, 0.3}});
  const auto after = watchers.obstacles();
  ASSERT_EQ(after.size(), 1U);
  EXPECT_EQ(after[0].track, before[0].track);
}

// A robot's width beside the teammate, which stands where it says to a few centimetres.
TEST(ObstacleIdentity, OneThatTouchesATeammateFromTheFirstIsKnown) {
  Watchers watchers;
  watchers.watch(2.0, {{-2.0 + 0.53, 0.0}});
  const auto obstacles = watchers.obstacles();
  ASSERT_EQ(obstacles.size(), 1U);
  EXPECT_NEAR(obstacles[0].p_FO.x, -1.47, 0.1);
  EXPECT_EQ(obstacles[0].supporters, robot_bit(1) | robot_bit(2));
}

}  // namespace
}  // namespace teamsight::fusion
