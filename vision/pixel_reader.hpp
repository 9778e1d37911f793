// vision/pixel_reader.hpp: luminance and chroma of single pixels, straight from the camera's bytes.
#pragma once

#include <cstddef>
#include <cstdint>

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
  /// @pre is_whole(image), and an even width where two pixels share their chroma; the image's bytes
  ///      outlive this
  explicit PixelReader(const ImageView& image)
      : bytes_(image.bytes.data()),
        width_(image.width_px),
        format_(image.format) {
    TEAMSIGHT_EXPECT(is_whole(image));
  }

  [[nodiscard]] std::uint32_t width() const { return width_; }

  [[nodiscard]] std::uint8_t luminance(std::size_t pixel) const {
    switch (format_) {
      case PixelFormat::kYuyv:
        return bytes_[2 * pixel];
      case PixelFormat::kUyvy:
        return bytes_[2 * pixel + 1];
      case PixelFormat::kBgr:
        return luminance_of_bgr(bytes_[3 * pixel], bytes_[3 * pixel + 1], bytes_[3 * pixel + 2]);
      case PixelFormat::kGrey:
        break;
    }
    return bytes_[pixel];
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
        break;
    }
    return {};
  }

 private:
  const std::uint8_t* bytes_;
  std::uint32_t width_;
  PixelFormat format_;
};

}  // namespace teamsight::vision
