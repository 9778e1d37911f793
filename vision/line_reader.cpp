// vision/line_reader.cpp: see vision/line_reader.hpp.
//
// Two values of a byte each travel in one word, sixteen bits apart: two pixels beside each other,
// or u and v; four such words at once.
#include "vision/line_reader.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "geometry/expect.hpp"
#include "vision/lanes.hpp"

namespace teamsight::vision {

namespace {

static_assert(std::endian::native == std::endian::little);

constexpr std::uint32_t kTwoBytes = 0x00FF00FF;
constexpr std::uint32_t kWhole = 256;  // of a tap's weights
constexpr std::size_t kWidestWindow = 127;
constexpr std::size_t kSpare = ChromaReader::kSpare;
static_assert(kSpare >= kLanes);

template <class Word>
std::uint32_t load(const std::uint8_t* from) {
  Word word;
  std::memcpy(&word, from, sizeof(word));
  return word;
}

/// How a format's bytes lie. `word`: of a pixel and its right neighbour. `luminances`: theirs,
/// taken out of such words. `chroma`: u and v of a pixel.
struct Yuyv {
  const std::uint8_t* bytes;

  [[nodiscard]] std::uint32_t word(std::size_t pixel) const {
    return load<std::uint32_t>(bytes + 2 * pixel);
  }

  static FourWords luminances(const FourWords& words) { return words & kTwoBytes; }

  [[nodiscard]] std::uint32_t chroma(std::size_t pixel) const {
    return word(pixel & ~std::size_t{1}) >> 8U & kTwoBytes;
  }
};

struct Uyvy {
  const std::uint8_t* bytes;

  [[nodiscard]] std::uint32_t word(std::size_t pixel) const {
    return load<std::uint32_t>(bytes + 2 * pixel);
  }

  static FourWords luminances(const FourWords& words) { return words >> 8U & kTwoBytes; }

  [[nodiscard]] std::uint32_t chroma(std::size_t pixel) const {
    return word(pixel & ~std::size_t{1}) & kTwoBytes;
  }
};

struct Planar {
  const std::uint8_t* bytes;

  [[nodiscard]] std::uint32_t word(std::size_t pixel) const {
    return load<std::uint16_t>(bytes + pixel);
  }

  static FourWords luminances(const FourWords& words) { return (words | words << 8U) & kTwoBytes; }
};

/// Any other: pixel by pixel.
struct Other {
  const PixelReader& pixels;

  [[nodiscard]] std::uint32_t word(std::size_t pixel) const {
    return pixels.luminance(pixel) | std::uint32_t{pixels.luminance(pixel + 1)} << 16U;
  }

  static FourWords luminances(const FourWords& words) { return words; }

  [[nodiscard]] std::uint32_t chroma(std::size_t pixel) const {
    const Chroma single = pixels.chroma(pixel);
    return single.u | std::uint32_t{single.v} << 16U;
  }
};

// Two luminances in each lane weighed by how far right the place is; times 256.
FourFloats weighed(const FourWords& luminances, const FourWords& right) {
  // 256 - right and right; no product needs more than sixteen bits.
  const FourWords weights = kWhole + (right << 16U) - right;
  const FourWords products = std::bit_cast<FourWords>(std::bit_cast<EightHalves>(luminances) *
                                                      std::bit_cast<EightHalves>(weights));
  return to_floats(std::bit_cast<FourInts>((products & 0xFFFFU) + (products >> 16U)));
}

/// @param words  of a pixel and its right neighbour each, above and below four places
/// @param within  right and below, of those places' taps
FourFloats interpolated(const FourWords& above, const FourWords& under, const FourWords& within) {
  const FourFloats top = weighed(above, within & 0xFFU);
  const FourFloats bottom = weighed(under, within & 0xFFU);
  const FourFloats below = to_floats(std::bit_cast<FourInts>(within >> 8U & 0xFFU));
  // Twenty-four bits: a float holds all of them.
  return (static_cast<float>(kWhole) * top + (bottom - top) * below) * 0x1p-16F;
}

/// Of four taps: their corners, and how far right (lowest byte) and below (next) of them they are.
struct FourTaps {
  explicit FourTaps(const SampleTap* taps) {
    const auto first = load_lanes<FourWords>(taps);
    const auto second = load_lanes<FourWords>(taps + 2);
    corners = __builtin_shufflevector(first, second, 0, 2, 4, 6);
    within = __builtin_shufflevector(first, second, 1, 3, 5, 7);
  }

  // As SampleTap::nearest: from the middle on, the right and the lower neighbour.
  [[nodiscard]] FourWords nearest(std::uint32_t width) const {
    const FourWords is_lower = 0U - (within >> 15U & 1U);
    return corners + (within >> 7U & 1U) + (is_lower & width);
  }

  FourWords corners;
  FourWords within;
};

/// Writes u and v of four places.
void store_chroma(const FourInts& u, const FourInts& v, Chroma* to) {
  static_assert(sizeof(Chroma) == 2);
  store_lanes(__builtin_convertvector(u | v << 8, FourHalves), to);
}

template <class Format>
void read_four(const Format& format, std::size_t width, const SampleTap* taps, float* luminance) {
  const auto words = [&](std::size_t row) {
    return FourWords{format.word(taps[0].corner + row),
                     format.word(taps[1].corner + row),
                     format.word(taps[2].corner + row),
                     format.word(taps[3].corner + row)};
  };
  store_lanes(
      interpolated(
          Format::luminances(words(0)), Format::luminances(words(width)), FourTaps(taps).within),
      luminance);
}

template <class Format>
void read_format(const Format& format,
                 std::size_t width,
                 std::span<const SampleTap> taps,
                 std::span<float> luminance) {
  const std::size_t n = taps.size();
  for (std::size_t i = 0; i + kLanes <= n; i += kLanes) {
    read_four(format, width, &taps[i], &luminance[i]);
  }
  if (n % kLanes == 0) return;
  if (n > kLanes) {
    // The last ones once more, rather than one by one.
    read_four(format, width, &taps[n - kLanes], &luminance[n - kLanes]);
    return;
  }
  std::array<SampleTap, kLanes> few{};
  few.fill(taps.back());
  std::ranges::copy(taps, few.begin());
  std::array<float, kLanes> read{};
  read_four(format, width, few.data(), read.data());
  std::copy_n(read.begin(), n, luminance.begin());
}

template <class Format>
void read_chroma(const Format& format,
                 std::size_t width,
                 std::span<const SampleTap> taps,
                 std::span<std::uint32_t> chroma) {
  const std::size_t n = taps.size();
  std::size_t i = 0;
  for (; i + kLanes <= n; i += kLanes) {
    const FourWords pixels = FourTaps(&taps[i]).nearest(static_cast<std::uint32_t>(width));
    store_lanes(FourWords{format.chroma(pixels[0]),
                          format.chroma(pixels[1]),
                          format.chroma(pixels[2]),
                          format.chroma(pixels[3])},
                &chroma[i]);
  }
  for (; i < n; ++i) chroma[i] = format.chroma(taps[i].nearest(width));
}

void read_chroma(const PixelReader& pixels,
                 std::span<const SampleTap> taps,
                 std::span<std::uint32_t> chroma) {
  const std::size_t width = pixels.width();
  if (pixels.format() == PixelFormat::kYuyv) {
    return read_chroma(Yuyv{pixels.bytes()}, width, taps, chroma);
  }
  if (pixels.format() == PixelFormat::kUyvy) {
    return read_chroma(Uyvy{pixels.bytes()}, width, taps, chroma);
  }
  return read_chroma(Other{pixels}, width, taps, chroma);
}

}  // namespace

void read_luminance(const PixelReader& pixels,
                    std::span<const SampleTap> taps,
                    std::span<float> luminance) {
  TEAMSIGHT_EXPECT(taps.size() == luminance.size());
  const std::size_t width = pixels.width();
  switch (pixels.format()) {
    case PixelFormat::kYuyv:
      return read_format(Yuyv{pixels.bytes()}, width, taps, luminance);
    case PixelFormat::kUyvy:
      return read_format(Uyvy{pixels.bytes()}, width, taps, luminance);
    case PixelFormat::kGrey:
    case PixelFormat::kNv12:
      return read_format(Planar{pixels.bytes()}, width, taps, luminance);
    default:
      return read_format(Other{pixels}, width, taps, luminance);
  }
}

ChromaReader::ChromaReader(std::size_t window, std::size_t longest)
    : window_(window | 1U),
      single_(longest + window_ - 1 + kLanes),
      mean_(longest + kSpare) {
  TEAMSIGHT_EXPECT(window_ <= kWidestWindow);
}

std::span<const Chroma> ChromaReader::read(const PixelReader& pixels,
                                           std::span<const SampleTap> taps) {
  TEAMSIGHT_EXPECT(!taps.empty() && taps.size() + kSpare <= mean_.size());
  const std::size_t n = taps.size();
  const std::size_t half = window_ / 2;
  const std::span<std::uint32_t> line = std::span(single_).subspan(half, n);
  read_chroma(pixels, taps, line);
  // Beyond its ends the line goes on as it ends.
  std::fill_n(single_.begin(), half, line.front());
  std::fill_n(single_.begin() + static_cast<std::ptrdiff_t>(half + n), half, line.back());
  average(n);
  return std::span(mean_).first(n);
}

// The sums of u and v over a window stay apart in one word: up to 127 bytes each, no carry.
void ChromaReader::average(std::size_t n) {
  const float share = 1.0F / static_cast<float>(window_);
  // The half more is nowhere near enough to reach the next whole mean, but covers the rounding.
  const auto mean_of = [&](const FourWords& sums) {
    return to_ints((to_floats(std::bit_cast<FourInts>(sums)) + 0.5F) * share);
  };
  for (std::size_t i = 0; i < n; i += kLanes) {
    auto sums = load_lanes<FourWords>(&single_[i]);
    for (std::size_t k = 1; k < window_; ++k) sums += load_lanes<FourWords>(&single_[i + k]);
    store_chroma(mean_of(sums & 0xFFFFU), mean_of(sums >> 16U), &mean_[i]);
  }
}

}  // namespace teamsight::vision
