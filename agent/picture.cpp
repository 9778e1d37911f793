// agent/picture.cpp: see agent/picture.hpp.
#include "agent/picture.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include <turbojpeg.h>

#include "vision/pixel_reader.hpp"

namespace teamsight::agent {
namespace {

constexpr int kQuality = 60;

/// The planes of a JPEG, each as large as the picture.
struct Planes {
  std::vector<std::uint8_t> y;
  std::vector<std::uint8_t> u;
  std::vector<std::uint8_t> v;
};

/// Each pixel of the picture is the mean luminance of four pixels of its square of the frame, and
/// the chroma of the first.
Planes planes_of(const vision::PixelReader& reader,
                 std::uint32_t step,
                 std::uint32_t width,
                 std::uint32_t height) {
  Planes planes;
  const std::size_t size = std::size_t{width} * height;
  planes.y.reserve(size);
  planes.u.reserve(size);
  planes.v.reserve(size);
  const std::size_t right = step / 2;
  const std::size_t below = right * reader.width();
  for (std::uint32_t row = 0; row < height; ++row) {
    for (std::uint32_t column = 0; column < width; ++column) {
      const std::size_t pixel = (std::size_t{row} * reader.width() + column) * step;
      const int sum = reader.luminance(pixel) + reader.luminance(pixel + right) +
                      reader.luminance(pixel + below) + reader.luminance(pixel + below + right);
      const vision::Chroma chroma = reader.chroma(pixel);
      planes.y.push_back(static_cast<std::uint8_t>((sum + 2) / 4));
      planes.u.push_back(chroma.u);
      planes.v.push_back(chroma.v);
    }
  }
  return planes;
}

struct Destroy {
  void operator()(void* compressor) const { tjDestroy(compressor); }
};

struct Free {
  void operator()(unsigned char* bytes) const { tjFree(bytes); }
};

}  // namespace

std::optional<Picture> picture_of(const vision::ImageView& frame) {
  const std::uint32_t step = (frame.width_px + kWidestPicture - 1) / kWidestPicture;
  const std::uint32_t width = frame.width_px / step;
  const std::uint32_t height = frame.height_px / step;
  const std::unique_ptr<void, Destroy> compressor(tjInitCompress());
  if (!compressor || height == 0 || height > UINT16_MAX) return std::nullopt;
  const Planes planes = planes_of(vision::PixelReader(frame), step, width, height);
  std::array<const unsigned char*, 3> starts{planes.y.data(), planes.u.data(), planes.v.data()};
  unsigned char* bytes = nullptr;
  unsigned long size = 0;  // NOLINT(google-runtime-int): the library's
  const int failed = tjCompressFromYUVPlanes(compressor.get(),
                                             starts.data(),
                                             static_cast<int>(width),
                                             nullptr,
                                             static_cast<int>(height),
                                             TJSAMP_444,
                                             &bytes,
                                             &size,
                                             kQuality,
                                             0);
  const std::unique_ptr<unsigned char, Free> owned(bytes);
  if (failed != 0 || size > kMostPictureBytes) return std::nullopt;
  return Picture{
      static_cast<std::uint16_t>(width), static_cast<std::uint16_t>(height), {bytes, bytes + size}};
}

}  // namespace teamsight::agent
