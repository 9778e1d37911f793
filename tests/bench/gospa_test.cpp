// tests/bench/gospa_test.cpp: GOSPA in its parts, on sets of which the answer is known.
#include "bench/fuse_score/gospa.hpp"

#include <gtest/gtest.h>

namespace teamsight::score {
namespace {

using Points = std::vector<Eigen::Vector2d>;

TEST(Gospa, OfEqualSetsIsNothing) {
  const Points points = {{0.0, 0.0}, {3.0, 1.0}};

  const Gospa gospa = match_gospa(points, {true, true}, points).gospa;

  EXPECT_DOUBLE_EQ(gospa.squared(), 0.0);
  EXPECT_EQ(gospa.matched, 2);
}

TEST(Gospa, CountsHalfTheCutOffForWhatIsMissedAndForWhatIsFalse) {
  const Gospa gospa = match_gospa({{0.0, 0.0}}, {true}, {{5.0, 0.0}}).gospa;

  EXPECT_EQ(gospa.missed, 1);
  EXPECT_EQ(gospa.false_ones, 1);
  EXPECT_DOUBLE_EQ(gospa.squared(), 1.0);
}

TEST(Gospa, FindsTheMatchOfLeastTotalDistance) {
  // The nearest of the first is the only one that the second can have.
  const Points truths = {{0.0, 0.0}, {1.3, 0.0}};
  const Points estimates = {{0.6, 0.0}, {-0.7, 0.0}};

  const GospaMatch match = match_gospa(truths, {true, true}, estimates);

  EXPECT_EQ(match.truth_of, (std::vector<int>{1, 0}));
  EXPECT_NEAR(match.gospa.squared(), 0.49 + 0.49, 1e-12);
}

TEST(Gospa, CountsWhatNobodyCanKnowNeitherWay) {
  const Gospa missed = match_gospa({{0.0, 0.0}}, {false}, {}).gospa;
  const Gospa found = match_gospa({{0.0, 0.0}}, {false}, {{0.1, 0.0}}).gospa;

  EXPECT_DOUBLE_EQ(missed.squared(), 0.0);
  EXPECT_DOUBLE_EQ(found.squared(), 0.0);
}

}  // namespace
}  // namespace teamsight::score
