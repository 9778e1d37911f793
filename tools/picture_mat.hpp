// tools/picture_mat.hpp: pictures as OpenCV sees them; for .cpp files that draw.
#pragma once

#include <opencv2/core.hpp>

#include "tools/picture.hpp"

namespace teamsight::tools {

/// Shares the picture's bytes: draws into it, and lives no longer.
[[nodiscard]] inline cv::Mat mat_of(Picture& picture) {
  return {picture.height_px, picture.width_px, CV_8UC3, picture.bgr.data()};
}

/// A copy of an image of type CV_8UC3.
[[nodiscard]] inline Picture picture_of(const cv::Mat& mat) {
  const cv::Mat whole = mat.isContinuous() ? mat : mat.clone();
  const std::uint8_t* first = whole.ptr<std::uint8_t>();
  return {whole.cols, whole.rows, {first, first + whole.total() * whole.elemSize()}};
}

}  // namespace teamsight::tools
