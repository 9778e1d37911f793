// vision/scan_lines.cpp: laying out radial lines and circles.
#include "vision/scan_lines.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "geometry/angle.hpp"
#include "vision/polygon.hpp"

namespace teamsight::vision {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kNominalHeight = 480.0;     // px, of a picture of scale 1
constexpr int kCircleSpacing = 6;            // px of scale 1 between circles
constexpr int kFirstCircle = 8;              // px of scale 1; nearer there is only own body
constexpr double kSubpixels = 256.0;         // of a tap
constexpr float kSmallestFootprint = 1e-4F;  // m; at the rim of the mirror there is no neighbour
constexpr std::size_t kShortest = 8;         // samples; no line fits into less

SampleTap tap_at(const Pixel& pixel, std::size_t width) {
  const double column = std::floor(pixel.u);
  const double row = std::floor(pixel.v);
  return {static_cast<std::uint32_t>(row) * static_cast<std::uint32_t>(width) +
              static_cast<std::uint32_t>(column),
          static_cast<std::uint8_t>(kSubpixels * (pixel.u - column)),
          static_cast<std::uint8_t>(kSubpixels * (pixel.v - row))};
}

double between(float a, float b, double t) {
  return static_cast<double>(a) + t * static_cast<double>(b - a);
}

/// Makes samples of one camera.
class Sampler {
 public:
  Sampler(const CameraParameters& parameters, const CameraModel& model, const RayTable& rays)
      : parameters_(parameters),
        model_(model),
        rays_(rays) {}

  /// Nothing outside the image, under the mask, or where no floor within reach is seen.
  [[nodiscard]] std::optional<ScanStep> at(double radius, double direction) const {
    const Mask& mask = parameters_.mask;
    if (radius < mask.inner_radius_px || radius > mask.outer_radius_px) return std::nullopt;
    if (is_masked(mask, direction)) return std::nullopt;
    const Pixel pixel{model_.centre().u + radius * std::cos(direction),
                      model_.centre().v - radius * std::sin(direction)};
    if (is_hidden(mask, {pixel.u, pixel.v})) return std::nullopt;
    // Asked of the floats that samples keep: a place between two of them has its neighbours, too.
    const auto u = static_cast<float>(pixel.u);
    const auto v = static_cast<float>(pixel.v);
    if (u < 0.0F || v < 0.0F || u >= static_cast<float>(rays_.width() - 1) ||
        v >= static_cast<float>(rays_.height() - 1)) {
      return std::nullopt;
    }
    const auto floor = model_.on_plane(pixel, 0.0);
    if (!floor || std::hypot(floor->x, floor->y) > parameters_.scan.max_distance) {
      return std::nullopt;
    }
    return step_at(pixel, *floor);
  }

 private:
  [[nodiscard]] ScanStep step_at(const Pixel& pixel, const Point<Robot>& floor) const {
    const SampleTap tap = tap_at(pixel, rays_.width());
    ScanSample sample;
    sample.u = static_cast<float>(pixel.u);
    sample.v = static_cast<float>(pixel.v);
    sample.x = static_cast<float>(floor.x);
    sample.y = static_cast<float>(floor.y);
    const PixelRay& ray = rays_[tap.nearest(rays_.width())];
    sample.radial_footprint = std::max(ray.radial_footprint, kSmallestFootprint);
    sample.tangential_footprint = std::max(ray.tangential_footprint, kSmallestFootprint);
    return {tap, sample};
  }

  const CameraParameters& parameters_;
  const CameraModel& model_;
  const RayTable& rays_;
};

std::size_t scale_of(const RayTable& rays) {
  const double shorter = std::min(rays.width(), rays.height());
  return static_cast<std::size_t>(std::max(1.0, std::round(shorter / kNominalHeight)));
}

}  // namespace

bool is_masked(const Mask& mask, double image_direction) {
  return std::ranges::any_of(mask.sectors, [&](const MaskedSector& sector) {
    const auto from_start = [&](double angle) {
      const double way = std::fmod(angle - sector.from, kTurn);
      return way < 0.0 ? way + kTurn : way;
    };
    return from_start(image_direction) <= from_start(sector.to);
  });
}

ScanLines::ScanLines(const CameraParameters& parameters,
                     const CameraModel& model,
                     const RayTable& rays)
    : scale_(scale_of(rays)),
      width_px_(rays.width()) {
  const auto scale = static_cast<int>(scale_);
  const Sampler sampler(parameters, model, rays);
  const auto reach = static_cast<int>(std::hypot(rays.width(), rays.height()));
  for (std::uint16_t i = 0; i < parameters.scan.rays; ++i) {
    const double direction = kTurn * i / parameters.scan.rays;
    const std::size_t first = samples_.size();
    for (int radius = scale; radius < reach; radius += scale) {
      const auto step = sampler.at(radius, direction);
      if (!step && samples_.size() > first) break;
      if (step) add(*step);
    }
    close(radial_, {first, 0, direction, scale_});
  }
  for (int radius = scale * kFirstCircle; radius < reach; radius += scale * kCircleSpacing) {
    const auto steps = static_cast<int>(std::ceil(kTurn * radius / scale));
    add_circle(steps, [&](int step) { return sampler.at(radius, kTurn * step / steps); });
  }
}

void ScanLines::add(const ScanStep& step) {
  taps_.push_back(step.tap);
  pixels_.push_back(static_cast<std::uint32_t>(step.tap.nearest(width_px_)));
  samples_.push_back(step.sample);
}

void ScanLines::add_circle(int steps, const std::function<std::optional<ScanStep>(int)>& step_at) {
  std::size_t first = samples_.size();
  for (int step = 0; step < steps; ++step) {
    const auto seen = step_at(step);
    if (seen) add(*seen);
    if (seen && step + 1 < steps) continue;
    close(circular_, {first, 0, 0.0, scale_});
    first = samples_.size();
  }
}

void ScanLines::add_close_taps(std::span<const ScanSample> line) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    const ScanSample& here = line[i];
    const ScanSample& next = line[std::min(i + 1, line.size() - 1)];
    for (std::size_t k = 0; k < scale_; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(scale_);
      close_taps_.push_back(
          tap_at({between(here.u, next.u, t), between(here.v, next.v, t)}, width_px_));
    }
  }
}

void ScanLines::close(std::vector<ScanRange>& ranges, ScanRange range) {
  range.count = samples_.size() - range.first;
  if (range.count < kShortest) {
    taps_.resize(range.first);
    pixels_.resize(range.first);
    samples_.resize(range.first);
    return;
  }
  if (scale_ > 1) add_close_taps(samples(range));
  longest_ = std::max(longest_, range.count);
  ranges.push_back(range);
}

}  // namespace teamsight::vision
