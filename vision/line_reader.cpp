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
constexpr int kShift = 15;             // of sums over a tap's four pixels
constexpr int kHalf = 1 << (kShift - 1);
constexpr std::size_t kWidestWindow = 127;
constexpr std::size_t kSpare = ChromaReader::kSpare;
static_assert(kSpare >= 2 * kLanes);  // averaged at once

template <class Word>
std::uint32_t load(const std::uint8_t* from) {
  Word word;
  std::memcpy(&word, from, sizeof(word));
  return word;
}

/// How a format's bytes lie. `word`: of a pixel and its right neighbour. `luminances`: theirs,
/// taken out of such words. `pair`: what holds u and v of a pixel, `chromas` takes them out.
struct Yuyv {
  const std::uint8_t* bytes;

  [[nodiscard]] std::uint32_t word(std::size_t pixel) const {
    return load<std::uint32_t>(bytes + 2 * pixel);
  }

  static FourWords luminances(const FourWords& words) { return words & kTwoBytes; }

  [[nodiscard]] std::uint32_t pair(std::size_t pixel) const {
    return word(pixel & ~std::size_t{1});
  }

  static FourWords chromas(const FourWords& pairs) { return pairs >> 8U & kTwoBytes; }
};

struct Uyvy {
  const std::uint8_t* bytes;

  [[nodiscard]] std::uint32_t word(std::size_t pixel) const {
    return load<std::uint32_t>(bytes + 2 * pixel);
  }

  static FourWords luminances(const FourWords& words) { return words >> 8U & kTwoBytes; }

  [[nodiscard]] std::uint32_t pair(std::size_t pixel) const {
    return word(pixel & ~std::size_t{1});
  }

  static FourWords chromas(const FourWords& pairs) { return pairs & kTwoBytes; }
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

  [[nodiscard]] std::uint32_t pair(std::size_t pixel) const {
    const Chroma single = pixels.chroma(pixel);
    return single.u | std::uint32_t{single.v} << 16U;
  }

  static FourWords chromas(const FourWords& pairs) { return pairs; }
};

/// @param above  luminances of the pixels left and right above four places, sixteen bits each
/// @param under  the same under them
/// @param within  right (lowest byte) and below (next) of those places' taps
FourInts interpolated(const FourWords& above, const FourWords& under, const FourWords& within) {
  const FourWords right = within & 0xFFU;
  const FourWords below = within >> 8U & 0xFFU;
  const auto top = std::bit_cast<EightHalves>(above);
  const auto bottom = std::bit_cast<EightHalves>(under);
  // No more than sixteen bits, whatever the parts of the sum come to.
  const EightHalves left_and_right =
      (top << 8) + (bottom - top) * std::bit_cast<EightHalves>(below | below << 16U);
  const FourWords weights = kWhole + (right << 16U) - right;
  const FourInts sums = pair_products(std::bit_cast<EightShorts>(left_and_right >> 1),
                                      std::bit_cast<EightShorts>(weights));
  return (sums + kHalf) >> kShift;
}

// Of four taps, how far right (lowest byte) and below (next) of their corners they are.
FourWords within_of(const SampleTap* taps) {
  const auto first = load_lanes<FourWords>(taps);
  const auto second = load_lanes<FourWords>(taps + 2);
  return __builtin_shufflevector(first, second, 1, 3, 5, 7);
}

// Inline, so that what is the same for all fours of a line is made ready once.
template <class Format>
[[gnu::always_inline]] inline void read_four(const Format& format,
                                             std::size_t width,
                                             const SampleTap* taps,
                                             std::uint8_t* luminance) {
  const auto words = [&](std::size_t row) {
    return FourWords{format.word(taps[0].corner + row),
                     format.word(taps[1].corner + row),
                     format.word(taps[2].corner + row),
                     format.word(taps[3].corner + row)};
  };
  store_bytes(
      interpolated(Format::luminances(words(0)), Format::luminances(words(width)), within_of(taps)),
      luminance);
}

template <class Format>
void read_format(const Format& format,
                 std::size_t width,
                 std::span<const SampleTap> taps,
                 std::span<std::uint8_t> luminance) {
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
  std::array<std::uint8_t, kLanes> read{};
  read_four(format, width, few.data(), read.data());
  std::copy_n(read.begin(), n, luminance.begin());
}

template <class Format>
void read_chroma(const Format& format,
                 std::span<const std::uint32_t> places,
                 std::span<std::uint32_t> chroma) {
  const std::size_t n = places.size();
  const auto read = [&](std::size_t i) {
    const FourWords pairs{format.pair(places[i]),
                          format.pair(places[i + 1]),
                          format.pair(places[i + 2]),
                          format.pair(places[i + 3])};
    store_lanes(Format::chromas(pairs), &chroma[i]);
  };
  for (std::size_t i = 0; i + kLanes <= n; i += kLanes) read(i);
  if (n % kLanes == 0) return;
  if (n > kLanes) return read(n - kLanes);
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t pair = format.pair(places[i]);
    chroma[i] = Format::chromas(FourWords{pair, pair, pair, pair})[0];
  }
}

void read_chroma(const PixelReader& pixels,
                 std::span<const std::uint32_t> places,
                 std::span<std::uint32_t> chroma) {
  if (pixels.format() == PixelFormat::kYuyv) {
    return read_chroma(Yuyv{pixels.bytes()}, places, chroma);
  }
  if (pixels.format() == PixelFormat::kUyvy) {
    return read_chroma(Uyvy{pixels.bytes()}, places, chroma);
  }
  return read_chroma(Other{pixels}, places, chroma);
}

}  // namespace

void read_luminance(const PixelReader& pixels,
                    std::span<const SampleTap> taps,
                    std::span<std::uint8_t> luminance) {
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

namespace {

// Times 2^(16 + shift), rounded up. Of a window of one it has no room, nor is it needed.
std::uint16_t reciprocal_of(std::size_t window, std::uint32_t shift) {
  const std::size_t one = std::size_t{1} << (16U + shift);
  return window == 1 ? std::uint16_t{0} : static_cast<std::uint16_t>((one + window - 1) / window);
}

}  // namespace

ChromaReader::ChromaReader(std::size_t window, std::size_t longest)
    : window_(window | 1U),
      shift_(static_cast<std::uint32_t>(std::bit_width(window_)) - 1),
      reciprocal_(reciprocal_of(window_, shift_)),
      single_(longest + window_ - 1 + kSpare),
      mean_(longest + kSpare) {
  TEAMSIGHT_EXPECT(window_ <= kWidestWindow);
}

std::span<const Chroma> ChromaReader::read(const PixelReader& pixels,
                                           std::span<const std::uint32_t> places) {
  TEAMSIGHT_EXPECT(!places.empty() && places.size() + kSpare <= mean_.size());
  const std::size_t n = places.size();
  const std::size_t half = window_ / 2;
  const std::span<std::uint32_t> line = std::span(single_).subspan(half, n);
  read_chroma(pixels, places, line);
  // Beyond its ends the line goes on as it ends.
  std::fill_n(single_.begin(), half, line.front());
  std::fill_n(single_.begin() + static_cast<std::ptrdiff_t>(half + n), half, line.back());
  average(n);
  return std::span(mean_).first(n);
}

// The sums of u and v over a window stay apart in one word: up to 127 bytes each, no carry. The
// reciprocal is too large by less than 127 of 2^(16 + shift): for no such sum enough to reach the
// next whole mean.
void ChromaReader::average(std::size_t n) {
  static_assert(sizeof(Chroma) == 2);
  // What is stored might be members of this, for all that the compiler knows.
  const std::size_t window = window_;
  const std::uint32_t shift = shift_;
  const std::uint32_t* const single = single_.data();
  Chroma* const mean = mean_.data();
  const EightHalves reciprocal = reciprocal_ + EightHalves{};
  for (std::size_t i = 0; i < n; i += 2 * kLanes) {
    auto one = load_lanes<FourWords>(single + i);
    auto two = load_lanes<FourWords>(single + i + kLanes);
    for (std::size_t k = 1; k < window; ++k) {
      one += load_lanes<FourWords>(single + i + k);
      two += load_lanes<FourWords>(single + i + kLanes + k);
    }
    auto low = std::bit_cast<EightHalves>(one);
    auto high = std::bit_cast<EightHalves>(two);
    if (window > 1) {
      low = high_products(low, reciprocal) >> shift;
      high = high_products(high, reciprocal) >> shift;
    }
    store_lanes(to_bytes(low, high), mean + i);
  }
}

}  // namespace teamsight::vision
