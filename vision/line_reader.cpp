// vision/line_reader.cpp: see vision/line_reader.hpp.
//
// Two values of a byte each travel in one word, sixteen bits apart: two pixels beside each other,
// or u and v.
#include "vision/line_reader.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

#include "geometry/expect.hpp"

namespace teamsight::vision {

namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::uint32_t kTwoBytes = 0x00FF00FF;
constexpr std::uint32_t kWhole = 256;  // of a tap's weights
// A division by the window as a product: exact for sums of up to 255 times a window below 128.
constexpr unsigned kShift = 22;
constexpr std::size_t kWidestWindow = 127;

template <class Word>
std::uint32_t load(const std::uint8_t* from) {
  Word word;
  std::memcpy(&word, from, sizeof(word));
  return word;
}

/// How a format's bytes lie. `luminances`: of a pixel and its right neighbour; `chroma`: u and v.
struct Yuyv {
  static std::uint32_t luminances(const std::uint8_t* bytes, std::size_t pixel) {
    return load<std::uint32_t>(bytes + 2 * pixel) & kTwoBytes;
  }

  static std::uint32_t chroma(const std::uint8_t* bytes, std::size_t pixel) {
    return load<std::uint32_t>(bytes + 2 * (pixel & ~std::size_t{1})) >> 8U & kTwoBytes;
  }
};

struct Uyvy {
  static std::uint32_t luminances(const std::uint8_t* bytes, std::size_t pixel) {
    return load<std::uint32_t>(bytes + 2 * pixel) >> 8U & kTwoBytes;
  }

  static std::uint32_t chroma(const std::uint8_t* bytes, std::size_t pixel) {
    return load<std::uint32_t>(bytes + 2 * (pixel & ~std::size_t{1})) & kTwoBytes;
  }
};

struct Planar {
  static std::uint32_t luminances(const std::uint8_t* bytes, std::size_t pixel) {
    const std::uint32_t pair = load<std::uint16_t>(bytes + pixel);
    return (pair | pair << 8U) & kTwoBytes;
  }
};

// Two luminances weighed by how far right the place is; times 256. In the product the sum stands in
// the second sixteen bits; what is below it does not reach them.
std::uint32_t weighed(std::uint32_t luminances, std::uint32_t right) {
  const std::uint64_t weights = right | std::uint64_t{kWhole - right} << 16U;
  return static_cast<std::uint32_t>(luminances * weights >> 16U) & 0xFFFFU;
}

/// @param luminances  of a pixel and its right neighbour, by the pixel's index
template <class Luminances>
void interpolate(std::size_t width,
                 std::span<const SampleTap> taps,
                 std::span<float> luminance,
                 Luminances luminances) {
  for (std::size_t i = 0; i < taps.size(); ++i) {
    const SampleTap tap = taps[i];
    const std::uint32_t above = weighed(luminances(tap.corner), tap.right);
    const std::uint32_t under = weighed(luminances(tap.corner + width), tap.right);
    const std::uint32_t sum = above * (kWhole - tap.below) + under * tap.below;
    luminance[i] = static_cast<float>(static_cast<std::int32_t>(sum)) * 0x1p-16F;
  }
}

template <class Format>
void read_format(const PixelReader& pixels,
                 std::span<const SampleTap> taps,
                 std::span<float> luminance) {
  const std::uint8_t* bytes = pixels.bytes();
  interpolate(pixels.width(), taps, luminance, [bytes](std::size_t pixel) {
    return Format::luminances(bytes, pixel);
  });
}

template <class Format>
void read_chroma(const PixelReader& pixels,
                 std::span<const SampleTap> taps,
                 std::span<std::uint32_t> chroma) {
  for (std::size_t i = 0; i < taps.size(); ++i) {
    chroma[i] = Format::chroma(pixels.bytes(), taps[i].nearest(pixels.width()));
  }
}

void read_chroma(const PixelReader& pixels,
                 std::span<const SampleTap> taps,
                 std::span<std::uint32_t> chroma) {
  if (pixels.format() == PixelFormat::kYuyv) return read_chroma<Yuyv>(pixels, taps, chroma);
  if (pixels.format() == PixelFormat::kUyvy) return read_chroma<Uyvy>(pixels, taps, chroma);
  for (std::size_t i = 0; i < taps.size(); ++i) {
    const Chroma single = pixels.chroma(taps[i].nearest(pixels.width()));
    chroma[i] = single.u | std::uint32_t{single.v} << 16U;
  }
}

}  // namespace

void read_luminance(const PixelReader& pixels,
                    std::span<const SampleTap> taps,
                    std::span<float> luminance) {
  TEAMSIGHT_EXPECT(taps.size() == luminance.size());
  switch (pixels.format()) {
    case PixelFormat::kYuyv:
      return read_format<Yuyv>(pixels, taps, luminance);
    case PixelFormat::kUyvy:
      return read_format<Uyvy>(pixels, taps, luminance);
    case PixelFormat::kGrey:
    case PixelFormat::kNv12:
      return read_format<Planar>(pixels, taps, luminance);
    default:
      return interpolate(pixels.width(), taps, luminance, [&](std::size_t pixel) {
        return pixels.luminance(pixel) | std::uint32_t{pixels.luminance(pixel + 1)} << 16U;
      });
  }
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
  const std::span<std::uint32_t> line = std::span(single_).subspan(half, n);
  read_chroma(pixels, taps, line);
  // Beyond its ends the line goes on as it ends.
  std::fill_n(single_.begin(), half, line.front());
  std::fill_n(single_.begin() + static_cast<std::ptrdiff_t>(half + n), half, line.back());
  std::uint32_t sum = 0;  // of up to 127 bytes each: no carry
  for (std::size_t i = 0; i + 1 < window_; ++i) sum += single_[i];
  for (std::size_t i = 0; i < n; ++i) {
    sum += single_[i + window_ - 1];
    mean_[i] = {static_cast<std::uint8_t>((sum & 0xFFFFU) * reciprocal_ >> kShift),
                static_cast<std::uint8_t>((sum >> 16U) * reciprocal_ >> kShift)};
    sum -= single_[i];
  }
  return std::span(mean_).first(n);
}

}  // namespace teamsight::vision
