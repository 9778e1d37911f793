// sim/render/sensor.cpp: see sensor.hpp.
#include "sim/render/sensor.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/expect.hpp"
#include "vision/image.hpp"

namespace teamsight::sim {
namespace {

using vision::PixelFormat;

constexpr std::size_t kNoise = std::size_t{1} << 15;

Canvas make_noise() {
  Random random(7);
  Canvas noise(kNoise);
  for (Light& light : noise) {
    const auto normal = [&random] {
      return static_cast<float>(random.normal(1.0));
    };
    light = {normal(), normal(), normal(), 0.0F};
  }
  return noise;
}

// Normal, sigma 1: the same for all sensors, each of which begins where its own chance says.
const Canvas& shared_noise() {
  static const Canvas noise = make_noise();
  return noise;
}

// Which of the three channels a pixel of a mosaic sees.
int mosaic_channel(PixelFormat format, std::size_t row, std::size_t column) {
  const bool red_is_low = format == PixelFormat::kBayerBggr || format == PixelFormat::kBayerGbrg;
  const bool red_is_right = format == PixelFormat::kBayerBggr || format == PixelFormat::kBayerGrbg;
  const bool in_red_row = (row % 2 == 1) == red_is_low;
  const bool in_red_column = (column % 2 == 1) == red_is_right;
  if (in_red_row != in_red_column) return 1;
  return in_red_row ? 0 : 2;
}

float luminance(const Light& colour) {
  return 0.299F * colour[0] + 0.587F * colour[1] + 0.114F * colour[2];
}

std::uint8_t byte(float value) {
  return static_cast<std::uint8_t>(std::clamp(value + 0.5F, 0.0F, 255.0F));
}

}  // namespace

Sensor::Sensor(const SensorParameters& parameters,
               const vision::CameraParameters& camera,
               const ImagePlace& centre)
    : parameters_(parameters),
      width_(camera.width_px),
      height_(camera.height_px),
      format_(camera.format),
      noise_(shared_noise().data()),
      row_(width_),
      ring_{Canvas(width_), Canvas(width_), Canvas(width_)} {
  TEAMSIGHT_EXPECT(vision::has_even_size(format_, camera.width_px, camera.height_px));
  gain_ = Light(static_cast<float>(parameters.red_gain),
                static_cast<float>(parameters.green_gain),
                static_cast<float>(parameters.blue_gain),
                1.0F) *
          static_cast<float>(parameters.exposure);
  // A pass adds twice its weight to the square of sigma; a weight above 0.3 would ring.
  const double widest = std::max(parameters.defocus_px, parameters.rim_defocus_px);
  blur_passes_ = static_cast<int>(std::ceil(widest * widest / 0.6));
  const double corner = std::hypot(static_cast<double>(width_), static_cast<double>(height_)) / 2.0;
  for (std::size_t row = 0; row < height_; ++row) {
    for (std::size_t column = 0; column < width_; ++column) {
      const double radius =
          std::hypot(static_cast<double>(column) - centre.u, static_cast<double>(row) - centre.v);
      const double out = std::min(radius / corner, 1.0);
      const double sigma =
          parameters.defocus_px + out * out * (parameters.rim_defocus_px - parameters.defocus_px);
      const double passes = std::max(blur_passes_, 1);
      blur_weight_.push_back(static_cast<float>(std::min(sigma * sigma / 2.0 / passes, 0.3)));
      vignette_.push_back(static_cast<float>(1.0 - parameters.vignetting * out * out));
    }
  }
}

void Sensor::develop(const Canvas& light, Random& random, std::vector<std::uint8_t>& out) {
  TEAMSIGHT_EXPECT(light.size() == width_ * height_);
  out.resize(vision::frame_bytes(
      format_, static_cast<std::uint32_t>(width_), static_cast<std::uint32_t>(height_)));
  const Canvas* source = &light;
  if (blur_passes_ > 1) {
    copy_ = light;
    for (int pass = 1; pass < blur_passes_; ++pass) {
      blur_once(copy_);
    }
    source = &copy_;
  }
  blur_along(source->data(), 0, ring_[0].data());
  ring_[2] = ring_[0];
  for (std::size_t row = 0; row < height_; ++row) {
    const std::size_t below = std::min(row + 1, height_ - 1);
    blur_along(source->data() + below * width_, below, ring_[(row + 1) % 3].data());
    expose_row(row, random);
    write_row(row, out);
  }
}

// Each pixel takes its weight from both neighbours.
void Sensor::blur_along(const Light* from, std::size_t row, Light* to) const {
  const float* weight = blur_weight_.data() + row * width_;
  to[0] = from[0];
  for (std::size_t column = 1; column + 1 < width_; ++column) {
    to[column] =
        from[column] + weight[column] * (from[column - 1] + from[column + 1] - 2.0F * from[column]);
  }
  to[width_ - 1] = from[width_ - 1];
}

void Sensor::blur_once(Canvas& light) {
  blur_along(light.data(), 0, ring_[0].data());
  ring_[2] = ring_[0];
  for (std::size_t row = 0; row < height_; ++row) {
    const std::size_t below = std::min(row + 1, height_ - 1);
    const float* weight = blur_weight_.data() + row * width_;
    Canvas& next = ring_[(row + 1) % 3];
    blur_along(light.data() + below * width_, below, next.data());
    const Canvas& here = ring_[row % 3];
    const Canvas& above = ring_[(row + 2) % 3];
    for (std::size_t column = 0; column < width_; ++column) {
      light[row * width_ + column] =
          here[column] + weight[column] * (above[column] + next[column] - 2.0F * here[column]);
    }
  }
}

// The second half of the last blur, and what the sensor makes of it.
void Sensor::expose_row(std::size_t row, Random& random) {
  const Light* above = ring_[(row + 2) % 3].data();
  const Light* here = ring_[row % 3].data();
  const Light* below = ring_[(row + 1) % 3].data();
  const float* weight = blur_weight_.data() + row * width_;
  const float* vignette = vignette_.data() + row * width_;
  const auto sigma = static_cast<float>(parameters_.noise_sigma);
  const auto dark_sigma = static_cast<float>(parameters_.dark_noise_sigma);
  std::size_t n = random.below(kNoise);
  for (std::size_t column = 0; column < width_; ++column) {
    const Light light =
        here[column] + weight[column] * (above[column] + below[column] - 2.0F * here[column]);
    const Light shown = 255.0F * (light * gain_ * vignette[column]).max(0.0F).sqrt();
    const Light noise_sigma = sigma + dark_sigma * (1.0F - shown * (1.0F / 64.0F)).max(0.0F);
    row_[column] = shown.min(255.0F) + noise_sigma * noise_[n++ & (kNoise - 1)];
  }
}

void Sensor::write_row(std::size_t row, std::vector<std::uint8_t>& out) {
  std::uint8_t* to =
      out.data() + row * vision::row_bytes(format_, static_cast<std::uint32_t>(width_));
  switch (format_) {
    case PixelFormat::kYuyv:
    case PixelFormat::kUyvy:
      write_pairs(to);
      break;
    case PixelFormat::kBgr:
      write_bgr(to);
      break;
    case PixelFormat::kNv12:
      write_shared_chroma(row, out.data() + width_ * height_ + row / 2 * width_);
      [[fallthrough]];
    case PixelFormat::kGrey:
      for (const Light& colour : row_) *to++ = byte(luminance(colour));
      break;
    default:
      for (std::size_t column = 0; column < width_; ++column) {
        to[column] = byte(row_[column][mosaic_channel(format_, row, column)]);
      }
  }
}

void Sensor::write_bgr(std::uint8_t* out) const {
  for (const Light& colour : row_) {
    *out++ = byte(colour[2]);
    *out++ = byte(colour[1]);
    *out++ = byte(colour[0]);
  }
}

// Two by two pixels share their colour: the first of two rows is kept until the second is there.
void Sensor::write_shared_chroma(std::size_t row, std::uint8_t* out) {
  if (row % 2 == 0) {
    above_ = row_;
    return;
  }
  for (std::size_t column = 0; column + 1 < width_; column += 2, out += 2) {
    const Light all =
        0.25F * (above_[column] + above_[column + 1] + row_[column] + row_[column + 1]);
    const float grey = luminance(all);
    out[0] = byte(128.0F + 0.564F * (all[2] - grey));
    out[1] = byte(128.0F + 0.713F * (all[0] - grey));
  }
}

// BT.601, full range; two pixels share their colour.
void Sensor::write_pairs(std::uint8_t* out) const {
  const std::size_t y = format_ == PixelFormat::kYuyv ? 0 : 1;
  const std::size_t c = 1 - y;
  for (std::size_t column = 0; column + 1 < width_; column += 2, out += 4) {
    const Light both = 0.5F * (row_[column] + row_[column + 1]);
    const float grey = luminance(both);
    out[y] = byte(luminance(row_[column]));
    out[y + 2] = byte(luminance(row_[column + 1]));
    out[c] = byte(128.0F + 0.564F * (both[2] - grey));
    out[c + 2] = byte(128.0F + 0.713F * (both[0] - grey));
  }
}

}  // namespace teamsight::sim
