// sim/render/sights.cpp: see sights.hpp.
#include "sim/render/sights.hpp"

#include <limits>

#include <Eigen/Geometry>

#include "geometry/expect.hpp"

namespace teamsight::sim {
namespace {

constexpr double kTurn = 6.283185307179586;

struct Line {
  Eigen::Vector3f origin{0.0F, 0.0F, 0.0F};
  Eigen::Vector3f direction{0.0F, 0.0F, 0.0F};  // zero: nothing is seen

  [[nodiscard]] bool sees() const { return direction.squaredNorm() > 0.5F; }
};

// How far the direction turns from one pixel to the next: sideways and up.
Eigen::Vector2f turn_to(const Line& from, const Line& to, const Eigen::Vector3f& side) {
  if (!to.sees()) {
    return {0.0F, 0.0F};
  }
  const Eigen::Vector3f change = to.direction - from.direction;
  return {change.dot(side), change.dot(from.direction.cross(side))};
}

Sight make_sight(std::uint32_t pixel, const Line& line, const Line& beside, const Line& below) {
  constexpr float kNever = std::numeric_limits<float>::infinity();
  Sight sight;
  sight.origin_x = line.origin.x();
  sight.origin_y = line.origin.y();
  sight.origin_z = line.origin.z();
  sight.direction_x = line.direction.x();
  sight.direction_y = line.direction.y();
  sight.direction_z = line.direction.z();
  sight.flat = std::hypot(sight.direction_x, sight.direction_y);
  sight.pixel = pixel;
  sight.floor_x = kNever;
  sight.floor_y = kNever;
  sight.reach = kNever;
  // Straight down there is no sideways: any does.
  const Eigen::Vector3f level(-line.direction.y(), line.direction.x(), 0.0F);
  const Eigen::Vector3f side =
      level.norm() > 1e-6F ? level.normalized() : Eigen::Vector3f(Eigen::Vector3f::UnitY());
  const Eigen::Vector2f to_right = turn_to(line, beside, side);
  const Eigen::Vector2f down = turn_to(line, below, side);
  sight.width = std::max(std::hypot(to_right.x(), down.x()), 1e-5F);
  sight.height = std::max(std::hypot(to_right.y(), down.y()), 1e-5F);
  if (line.direction.z() < -1e-4F) {
    const float t = -line.origin.z() / line.direction.z();
    sight.floor_x = line.origin.x() + t * line.direction.x();
    sight.floor_y = line.origin.y() + t * line.direction.y();
    sight.reach = std::hypot(sight.floor_x, sight.floor_y);
  }
  return sight;
}

}  // namespace

Sights::Sights(const Optics& optics, std::uint32_t width, std::uint32_t height, int fineness)
    : width_(width * static_cast<std::uint32_t>(fineness)),
      height_(height * static_cast<std::uint32_t>(fineness)) {
  TEAMSIGHT_EXPECT(width > 1 && height > 1 && fineness >= 1);
  std::vector<Line> lines(std::size_t{width_} * height_);
  for (std::uint32_t pixel = 0; pixel < lines.size(); ++pixel) {
    const std::uint32_t column = pixel % width_;
    const std::uint32_t row = pixel / width_;
    const auto ray = optics.look({(column + 0.5) / fineness - 0.5, (row + 0.5) / fineness - 0.5});
    if (ray.has_value()) {
      lines[pixel] = {ray->origin.vector().cast<float>(), ray->direction.cast<float>()};
    }
  }
  for (std::uint32_t pixel = 0; pixel < lines.size(); ++pixel) {
    const bool is_last = pixel % width_ + 1 == width_;
    const Line& beside = lines[is_last ? pixel - 1 : pixel + 1];
    const Line& below = lines[pixel + width_ < lines.size() ? pixel + width_ : pixel - width_];
    if (lines[pixel].sees()) {
      sights_.push_back(make_sight(pixel, lines[pixel], beside, below));
    }
  }
  sort_into_bins();
}

void Sights::forget(const std::vector<bool>& hidden) {
  std::erase_if(sights_, [&hidden](const Sight& sight) { return hidden[sight.pixel]; });
  sort_into_bins();
}

std::size_t Sights::bin_of(double azimuth) {
  const double turn = azimuth / kTurn;
  const auto bin = static_cast<std::size_t>((turn - std::floor(turn)) * kBins);
  return std::min(bin, kBins - 1);
}

void Sights::sort_into_bins() {
  by_bin_.clear();
  by_bin_.reserve(sights_.size());
  bin_starts_.clear();
  std::vector<std::vector<std::uint32_t>> bins(kBins);
  for (std::uint32_t i = 0; i < sights_.size(); ++i) {
    const Sight& sight = sights_[i];
    bins[bin_of(std::atan2(static_cast<double>(sight.direction_y),
                           static_cast<double>(sight.direction_x)))]
        .push_back(i);
  }
  for (std::vector<std::uint32_t>& bin : bins) {
    std::sort(bin.begin(), bin.end(), [this](std::uint32_t a, std::uint32_t b) {
      return sights_[a].reach < sights_[b].reach;
    });
    bin_starts_.push_back(static_cast<std::uint32_t>(by_bin_.size()));
    for (const std::uint32_t i : bin) {
      by_bin_.push_back(sights_[i]);
    }
  }
  bin_starts_.push_back(static_cast<std::uint32_t>(by_bin_.size()));
}

}  // namespace teamsight::sim
