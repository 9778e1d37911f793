// vision/line_finder.hpp: scan lines looked at coarsely, and closely where paint may be.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "vision/line_points.hpp"

namespace teamsight::vision {

/// A frame, and what its colours mean.
struct ColouredFrame {
  const PixelReader& pixels;
  const ColourClasses& colours;
};

/// A whole scan line as it was looked at.
struct SampledLine {
  std::span<const ScanSample> samples;
  std::span<const SampleTap> taps;          ///< about a pixel apart, `pitch` for each sample
  std::span<const std::uint8_t> luminance;  ///< of each sample, grey levels
  std::size_t pitch{1};                     ///< px from one sample to the next
};

/// Finds the line points of whole scan lines. Where the samples of a line are more than a pixel
/// apart, it reads every pixel only of stretches in which they rise as they do onto paint. Its
/// buffers are its only state.
class LineFinder {
 public:
  /// @param longest  of the lines, px
  LineFinder(std::size_t longest, const LineRules& rules);

  /// Appends the line points of one scan line.
  ///
  /// @param points grows up to kMaxLinePoints
  void find(const ColouredFrame& frame, const SampledLine& line, std::vector<LinePoint>& points);

 private:
  /// Some samples of a line, of which every pixel is to be read.
  struct Stretch {
    std::size_t first{0};
    std::size_t end{0};
  };

  [[nodiscard]] std::size_t paint_end(const SampledLine& line,
                                      std::size_t rise,
                                      std::size_t known) const;
  void look_closely(const ColouredFrame& frame,
                    const SampledLine& line,
                    const Stretch& stretch,
                    std::vector<LinePoint>& points);

  LineRules rules_;
  std::uint8_t rise_;                    // grey levels
  float widest_;                         // m of floor, of paint
  std::vector<std::uint8_t> luminance_;  // at each tap of a stretch
};

}  // namespace teamsight::vision
