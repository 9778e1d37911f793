// tests/fusion/aside_test.cpp: fusion/aside.hpp.
#include "fusion/aside.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "tests/fusion/scenario.hpp"

namespace teamsight::fusion {
namespace {

using test::at_second;

const Parameters kParameters;
constexpr RobotId kTeam = 5;
constexpr int kFrames = 75;
constexpr double kPeriod = 0.04;  // s

/// That `observer` sees `watched` so far from where that one says it stands.
struct View {
  RobotId observer{kNobody};
  RobotId watched{kNobody};
  Eigen::Vector2d gap{Eigen::Vector2d::Zero()};
};

/// Every robot sees every other; each posture stands aside by its own offset, m.
std::vector<View> all_views(const std::array<Eigen::Vector2d, kTeam>& offsets) {
  std::vector<View> views;
  for (RobotId i = 1; i <= kTeam; ++i) {
    for (RobotId j = 1; j <= kTeam; ++j) {
      if (i != j) views.push_back({i, j, offsets[i - 1U] - offsets[j - 1U]});
    }
  }
  return views;
}

void play(AsideBook& book, const std::vector<View>& views, double from = 0.0) {
  for (int frame = 0; frame < kFrames; ++frame) {
    const HostTime now = at_second(from + kPeriod * frame);
    for (const View& view : views) {
      book.take({view.observer, view.watched, now, view.gap, 0.01 * Eigen::Matrix2d::Identity()},
                kParameters);
    }
    book.judge(now, kParameters.trust);
  }
}

std::vector<RobotId> aside_in(const AsideBook& book) {
  std::vector<RobotId> robots;
  for (RobotId robot = 1; robot <= kTeam; ++robot) {
    if (book.is_aside(robot)) robots.push_back(robot);
  }
  return robots;
}

std::array<Eigen::Vector2d, kTeam> nobody_aside() {
  std::array<Eigen::Vector2d, kTeam> offsets;
  offsets.fill(Eigen::Vector2d::Zero());
  return offsets;
}

TEST(AsideBook, FindsTheOneWhosePostureStandsAside) {
  auto offsets = nobody_aside();
  offsets[1] << 0.3, -0.4;
  AsideBook book;
  play(book, all_views(offsets));

  EXPECT_EQ(aside_in(book), std::vector<RobotId>{2});
}

TEST(AsideBook, FindsNobodyWhereAllErrAsTheySay) {
  auto offsets = nobody_aside();
  offsets[0] << 0.1, 0.0;
  offsets[1] << 0.0, -0.1;
  AsideBook book;
  play(book, all_views(offsets));

  EXPECT_TRUE(aside_in(book).empty());
}

TEST(AsideBook, SuspectsNobodyWhomOthersSeeAsideAndWhoSeesThemInPlace) {
  // Another body stands beside robot 2 and hides it from all others.
  auto views = all_views(nobody_aside());
  for (View& view : views) {
    if (view.watched == 2) view.gap << 0.5, 0.0;
  }
  AsideBook book;
  play(book, views);

  EXPECT_TRUE(aside_in(book).empty());
}

TEST(AsideBook, SuspectsNobodyForWhatOthersSeeAlone) {
  AsideBook book;
  play(book, {{1, 2, {0.5, 0.0}}, {3, 2, {0.5, 0.0}}, {4, 2, {0.5, 0.0}}, {5, 2, {0.5, 0.0}}});

  EXPECT_TRUE(aside_in(book).empty());
}

TEST(AsideBook, FindsNeitherOfTwoThatContradictEachOther) {
  AsideBook book;
  play(book, {{1, 2, {0.5, 0.0}}, {2, 1, {-0.5, 0.0}}});

  EXPECT_TRUE(aside_in(book).empty());
}

TEST(AsideBook, BelievesOneAgainThatNoLongerStandsAside) {
  auto offsets = nobody_aside();
  offsets[1] << 0.3, -0.4;
  AsideBook book;
  play(book, all_views(offsets));
  ASSERT_TRUE(book.is_aside(2));
  play(book, all_views(nobody_aside()), kPeriod * kFrames);

  EXPECT_TRUE(aside_in(book).empty());
}

TEST(AsideBook, KnowsNothingOfOneThatStartsAnew) {
  auto offsets = nobody_aside();
  offsets[1] << 0.3, -0.4;
  AsideBook book;
  play(book, all_views(offsets));
  book.forget(2);

  EXPECT_FALSE(book.is_aside(2));
}

}  // namespace
}  // namespace teamsight::fusion
