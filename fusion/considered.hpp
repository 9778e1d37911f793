// fusion/considered.hpp: a filter's state that knows how it correlates with the robots' errors.
#pragma once

#include <Eigen/Core>
#include <Eigen/LU>

#include "fusion/team_errors.hpp"

namespace teamsight::fusion {

/// Mean and covariance of a track, and its covariance with everybody's errors: Schmidt's "consider"
/// states [Schmidt66]. Without them a robot that is aside by the same amount in every frame would
/// count as many witnesses as it sends frames.
template <int N>
struct Considered {
  using Vector = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, N, N>;
  using Cross = Eigen::Matrix<double, N, kAllErrors>;

  Vector mean{Vector::Zero()};
  Matrix cov{Matrix::Identity()};
  Cross cross{Cross::Zero()};  ///< E[(error of mean) (error of estimated errors)']

  /// Goes forward in time.
  void predict(const Matrix& transition, const Vector& moved, const Matrix& disturbance) {
    mean = moved;
    const Matrix next = transition * cov * transition.transpose() + disturbance;
    cov = 0.5 * (next + next.transpose());
    cross = (transition * cross).eval();
  }

  /// A robot's errors were carried on, see TeamErrors::report.
  void follow(ErrorPlace place, const ErrorMatrix& keep) {
    if (place == kNoPlace) return;
    auto with = cross.template middleCols<kErrorSize>(kErrorSize * place);
    with = (with * keep.transpose()).eval();
  }

  /// The errors were learned of: what correlates with them moves along.
  void learn(const TeamErrors::Lesson& lesson) {
    // Lazy products: so narrow that preparing a large one would take longer than the product.
    const Eigen::Matrix<double, N, 2> with = cross.lazyProduct(lesson.slope.transpose());
    const Eigen::Matrix<double, N, 2> gain = with * lesson.inverse;
    mean += gain * lesson.surprise;
    const Matrix next = cov - gain * with.transpose();
    cov = 0.5 * (next + next.transpose());
    cross -= gain.lazyProduct(lesson.cov_slope.transpose());
  }
};

/// One observation of M coordinates, linear in the track's state and in the observer's errors.
template <int N, int M>
struct ConsideredView {
  Eigen::Matrix<double, M, 1> gap;    ///< measured minus expected
  Eigen::Matrix<double, M, N> slope;  ///< with the track's state
  Eigen::Matrix<double, M, kErrorSize> slope_errors;
  Eigen::Matrix<double, M, M> cov;  ///< of its own noise
  ErrorPlace observer{kNoPlace};    ///< kNoPlace: their covariance is in `cov` already
};

/// Covariance of the gap.
template <int N, int M>
[[nodiscard]] Eigen::Matrix<double, M, M> gap_covariance(const Considered<N>& state,
                                                         const ConsideredView<N, M>& view,
                                                         const TeamErrors& errors) {
  Eigen::Matrix<double, M, M> total = view.slope * state.cov * view.slope.transpose() + view.cov;
  if (view.observer == kNoPlace) return total;
  const auto with = state.cross.template middleCols<kErrorSize>(kErrorSize * view.observer);
  const Eigen::Matrix<double, M, M> mixed = view.slope * with * view.slope_errors.transpose();
  total += mixed + mixed.transpose() +
           view.slope_errors * errors.cov(view.observer) * view.slope_errors.transpose();
  return total;
}

/// Takes the observation in; the robots' errors are considered and stay as they are.
///
/// @param gap_cov  see gap_covariance
template <int N, int M>
void take_view(Considered<N>& state,
               const ConsideredView<N, M>& view,
               const TeamErrors& errors,
               const Eigen::Matrix<double, M, M>& gap_cov) {
  Eigen::Matrix<double, N, M> with = state.cov * view.slope.transpose();
  Eigen::Matrix<double, M, kAllErrors> gap_with_errors = view.slope.lazyProduct(state.cross);
  if (view.observer != kNoPlace) {
    with += state.cross.template middleCols<kErrorSize>(kErrorSize * view.observer) *
            view.slope_errors.transpose();
    gap_with_errors += view.slope_errors.lazyProduct(errors.cov_with_all(view.observer));
  }
  const Eigen::Matrix<double, N, M> gain = with * gap_cov.inverse();
  state.mean += gain * view.gap;
  const Eigen::Matrix<double, N, N> next = state.cov - gain * with.transpose();
  state.cov = 0.5 * (next + next.transpose());
  state.cross -= gain.lazyProduct(gap_with_errors);
}

}  // namespace teamsight::fusion
