// vision/pixel_reader.hpp: luminance and chroma of single pixels, straight from the camera's bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "geometry/expect.hpp"
#include "vision/image.hpp"

namespace teamsight::vision {

/// A place in the chroma plane, BT.601, 8 bits; (128, 128) is grey.
struct Chroma {
  std::uint8_t u{128};
  std::uint8_t v{128};

  friend bool operator==(const Chroma&, const Chroma&) = default;
};

/// BT.601 full-range chroma of a colour; what the camera files' samples are given in.
[[nodiscard]] constexpr Chroma chroma_of_bgr(int b, int g, int r) {
  // 16.16 fixed point; the sums stay within 0 ... 255 by construction of the coefficients.
  const int u = 128 + ((-11058 * r - 21710 * g + 32768 * b) >> 16);
  const int v = 128 + ((32768 * r - 27439 * g - 5329 * b) >> 16);
  return {static_cast<std::uint8_t>(u < 0 ? 0 : (u > 255 ? 255 : u)),
          static_cast<std::uint8_t>(v < 0 ? 0 : (v > 255 ? 255 : v))};
}

/// BT.601 luminance of a colour.
[[nodiscard]] constexpr std::uint8_t luminance_of_bgr(int b, int g, int r) {
  return static_cast<std::uint8_t>((7471 * b + 38470 * g + 19595 * r + 32768) >> 16);
}

/// Reads a frame's pixels by their index (row * width + column), whatever its format.
class PixelReader {
 public:
  /// @pre is_whole(image); the image's bytes outlive this
  explicit PixelReader(const ImageView& image)
      : bytes_(image.bytes.data()),
        width_(image.width_px),
        height_(image.height_px),
        format_(image.format) {
    TEAMSIGHT_EXPECT(is_whole(image));
  }

  [[nodiscard]] std::uint32_t width() const { return width_; }

  [[nodiscard]] PixelFormat format() const { return format_; }

  /// As the camera gave them, for who reads many pixels of one format.
  [[nodiscard]] const std::uint8_t* bytes() const { return bytes_; }

  [[nodiscard]] std::uint8_t luminance(std::size_t pixel) const {
    switch (format_) {
      case PixelFormat::kYuyv:
        return bytes_[2 * pixel];
      case PixelFormat::kUyvy:
        return bytes_[2 * pixel + 1];
      case PixelFormat::kBgr:
        return luminance_of_bgr(bytes_[3 * pixel], bytes_[3 * pixel + 1], bytes_[3 * pixel + 2]);
      case PixelFormat::kGrey:
      case PixelFormat::kNv12:
        return bytes_[pixel];
      default:
        break;
    }
    const Bgr colour = bayer(pixel);
    return luminance_of_bgr(colour.b, colour.g, colour.r);
  }

  /// Grey images have none: (128, 128).
  [[nodiscard]] Chroma chroma(std::size_t pixel) const {
    const std::size_t pair = 2 * (pixel & ~std::size_t{1});
    switch (format_) {
      case PixelFormat::kYuyv:
        return {bytes_[pair + 1], bytes_[pair + 3]};
      case PixelFormat::kUyvy:
        return {bytes_[pair], bytes_[pair + 2]};
      case PixelFormat::kBgr:
        return chroma_of_bgr(bytes_[3 * pixel], bytes_[3 * pixel + 1], bytes_[3 * pixel + 2]);
      case PixelFormat::kGrey:
        return {};
      case PixelFormat::kNv12:
        return nv12_chroma(pixel);
      default:
        break;
    }
    const Bgr colour = bayer(pixel);
    return chroma_of_bgr(colour.b, colour.g, colour.r);
  }

 private:
  struct Bgr {
    int b{0};
    int g{0};
    int r{0};
  };

  // Behind the luminance plane: (u, v) of each two by two pixels.
  [[nodiscard]] Chroma nv12_chroma(std::size_t pixel) const {
    const std::size_t row = pixel / width_;
    const std::size_t column = pixel % width_;
    const std::uint8_t* pair =
        bytes_ + std::size_t{width_} * height_ + row / 2 * width_ + (column & ~std::size_t{1});
    return {pair[0], pair[1]};
  }

  // Row and column, modulo 2, of the mosaic's red pixels.
  [[nodiscard]] std::pair<std::ptrdiff_t, std::ptrdiff_t> place_of_red() const {
    switch (format_) {
      case PixelFormat::kBayerBggr:
        return {1, 1};
      case PixelFormat::kBayerGrbg:
        return {0, 1};
      case PixelFormat::kBayerGbrg:
        return {1, 0};
      default:
        return {0, 0};
    }
  }

  // The nine pixels around weigh 1 2 1, 2 4 2, 1 2 1: wherever that stands on the mosaic, red and
  // blue get 4 each and green 8, and the middle stays the middle.
  [[nodiscard]] Bgr bayer(std::size_t pixel) const {
    const auto row = static_cast<std::ptrdiff_t>(pixel / width_);
    const auto column = static_cast<std::ptrdiff_t>(pixel % width_);
    const auto [red_row, red_column] = place_of_red();
    // By whether row and column are the red ones'.
    int sum[2][2] = {{0, 0}, {0, 0}};
    for (std::ptrdiff_t dv = -1; dv <= 1; ++dv) {
      const std::ptrdiff_t v = reflected(row + dv, height_);
      const bool in_red_row = v % 2 == red_row;
      for (std::ptrdiff_t du = -1; du <= 1; ++du) {
        const std::ptrdiff_t u = reflected(column + du, width_);
        const bool in_red_column = u % 2 == red_column;
        const auto weight = static_cast<int>((2 - std::abs(dv)) * (2 - std::abs(du)));
        sum[in_red_row ? 1 : 0][in_red_column ? 1 : 0] +=
            weight * bytes_[v * static_cast<std::ptrdiff_t>(width_) + u];
      }
    }
    return {sum[0][0] / 4, (sum[0][1] + sum[1][0]) / 8, sum[1][1] / 4};
  }

  // Back inside the image by reflection, which keeps a mosaic's parity.
  [[nodiscard]] static std::ptrdiff_t reflected(std::ptrdiff_t place, std::uint32_t size) {
    if (place < 0) return -place;
    const auto end = static_cast<std::ptrdiff_t>(size);
    return place < end ? place : 2 * end - 2 - place;
  }

  const std::uint8_t* bytes_;
  std::uint32_t width_;
  std::uint32_t height_;
  PixelFormat format_;
};

}  // namespace teamsight::vision
