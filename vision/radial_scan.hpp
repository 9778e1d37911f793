// vision/radial_scan.hpp: what the radial lines of one frame show, sample by sample.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "vision/carpet.hpp"
#include "vision/colour_classes.hpp"
#include "vision/line_reader.hpp"
#include "vision/pixel_reader.hpp"
#include "vision/scan_lines.hpp"
#include "vision/surface.hpp"

namespace teamsight::vision {

/// The radial lines of one frame, read once for everything that looks at them. Its buffers are its
/// only state.
class RadialScan {
 public:
  /// @param chroma_window  samples over which chroma is averaged, odd
  RadialScan(const ScanLines& lines, std::size_t chroma_window);

  /// Reads luminance (bilinear) and colour class (of the mean chroma around) everywhere and
  /// measures the carpet; then judges each sample. Nothing is carpet in a frame without any.
  void read(const PixelReader& pixels, const ColourClasses& colours, const ScanLines& lines);

  /// Makes what a ball covers kBall, whatever its colours and its shade look like: it stands on the
  /// carpet, but is no obstacle.
  ///
  /// @param radius_px  of its disc about the middle
  void take_for_ball(const ScanLines& lines, const Pixel& middle, double radius_px);

  /// In the order of the samples of `lines`; valid until the next call of read.
  [[nodiscard]] std::span<const std::uint8_t> luminance(const ScanRange& range) const {
    return std::span(luminance_).subspan(range.first, range.count);
  }

  [[nodiscard]] std::span<const ColourClass> classes(const ScanRange& range) const {
    return std::span(classes_).subspan(range.first, range.count);
  }

  [[nodiscard]] std::span<const Surface> surfaces(const ScanRange& range) const {
    return std::span(surfaces_).subspan(range.first, range.count);
  }

  /// Luminance of the carpet beside the i-th sample of a line, grey levels.
  [[nodiscard]] float carpet_beside(const ScanRange& range, std::size_t i) const {
    return static_cast<float>(levels_[range.first + i]) / kLevelsPerGrey;
  }

  /// How many samples of the line, from its start, lie before the end of the carpet; 0: it shows
  /// none. Paint, balls and short dark things with carpet behind them do not end it.
  [[nodiscard]] std::size_t carpet_end(std::size_t radial_line) const {
    return carpet_ends_[radial_line];
  }

  [[nodiscard]] const Carpet& carpet() const { return carpet_; }

 private:
  void classify(const PixelReader& pixels, const ColourClasses& colours, const ScanLines& lines);
  void judge(const ScanLines& lines);
  [[nodiscard]] std::size_t find_carpet_end(const ScanRange& range) const;

  ChromaReader chroma_reader_;
  std::vector<std::uint8_t> luminance_;
  std::vector<ColourClass> classes_;
  std::vector<Chroma> chroma_;       // without a cast of the light
  std::vector<CarpetLevel> levels_;  // of the carpet beside
  std::vector<Surface> surfaces_;
  std::vector<std::size_t> carpet_ends_;
  CarpetMeter meter_;
  Carpet carpet_;
};

}  // namespace teamsight::vision
