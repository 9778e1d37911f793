// fusion/assignment.hpp: who belongs to whom, at the least total cost.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include <Eigen/Core>

#include "geometry/identity.hpp"

namespace teamsight::fusion {

inline constexpr int kMaxAssignmentRows = 16;
inline constexpr int kMaxAssignmentColumns = std::max(24, int{kMaxRobotId});

/// The cost of a pair that must never be made.
inline constexpr double kForbidden = std::numeric_limits<double>::infinity();

/// Cost of each (row, column) pair; kForbidden or finite. On the stack.
using CostMatrix = Eigen::Matrix<double,
                                 Eigen::Dynamic,
                                 Eigen::Dynamic,
                                 Eigen::ColMajor,
                                 kMaxAssignmentRows,
                                 kMaxAssignmentColumns>;

/// For each row its column, or kUnassigned.
using Assignment = std::array<int, kMaxAssignmentRows>;
inline constexpr int kUnassigned = -1;

/// Gives each row at most one column and each column at most one row, so that the sum of the
/// costs of the pairs made, plus `price` for each row left alone, is smallest.
///
/// Shortest augmenting paths with potentials [Jonker87]; O(rows^2 (rows + columns)).
///
/// @param price  of leaving a row alone; finite. Pairs that cost more than this are never made.
/// @return the columns; entries beyond the rows are kUnassigned. Among equally cheap assignments
///         the same one is found each time.
[[nodiscard]] Assignment assign(const CostMatrix& cost, double price);

}  // namespace teamsight::fusion
