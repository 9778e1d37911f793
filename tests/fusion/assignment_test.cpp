// tests/fusion/assignment_test.cpp: the assignment by hand, and what is special about it.
#include "fusion/assignment.hpp"

#include <gtest/gtest.h>

namespace teamsight::fusion {
namespace {

CostMatrix matrix(Eigen::Index rows, Eigen::Index columns, std::initializer_list<double> values) {
  CostMatrix cost(rows, columns);
  const double* value = values.begin();
  for (Eigen::Index row = 0; row < rows; ++row) {
    for (Eigen::Index column = 0; column < columns; ++column) cost(row, column) = *value++;
  }
  return cost;
}

TEST(Assignment, TakesTheCheapestPairsTogetherNotOneByOne) {
  // Row 0's own best is column 0, but then row 1 would pay 9.
  const auto columns = assign(matrix(2, 2, {1.0, 2.0, 2.0, 9.0}), 100.0);

  EXPECT_EQ(columns[0], 1);
  EXPECT_EQ(columns[1], 0);
}

TEST(Assignment, LeavesARowAloneRatherThanPayMoreThanThePrice) {
  const auto columns = assign(matrix(1, 1, {5.0}), 4.0);

  EXPECT_EQ(columns[0], kUnassigned);
}

TEST(Assignment, NeverMakesAForbiddenPair) {
  const auto columns = assign(matrix(2, 2, {kForbidden, 1.0, kForbidden, 2.0}), 100.0);

  EXPECT_EQ(columns[0], 1);
  EXPECT_EQ(columns[1], kUnassigned);
}

TEST(Assignment, AcceptsNegativeCosts) {
  const auto columns = assign(matrix(2, 3, {-5.0, -6.0, 0.0, -1.0, -7.0, 3.0}), 0.0);

  EXPECT_EQ(columns[0], 0);
  EXPECT_EQ(columns[1], 1);
}

TEST(Assignment, OfNothingIsNothing) {
  EXPECT_EQ(assign(CostMatrix(0, 0), 1.0)[0], kUnassigned);
  EXPECT_EQ(assign(CostMatrix(0, 5), 1.0)[0], kUnassigned);
  EXPECT_EQ(assign(CostMatrix(3, 0), 1.0)[2], kUnassigned);
}

TEST(Assignment, FillsTheLargestMatrix) {
  CostMatrix cost(kMaxAssignmentRows, kMaxAssignmentColumns);
  for (int row = 0; row < kMaxAssignmentRows; ++row) {
    for (int column = 0; column < kMaxAssignmentColumns; ++column) {
      cost(row, column) = column == (row * 5) % kMaxAssignmentColumns ? 0.0 : 1.0;
    }
  }

  const auto columns = assign(cost, 50.0);

  for (int row = 0; row < kMaxAssignmentRows; ++row) {
    EXPECT_EQ(columns[static_cast<std::size_t>(row)], (row * 5) % kMaxAssignmentColumns);
  }
}

}  // namespace
}  // namespace teamsight::fusion
