// vision/localisation/wide_fit.hpp: a frame's fit from a start that may lie outside the fit's
// reach.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "vision/line_map.hpp"
#include "vision/line_points.hpp"
#include "vision/localisation/hypothesis.hpp"
#include "vision/posture_fit.hpp"

namespace teamsight::vision {

/// Fits a frame's points from where a hypothesis stands. A fit reaches some 0.25 m; where the
/// hypothesis is less certain than that and its fit leaves points unexplained or contradicts what
/// was expected, votes of some of the points are counted all over the hypothesis' ellipsoid, the
/// fit is tried from the best places as well, then with the head leaning to all sides, and the
/// answer that votes, hypothesis and the head's lean together make most probable is taken. Answers
/// that are hardly less probable widen its covariance.
///
/// Buffers are the only state.
class WideFitter {
 public:
  WideFitter();

  /// @param tilt         of the head, as it is expected
  /// @param correlation  see FitStart
  /// @pre points is not empty
  [[nodiscard]] PostureFit fit(const LineMap& map,
                               std::span<const LinePoint> points,
                               const Hypothesis& hypothesis,
                               const HeadTilt& tilt,
                               double correlation);

 private:
  static constexpr std::size_t kTried = 4;  // places from which the fit is tried again

  /// A place with the logarithm of its probability, but for a constant.
  struct Place {
    Pose<Field, Robot> X_FR;
    double log_weight{-1e9};
  };

  /// Where a fit of the sample ended.
  struct Ending {
    PostureFit fit;
    double log_weight{0.0};
  };

  void take_sample(std::span<const LinePoint> points);
  [[nodiscard]] double votes_at(const LineMap& map, const Pose<Field, Robot>& X_FR) const;
  /// Sets `places_`, the best first.
  void look_around(const LineMap& map, const Hypothesis& hypothesis);
  void try_from(const LineMap& map, const FitStart& start, const Hypothesis& hypothesis);
  /// The fit from where the hypothesis stands with the head leaning to all sides.
  void try_leaning(const LineMap& map, const FitStart& start, const Hypothesis& hypothesis);
  [[nodiscard]] const Ending& best() const;

  PostureFitter fitter_;
  std::vector<LinePoint> sample_;
  std::array<Place, kTried> places_;
  std::vector<Ending> endings_;
};

}  // namespace teamsight::vision
