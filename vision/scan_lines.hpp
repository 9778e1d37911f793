// vision/scan_lines.hpp: the paths along which a frame is looked at, worked out once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "vision/camera_model.hpp"
#include "vision/camera_parameters.hpp"
#include "vision/ray_table.hpp"

namespace teamsight::vision {

/// Where a frame is read for one sample: all that is needed of every sample of every frame, small,
/// for there are some hundred thousand.
struct SampleTap {
  std::uint32_t corner{0};  ///< index of the pixel left above; all four around it are in the image
  std::uint8_t right{0};    ///< how far between `corner` and its right neighbour; 1/256 px
  std::uint8_t below{0};    ///< the same downwards

  /// Index of the nearest pixel, in an image of that width in pixels.
  [[nodiscard]] std::size_t nearest(std::size_t width) const {
    return corner + (right >> 7U) + (below >> 7U) * width;
  }
};

/// One step of a scan line, `ScanRange::pitch` pixels from the last.
struct ScanSample {
  float u{0.0F};  ///< px
  float v{0.0F};  ///< px
  float x{0.0F};  ///< of the floor there, in R; m
  float y{0.0F};
  float radial_footprint{0.0F};      ///< metres of floor per pixel, away from the robot
  float tangential_footprint{0.0F};  ///< metres of floor per pixel, around the robot
};

/// Both of one sample.
struct ScanStep {
  SampleTap tap;
  ScanSample sample;
};

/// A part of the sample list.
struct ScanRange {
  std::size_t first{0};
  std::size_t count{0};
  double image_direction{0.0};  ///< of a radial line, counter-clockwise from image right; rad
  std::size_t pitch{1};         ///< px from one sample to the next
};

/// Radial lines, which find paint that runs around the robot, and circles, which find paint that
/// runs away from it. Only where the camera sees floor no farther than the pattern's reach and the
/// mask lets it.
///
/// A step is about a pixel of a picture that is 480 pixels high, whatever this one's height.
class ScanLines {
 public:
  ScanLines(const CameraParameters& parameters, const CameraModel& model, const RayTable& rays);

  /// Pixels to one of a picture that is 480 pixels high: what lengths in pixels that mean parts of
  /// the picture are multiplied by.
  [[nodiscard]] std::size_t scale() const { return scale_; }

  /// From the centre outwards, by growing image direction.
  [[nodiscard]] std::span<const ScanRange> radial() const { return radial_; }

  /// Arcs between masked sectors, from the inner circle outwards, each counter-clockwise.
  [[nodiscard]] std::span<const ScanRange> circular() const { return circular_; }

  [[nodiscard]] std::span<const ScanSample> samples(const ScanRange& range) const {
    return std::span(samples_).subspan(range.first, range.count);
  }

  /// Of each of the samples.
  [[nodiscard]] std::span<const SampleTap> taps(const ScanRange& range) const {
    return std::span(taps_).subspan(range.first, range.count);
  }

  /// About a pixel apart along the line, `pitch` of them for each sample from its own on; those of
  /// the last sample are all its own.
  [[nodiscard]] std::span<const SampleTap> close_taps(const ScanRange& range) const {
    const std::vector<SampleTap>& taps = scale_ == 1 ? taps_ : close_taps_;
    return std::span(taps).subspan(range.first * scale_, range.count * scale_);
  }

  /// Of each of the samples, the index of the nearest pixel.
  [[nodiscard]] std::span<const std::uint32_t> pixels(const ScanRange& range) const {
    return std::span(pixels_).subspan(range.first, range.count);
  }

  /// Samples of the longest line.
  [[nodiscard]] std::size_t longest() const { return longest_; }

  /// The length of the longest line; px.
  [[nodiscard]] std::size_t longest_px() const { return longest_ * scale_; }

 private:
  /// Appends the arcs of one circle; `step_at` gives nothing where the view is masked.
  void add_circle(int steps, const std::function<std::optional<ScanStep>(int)>& step_at);
  void add(const ScanStep& step);
  /// Of a line that is complete.
  void add_close_taps(std::span<const ScanSample> line);
  /// Ends the line that begins at `range.first` with the last sample; forgets it if too short.
  void close(std::vector<ScanRange>& ranges, ScanRange range);

  std::size_t scale_;
  std::size_t width_px_;
  std::vector<SampleTap> taps_;
  std::vector<SampleTap> close_taps_;  // none where samples are a pixel apart
  std::vector<std::uint32_t> pixels_;
  std::vector<ScanSample> samples_;  // of each tap
  std::vector<ScanRange> radial_;
  std::vector<ScanRange> circular_;
  std::size_t longest_{0};
};

/// Whether the mask hides this image direction.
[[nodiscard]] bool is_masked(const Mask& mask, double image_direction);

}  // namespace teamsight::vision
