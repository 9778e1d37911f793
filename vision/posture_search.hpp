// vision/posture_search.hpp: where on the carpet the line points fit, without any prior.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "vision/line_map.hpp"
#include "vision/line_points.hpp"
#include "vision/posture_fit.hpp"

namespace teamsight::vision {

/// Searches the whole carpet: a 0.5 m by 10 degree grid is rated with some of the points, the best
/// places are refined and merged. Buffers are the only state.
class PostureSearch {
 public:
  /// @param half  search one half of the field only (the other looks the same)
  PostureSearch(const LineMap& map, bool half);

  /// @return distinct candidates, best first, at most 4; of a symmetric field one of each pair of
  ///         mirror images. Valid until the next call. Empty only if `points` is.
  [[nodiscard]] std::span<const PostureFit> search(const LineMap& map,
                                                   std::span<const LinePoint> points,
                                                   PostureFitter& fitter);

 private:
  struct Place {
    float x{0.0F};
    float y{0.0F};
    float theta{0.0F};
    float votes{0.0F};
  };

  void rate(const LineMap& map, std::span<const LinePoint> points);
  void merge(const PostureFit& fit, const Point<Field>& centre);

  bool half_;
  std::vector<Eigen::Vector2d> places_;  // of the grid, in F
  std::vector<Eigen::Vector2d> turned_;  // sub-sampled points, turned into F
  std::vector<LinePoint> sample_;
  std::vector<Place> rated_;
  std::vector<PostureFit> found_;
};

}  // namespace teamsight::vision
