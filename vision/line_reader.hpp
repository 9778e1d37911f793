// vision/line_reader.hpp: luminance and chroma along a scan line, the frame's format asked once.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "vision/pixel_reader.hpp"
#include "vision/scan_lines.hpp"

namespace teamsight::vision {

/// Luminance interpolated between the four pixels around each place, rounded to grey levels.
///
/// @param luminance  one for each tap
void read_luminance(const PixelReader& pixels,
                    std::span<const SampleTap> taps,
                    std::span<std::uint8_t> luminance);

/// Chroma of single pixels is noisy, more so in the dark: its mean over a window of the line.
class ChromaReader {
 public:
  /// So many values behind those of a line may be loaded as well; they mean nothing.
  static constexpr std::size_t kSpare = 8;

  /// @param window  samples, odd, less than 128
  /// @param longest  of the lines to be read
  ChromaReader(std::size_t window, std::size_t longest);

  /// @param places  a line's samples as indices of pixels
  /// @return one for each place; valid until the next call
  [[nodiscard]] std::span<const Chroma> read(const PixelReader& pixels,
                                             std::span<const std::uint32_t> places);

 private:
  /// Of the first `n` of `single_`, to `mean_`; a few more are written.
  void average(std::size_t n);

  std::size_t window_;
  std::uint32_t shift_;                // a mean is this part of the upper sixteen bits of ...
  std::uint16_t reciprocal_;           // ... this times the sum
  std::vector<std::uint32_t> single_;  // u + (v << 16); half a window longer at both ends
  std::vector<Chroma> mean_;
};

}  // namespace teamsight::vision
