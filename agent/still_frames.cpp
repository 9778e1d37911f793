// agent/still_frames.cpp: see still_frames.hpp.
#include "agent/still_frames.hpp"

#include <fstream>
#include <utility>

#include "bus/clock.hpp"
#include "geometry/expect.hpp"

namespace teamsight::agent {
namespace {

class StillFrames final : public FrameSource {
 public:
  StillFrames(std::vector<Frame> frames, bool loop) : frames_(std::move(frames)), loop_(loop) {}

  FrameResult next(Frame& out, HostTime /*deadline*/) noexcept override {
    if (next_ == frames_.size() && !loop_) {
      return FrameResult::kFinished;
    }
    next_ = next_ == frames_.size() ? 0 : next_;
    out = frames_[next_++];  // keeps out's memory
    out.exposure = bus::host_now();
    out.sequence = ++sequence_;
    return FrameResult::kFrame;
  }

  [[nodiscard]] bool is_live() const noexcept override { return false; }

 private:
  std::vector<Frame> frames_;
  std::size_t next_{0};
  std::uint64_t sequence_{0};
  bool loop_;
};

}  // namespace

Frame read_raw_dump(const std::string& path, const PictureLayout& layout) {
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  if (!file) {
    throw SourceError(path + ": cannot be read, expected a raw picture");
  }
  const auto found = static_cast<std::size_t>(file.tellg());
  const std::size_t expected =
      vision::frame_bytes(layout.format, layout.width_px, layout.height_px);
  if (found != expected) {
    throw SourceError(path + ": found " + std::to_string(found) + " bytes, expected " +
                      std::to_string(expected) + " (" + std::to_string(layout.width_px) + "x" +
                      std::to_string(layout.height_px) + " as in the camera file)");
  }
  Frame frame{
      std::vector<std::uint8_t>(expected), layout.width_px, layout.height_px, layout.format};
  file.seekg(0);
  if (!file.read(reinterpret_cast<char*>(frame.bytes.data()),
                 static_cast<std::streamsize>(expected))) {
    throw SourceError(path + ": cannot be read to its end");
  }
  return frame;
}

std::unique_ptr<FrameSource> make_still_frames(std::vector<Frame> frames, bool loop) {
  TEAMSIGHT_EXPECT(!frames.empty());
  return std::make_unique<StillFrames>(std::move(frames), loop);
}

}  // namespace teamsight::agent
