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

namespace teamsight::vision {

/// What one sample shows, judged against the carpet beside it: dark and bright mean darker and
/// brighter than that, so that a shaded corner or a vignetted rim changes nothing.
enum class Surface : std::uint8_t {
  kCarpet,
  kPaint,  ///< bright and without colour: lines, but also walls, nets and white shoes
  kDark,   ///< a robot's base, a shadowed leg, black furniture
  kShirt,  ///< a strong colour that neither carpet nor ball has
  kBall,   ///< the ball's colour
  kOther,  ///< wood, skin, grey walls
};

/// The radial lines of one frame, read once for everything that looks at them. Its buffers are its
/// only state.
class RadialScan {
 public:
  /// @param chroma_window  samples over which chroma is averaged, odd
  RadialScan(const ScanLines& lines, std::size_t chroma_window);

  /// Reads luminance (bilinear) and colour class (of the mean chroma around) everywhere and
  /// measures the carpet; then judges each sample. Nothing is carpet in a frame without any.
  void read(const PixelReader& pixels, const ColourClasses& colours, const ScanLines& lines);

  /// In the order of the samples of `lines`; valid until the next call of read.
  [[nodiscard]] std::span<const float> luminance(const ScanRange& range) const {
    return std::span(luminance_).subspan(range.first, range.count);
  }

  [[nodiscard]] std::span<const ColourClass> classes(const ScanRange& range) const {
    return std::span(classes_).subspan(range.first, range.count);
  }

  [[nodiscard]] std::span<const Surface> surfaces(const ScanRange& range) const {
    return std::span(surfaces_).subspan(range.first, range.count);
  }

  /// How many samples of the line, from its start, lie before the end of the carpet; 0: it shows
  /// none. Paint, balls and short dark things with carpet behind them do not end it.
  [[nodiscard]] std::size_t carpet_end(std::size_t radial_line) const {
    return carpet_ends_[radial_line];
  }

  [[nodiscard]] const Carpet& carpet() const { return carpet_; }

 private:
  void classify(const PixelReader& pixels, const ColourClasses& colours, const ScanLines& lines);
  void judge(const ScanRange& range);
  [[nodiscard]] std::size_t find_carpet_end(const ScanRange& range) const;

  ChromaReader chroma_reader_;
  std::vector<float> luminance_;
  std::vector<ColourClass> classes_;
  std::vector<std::uint8_t> chromas_;  // distance from grey
  std::vector<Surface> surfaces_;
  std::vector<std::size_t> carpet_ends_;
  CarpetMeter meter_;
  Carpet carpet_;
};

}  // namespace teamsight::vision
