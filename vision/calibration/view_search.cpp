// vision/calibration/view_search.cpp: pixels to line points, line points to postures.
#include "vision/calibration/view_search.hpp"

namespace teamsight::vision {

namespace {

constexpr std::size_t kFewestPoints = 15;

}  // namespace

ViewSearch::ViewSearch(const LineMap& map)
    : map_(&map),
      search_(map, is_half_turn_symmetric(map.field())) {}

bool ViewSearch::look(const CameraModel& model,
                      std::span<const Pixel> pixels,
                      const BundleRules& rules) {
  points_.clear();
  for (const Pixel& pixel : pixels) {
    const auto floor = model.on_plane(pixel, 0.0);
    const auto per_px = model.floor_jacobian(pixel);
    if (!floor || !per_px || floor->vector().norm() > rules.max_distance) continue;
    LinePoint point{pixel.u, pixel.v, *floor, {}};
    // Not yet calibrated: a pixel may be off by more than its noise.
    const double sigma = 3.0 * rules.sigma_px;
    point.cov_R =
        sigma * sigma * *per_px * per_px->transpose() + 1e-6 * Eigen::Matrix2d::Identity();
    points_.push_back(point);
  }
  return points_.size() >= kFewestPoints;
}

std::vector<PostureFit> ViewSearch::search(const CameraModel& model,
                                           std::span<const Pixel> pixels,
                                           const BundleRules& rules) {
  if (!look(model, pixels, rules)) return {};
  const auto found = search_.search(*map_, points_, fitter_);
  return {found.begin(), found.end()};
}

}  // namespace teamsight::vision
