// vision/line_reader.cpp: see vision/line_reader.hpp.
#include "vision/line_reader.hpp"

#include <algorithm>

#include "geometry/expect.hpp"

namespace teamsight::vision {

namespace {

// A division by the window as a product: exact for sums of up to 255 times a window below 128.
constexpr unsigned kShift = 22;
constexpr std::size_t kWidestWindow = 127;

// `a`, `b` beside each other, `c`, `d` below them.
float interpolated(const SampleTap& tap, float a, float b, float c, float d) {
  const float above = a + tap.right * (b - a);
  const float below = c + tap.right * (d - c);
  return above + tap.below * (below - above);
}

/// @tparam kStep  bytes from one pixel's luminance to the next
template <std::size_t kStep>
void read_plane(const std::uint8_t* first,
                std::size_t width_px,
                std::span<const SampleTap> taps,
                std::span<float> luminance) {
  const std::size_t row = kStep * width_px;
  for (std::size_t i = 0; i < taps.size(); ++i) {
    const SampleTap& tap = taps[i];
    const std::uint8_t* at = first + kStep * tap.corner;
    luminance[i] = interpolated(tap, at[0], at[kStep], at[row], at[row + kStep]);
  }
}

void read_pixels(const PixelReader& pixels,
                 std::span<const SampleTap> taps,
                 std::span<float> luminance) {
  const auto y = [&](std::size_t pixel) {
    return static_cast<float>(pixels.luminance(pixel));
  };
  for (std::size_t i = 0; i < taps.size(); ++i) {
    const SampleTap& tap = taps[i];
    const std::size_t under = tap.corner + pixels.width();
    luminance[i] = interpolated(tap, y(tap.corner), y(tap.corner + 1), y(under), y(under + 1));
  }
}

}  // namespace

void read_luminance(const PixelReader& pixels,
                    std::span<const SampleTap> taps,
                    std::span<float> luminance) {
  TEAMSIGHT_EXPECT(taps.size() == luminance.size());
  const BytePlane plane = pixels.luminance_plane();
  if (plane.step == 1) return read_plane<1>(plane.first, pixels.width(), taps, luminance);
  if (plane.step == 2) return read_plane<2>(plane.first, pixels.width(), taps, luminance);
  read_pixels(pixels, taps, luminance);
}

ChromaReader::ChromaReader(std::size_t window, std::size_t longest)
    : window_(window | 1U),
      reciprocal_(static_cast<std::uint32_t>(((1U << kShift) + window_ - 1) / window_)),
      single_(longest + window_ - 1),
      mean_(longest) {
  TEAMSIGHT_EXPECT(window_ <= kWidestWindow);
}

std::span<const Chroma> ChromaReader::read(const PixelReader& pixels,
                                           std::span<const SampleTap> taps) {
  TEAMSIGHT_EXPECT(!taps.empty() && taps.size() <= mean_.size());
  const std::size_t n = taps.size();
  const std::size_t half = window_ / 2;
  const std::span<Chroma> line = std::span(single_).subspan(half, n);
  if (const BytePlane pairs = pixels.chroma_pairs(); pairs.step == 4) {
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint8_t* pair = pairs.first + 4 * std::size_t{taps[i].nearest / 2};
      line[i] = {pair[0], pair[2]};
    }
  } else {
    for (std::size_t i = 0; i < n; ++i) line[i] = pixels.chroma(taps[i].nearest);
  }
  // Beyond its ends the line goes on as it ends.
  std::fill_n(single_.begin(), half, line.front());
  std::fill_n(single_.begin() + static_cast<std::ptrdiff_t>(half + n), half, line.back());
  std::uint32_t u = 0;
  std::uint32_t v = 0;
  for (std::size_t i = 0; i + 1 < window_; ++i) {
    u += single_[i].u;
    v += single_[i].v;
  }
  for (std::size_t i = 0; i < n; ++i) {
    u += single_[i + window_ - 1].u;
    v += single_[i + window_ - 1].v;
    mean_[i] = {static_cast<std::uint8_t>(u * reciprocal_ >> kShift),
                static_cast<std::uint8_t>(v * reciprocal_ >> kShift)};
    u -= single_[i].u;
    v -= single_[i].v;
  }
  return std::span(mean_).first(n);
}

}  // namespace teamsight::vision
