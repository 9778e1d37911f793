// vision/posture_search.hpp: where on the carpet the line points fit, without any prior.
#pragma once

#include <cstddef>
#include <cstdint>
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

  /// @return distinct candidates, best first, at most 6; of a symmetric field one of each pair of
  ///         mirror images. Valid until the next call. Empty only if `points` is.
  ///
  /// @param tilt  of the head, as it may be in this frame
  [[nodiscard]] std::span<const PostureFit> search(const LineMap& map,
                                                   std::span<const LinePoint> points,
                                                   PostureFitter& fitter,
                                                   const HeadTilt& tilt = {});

 private:
  struct Place {
    float x{0.0F};
    float y{0.0F};
    float theta{0.0F};
    float votes{0.0F};
  };

  void make_votes(const LineMap& map);
  void rate(std::span<const LinePoint> points);
  [[nodiscard]] int votes_at(float x, float y) const;
  void merge(const PostureFit& fit, const Point<Field>& centre);

  bool half_;
  std::vector<Eigen::Vector2d> places_;  // of the grid, in F
  std::vector<Eigen::Vector2f> turned_;  // sub-sampled points, turned into F; in cells
  Eigen::Vector2f corner_;               // of the table of votes, in F; m
  int columns_{0};
  int rows_{0};
  std::vector<std::uint8_t> votes_;  // what a point in this cell says for a place: 0 to 255
  std::vector<LinePoint> sample_;
  std::vector<Place> rated_;
  std::vector<PostureFit> found_;
};

}  // namespace teamsight::vision
