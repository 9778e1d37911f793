// agent/opencv_media.cpp: the media plugin: pictures and videos through OpenCV.
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "agent/media_plugin.hpp"
#include "bus/clock.hpp"

namespace teamsight::agent {
namespace {

using vision::PixelFormat;

constexpr int kTimeoutMs = 1000;  // so that ending the process never waits for a dead camera

int fourcc(PixelFormat format) {
  return format == PixelFormat::kUyvy ? cv::VideoWriter::fourcc('U', 'Y', 'V', 'Y')
                                      : cv::VideoWriter::fourcc('Y', 'U', 'Y', 'V');
}

bool is_packed_yuv(PixelFormat format) {
  return format == PixelFormat::kYuyv || format == PixelFormat::kUyvy;
}

void copy_pixels(const cv::Mat& image, Frame& out) {
  const std::size_t row = image.elemSize() * static_cast<std::size_t>(image.cols);
  out.bytes.resize(row * static_cast<std::size_t>(image.rows));
  for (int v = 0; v < image.rows; ++v) {
    std::copy_n(image.ptr(v), row, out.bytes.data() + static_cast<std::size_t>(v) * row);
  }
  out.width_px = static_cast<std::uint32_t>(image.cols);
  out.height_px = static_cast<std::uint32_t>(image.rows);
}

class VideoSource final : public FrameSource {
 public:
  explicit VideoSource(const MediaRequest& request) : request_(request) {
    if (!open()) {
      throw SourceError(request.what + ": cannot be opened as a video source");
    }
  }

  FrameResult next(Frame& out, HostTime /*deadline*/) noexcept override {
    try {
      return read(out);
    } catch (const std::exception&) {  // a driver that broke down is a camera that is gone
      return FrameResult::kGone;
    }
  }

  [[nodiscard]] bool is_live() const noexcept override {
    return request_.kind != MediaKind::kVideoFile;
  }

 private:
  bool open() {
    switch (request_.kind) {
      case MediaKind::kVideoFile:
        return capture_.open(request_.what, cv::CAP_FFMPEG);
      case MediaKind::kGstreamer:
        return capture_.open(request_.what, cv::CAP_GSTREAMER);
      case MediaKind::kDevice:
        return open_device();
    }
    return false;
  }

  bool open_device() {
    if (!capture_.open(request_.what, cv::CAP_V4L2)) {
      return false;
    }
    capture_.set(cv::CAP_PROP_READ_TIMEOUT_MSEC, kTimeoutMs);
    capture_.set(cv::CAP_PROP_FRAME_WIDTH, request_.width_px);
    capture_.set(cv::CAP_PROP_FRAME_HEIGHT, request_.height_px);
    if (is_packed_yuv(request_.format)) {
      capture_.set(cv::CAP_PROP_FOURCC, fourcc(request_.format));
      capture_.set(cv::CAP_PROP_CONVERT_RGB, 0);
    }
    return true;
  }

  FrameResult read(Frame& out) {
    if (!capture_.read(image_) || image_.empty()) {
      if (request_.kind != MediaKind::kVideoFile) {
        return FrameResult::kGone;
      }
      if (!request_.loop || !open() || !capture_.read(image_) || image_.empty()) {
        return FrameResult::kFinished;
      }
    }
    copy_pixels(image_, out);
    out.format = image_.type() == CV_8UC3   ? PixelFormat::kBgr
                 : image_.type() == CV_8UC1 ? PixelFormat::kGrey
                                            : request_.format;
    out.exposure = bus::host_now();
    out.sequence = ++sequence_;
    return FrameResult::kFrame;
  }

  MediaRequest request_;
  cv::VideoCapture capture_;
  cv::Mat image_;
  std::uint64_t sequence_{0};
};

class OpencvMedia final : public MediaPlugin {
 public:
  [[nodiscard]] Frame read_picture(const std::string& path) const override {
    const cv::Mat image = cv::imread(path, cv::IMREAD_COLOR);
    if (image.empty()) {
      throw SourceError(path + ": cannot be read, expected a PNG or JPEG picture");
    }
    Frame frame;
    copy_pixels(image, frame);
    frame.format = PixelFormat::kBgr;
    return frame;
  }

  [[nodiscard]] std::unique_ptr<FrameSource> open(const MediaRequest& request) const override {
    return std::make_unique<VideoSource>(request);
  }
};

}  // namespace
}  // namespace teamsight::agent

extern "C" __attribute__((visibility("default"))) const teamsight::agent::MediaPlugin*
teamsight_media_plugin() {
  static const teamsight::agent::OpencvMedia plugin;
  return &plugin;
}
