// fusion/assignment.cpp: see fusion/assignment.hpp.
#include "fusion/assignment.hpp"

#include <algorithm>

#include "geometry/expect.hpp"

namespace teamsight::fusion {
namespace {

// One private column per row stands for "left alone", so that every row can always be placed.
constexpr int kMaxColumns = kMaxAssignmentColumns + kMaxAssignmentRows;

/// State of the solver: a partial assignment with potentials under which no reduced cost is
/// negative and every assigned pair's is zero.
class Solver {
 public:
  Solver(const CostMatrix& cost, double price)
      : cost_(cost),
        price_(price),
        columns_(static_cast<int>(cost.cols() + cost.rows())) {
    row_of_.fill(kUnassigned);
  }

  void add_row(int row) {
    search_from(row);
    raise_potentials();
    for (int column = reached_; column != kUnassigned;) {
      const int from = previous_[at(column)];
      row_of_[at(column)] = from == kUnassigned ? row : row_of_[at(from)];
      column = from;
    }
  }

  [[nodiscard]] Assignment result() const {
    Assignment assignment;
    assignment.fill(kUnassigned);
    for (int column = 0; column < cost_.cols(); ++column) {
      if (row_of_[at(column)] != kUnassigned) assignment[at(row_of_[at(column)])] = column;
    }
    return assignment;
  }

 private:
  static std::size_t at(int index) { return static_cast<std::size_t>(index); }

  [[nodiscard]] double cost(int row, int column) const {
    if (column < cost_.cols()) return cost_(row, column);
    if (column - cost_.cols() == row) return price_;
    return kForbidden;
  }

  // Costs may be negative, Dijkstra's edges may not: a new row starts at its cheapest column.
  [[nodiscard]] double smallest_reduced_cost(int row) const {
    double smallest = kForbidden;
    for (int column = 0; column < columns_; ++column) {
      smallest = std::min(smallest, cost(row, column) - column_potential_[at(column)]);
    }
    return smallest;
  }

  void relax(int row, double distance, int from) {
    for (int column = 0; column < columns_; ++column) {
      if (done_[at(column)]) continue;
      const double reduced =
          cost(row, column) - row_potential_[at(row)] - column_potential_[at(column)];
      if (distance + reduced < distance_[at(column)]) {
        distance_[at(column)] = distance + reduced;
        previous_[at(column)] = from;
      }
    }
  }

  [[nodiscard]] int nearest() const {
    int best = kUnassigned;
    for (int column = 0; column < columns_; ++column) {
      if (done_[at(column)] || distance_[at(column)] == kForbidden) continue;
      if (best == kUnassigned || distance_[at(column)] < distance_[at(best)]) best = column;
    }
    return best;
  }

  /// Dijkstra over the reduced costs, until a free column is reached.
  void search_from(int row) {
    distance_.fill(kForbidden);
    previous_.fill(kUnassigned);
    done_.fill(false);
    start_ = row;
    row_potential_[at(row)] = smallest_reduced_cost(row);
    relax(row, 0.0, kUnassigned);
    reached_ = nearest();
    while (row_of_[at(reached_)] != kUnassigned) {
      done_[at(reached_)] = true;
      relax(row_of_[at(reached_)], distance_[at(reached_)], reached_);
      reached_ = nearest();
    }
  }

  void raise_potentials() {
    const double length = distance_[at(reached_)];
    row_potential_[at(start_)] += length;
    for (int column = 0; column < columns_; ++column) {
      if (!done_[at(column)]) continue;
      const double slack = length - distance_[at(column)];
      column_potential_[at(column)] -= slack;
      row_potential_[at(row_of_[at(column)])] += slack;
    }
  }

  const CostMatrix& cost_;
  double price_;
  int columns_;
  int start_{0};
  int reached_{kUnassigned};
  std::array<int, kMaxColumns> row_of_{};
  std::array<int, kMaxColumns> previous_{};
  std::array<double, kMaxColumns> distance_{};
  std::array<double, kMaxColumns> column_potential_{};
  std::array<double, kMaxAssignmentRows> row_potential_{};
  std::array<bool, kMaxColumns> done_{};
};

}  // namespace

Assignment assign(const CostMatrix& cost, double price) {
  TEAMSIGHT_EXPECT(cost.rows() <= kMaxAssignmentRows && cost.cols() <= kMaxAssignmentColumns);
  Solver solver(cost, price);
  for (int row = 0; row < cost.rows(); ++row) solver.add_row(row);
  return solver.result();
}

}  // namespace teamsight::fusion
