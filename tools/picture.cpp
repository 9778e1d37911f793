// tools/picture.cpp: frames of every format in colour; OpenCV does the work.
#include "tools/picture.hpp"

#include <algorithm>
#include <stdexcept>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "tools/picture_mat.hpp"

namespace teamsight::tools {

namespace {

cv::Mat colour_picture(const ImageFile& frame) {
  const int rows = static_cast<int>(frame.height_px);
  const int columns = static_cast<int>(frame.width_px);
  cv::Mat bytes(frame.bytes, true);
  cv::Mat picture;
  switch (frame.format) {
    case vision::PixelFormat::kBgr:
      return bytes.reshape(3, rows);
    case vision::PixelFormat::kUyvy:
      cv::cvtColor(bytes.reshape(2, rows), picture, cv::COLOR_YUV2BGR_UYVY);
      break;
    case vision::PixelFormat::kYuyv:
      cv::cvtColor(bytes.reshape(2, rows), picture, cv::COLOR_YUV2BGR_YUYV);
      break;
    case vision::PixelFormat::kGrey:
      cv::cvtColor(bytes.reshape(1, rows), picture, cv::COLOR_GRAY2BGR);
      break;
    case vision::PixelFormat::kNv12:
      cv::cvtColor(bytes.reshape(1, rows + rows / 2), picture, cv::COLOR_YUV2BGR_NV12);
      break;
    // OpenCV names a mosaic by its second row's second and third pixel.
    case vision::PixelFormat::kBayerRggb:
      cv::cvtColor(bytes.reshape(1, rows), picture, cv::COLOR_BayerBG2BGR);
      break;
    case vision::PixelFormat::kBayerBggr:
      cv::cvtColor(bytes.reshape(1, rows), picture, cv::COLOR_BayerRG2BGR);
      break;
    case vision::PixelFormat::kBayerGrbg:
      cv::cvtColor(bytes.reshape(1, rows), picture, cv::COLOR_BayerGB2BGR);
      break;
    case vision::PixelFormat::kBayerGbrg:
      cv::cvtColor(bytes.reshape(1, rows), picture, cv::COLOR_BayerGR2BGR);
      break;
  }
  CV_Assert(picture.cols == columns);
  return picture;
}

}  // namespace

Picture picture_of(const ImageFile& frame) {
  return picture_of(colour_picture(frame));
}

Picture beside(const Picture& left, const Picture& right) {
  Picture both;
  both.width_px = left.width_px + right.width_px;
  both.height_px = std::max(left.height_px, right.height_px);
  both.bgr.resize(std::size_t{3} * static_cast<std::size_t>(both.width_px) *
                  static_cast<std::size_t>(both.height_px));
  int from = 0;
  for (const Picture* one : {&left, &right}) {
    const auto row = std::ptrdiff_t{3} * one->width_px;
    for (std::ptrdiff_t v = 0; v < one->height_px; ++v) {
      std::copy_n(one->bgr.begin() + v * row,
                  row,
                  both.bgr.begin() + std::ptrdiff_t{3} * (v * both.width_px + from));
    }
    from += one->width_px;
  }
  return both;
}

void write_picture(const std::filesystem::path& path, const Picture& picture) {
  Picture copy = picture;
  if (!cv::imwrite(path.string(), mat_of(copy))) {
    throw std::runtime_error(path.string() + ": cannot be written");
  }
}

}  // namespace teamsight::tools
