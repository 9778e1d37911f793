// vision/calibration/view_search.hpp: where each calibration view may have been taken.
#pragma once

#include <span>
#include <vector>

#include "vision/calibration/bundle.hpp"
#include "vision/camera_model.hpp"
#include "vision/line_map.hpp"
#include "vision/line_points.hpp"
#include "vision/posture_fit.hpp"
#include "vision/posture_search.hpp"

namespace teamsight::vision {

/// Searches the field for the postures of calibration views. Buffers are the only state.
class ViewSearch {
 public:
  explicit ViewSearch(const LineMap& map);

  /// @return candidates, best first; none if too few pixels show floor within reach
  [[nodiscard]] std::vector<PostureFit> search(const CameraModel& model,
                                               std::span<const Pixel> pixels,
                                               const BundleRules& rules);

 private:
  bool look(const CameraModel& model, std::span<const Pixel> pixels, const BundleRules& rules);

  const LineMap* map_;
  PostureFitter fitter_;
  PostureSearch search_;
  std::vector<LinePoint> points_;
};

}  // namespace teamsight::vision
