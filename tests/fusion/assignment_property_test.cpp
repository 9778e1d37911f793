// tests/fusion/assignment_property_test.cpp: no assignment is cheaper, by trying them all.
#include <algorithm>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "fusion/assignment.hpp"
#include "tests/fusion/seeded_check.hpp"

namespace teamsight::fusion {
namespace {

double cost_of(const CostMatrix& cost, const Assignment& assignment, double price) {
  double sum = 0.0;
  for (Eigen::Index row = 0; row < cost.rows(); ++row) {
    const int column = assignment[static_cast<std::size_t>(row)];
    sum += column == kUnassigned ? price : cost(row, column);
  }
  return sum;
}

/// The cheapest total over all permutations of the columns, extended by one "alone" per row.
double cheapest_by_trying(const CostMatrix& cost, double price) {
  const auto rows = static_cast<int>(cost.rows());
  const auto columns = static_cast<int>(cost.cols());
  // With more than max(rows, columns) places nothing new comes up: alone is worth `price` anywhere.
  std::vector<int> order(static_cast<std::size_t>(std::max(rows, columns)));
  std::iota(order.begin(), order.end(), 0);
  double best = kForbidden;
  do {
    double sum = 0.0;
    for (int row = 0; row < rows; ++row) {
      const int column = order[static_cast<std::size_t>(row)];
      sum += column < columns ? std::min(price, cost(row, column)) : price;
    }
    best = std::min(best, sum);
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

CostMatrix any_matrix() {
  const int rows = *rc::gen::inRange(1, 8);
  const int columns = *rc::gen::inRange(0, 8);
  CostMatrix cost(rows, columns);
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      // Small whole numbers make ties, and sums that compare exactly.
      const int value = *rc::gen::inRange(-10, 16);
      cost(row, column) = value > 10 ? kForbidden : value;
    }
  }
  return cost;
}

bool is_one_to_one(const CostMatrix& cost, const Assignment& assignment) {
  std::vector<int> used;
  for (Eigen::Index row = 0; row < cost.rows(); ++row) {
    const int column = assignment[static_cast<std::size_t>(row)];
    if (column != kUnassigned) used.push_back(column);
  }
  std::sort(used.begin(), used.end());
  return std::adjacent_find(used.begin(), used.end()) == used.end();
}

TEST(AssignmentProperty, IsAsCheapAsTheBestOfAllPermutations) {
  test::check_property(20010801, 400, [] {
    const CostMatrix cost = any_matrix();
    const double price = *rc::gen::inRange(-3, 12);

    const Assignment assignment = assign(cost, price);

    RC_ASSERT(is_one_to_one(cost, assignment));
    RC_ASSERT(cost_of(cost, assignment, price) == cheapest_by_trying(cost, price));
  });
}

}  // namespace
}  // namespace teamsight::fusion
