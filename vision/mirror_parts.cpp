// vision/mirror_parts.cpp: pixels whose lines of sight hang together.
#include "vision/mirror_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>

namespace teamsight::vision {

namespace {

constexpr float kJump = 0.25F;           // between neighbours' directions; a kink turns by more
constexpr std::size_t kSmallest = 500;   // part of the image; less is a cone's tip or noise
constexpr std::uint8_t kMostParts = 16;  // that are told apart
constexpr std::size_t kSeam = 3;         // px, that blur reaches

Eigen::Vector3f direction_of(const PixelRay& ray) {
  return {ray.direction_x, ray.direction_y, ray.direction_z};
}

/// Fills one part after the other.
class Filling {
 public:
  Filling(const RayTable& rays, std::vector<std::uint8_t>& parts) : rays_(rays), parts_(parts) {}

  /// Gives all that hangs together with the pixel that number.
  ///
  /// @return how many pixels those are
  std::size_t fill(std::size_t pixel, std::uint8_t number) {
    const std::size_t width = rays_.width();
    open_.assign(1, pixel);
    parts_[pixel] = number;
    for (std::size_t next = 0; next < open_.size(); ++next) {
      const std::size_t here = open_[next];
      const std::size_t column = here % width;
      if (column > 0) visit(here, here - 1, number);
      if (column + 1 < width) visit(here, here + 1, number);
      if (here >= width) visit(here, here - width, number);
      if (here + width < parts_.size()) visit(here, here + width, number);
    }
    return open_.size();
  }

  /// What was filled last belongs to no part.
  void forget() {
    for (const std::size_t pixel : open_) parts_[pixel] = kTooSmall;
  }

  static constexpr std::uint8_t kTooSmall = 254;

 private:
  void visit(std::size_t from, std::size_t to, std::uint8_t number) {
    if (parts_[to] != MirrorParts::kNone || !rays_[to].sees_something()) return;
    const float turn = (direction_of(rays_[to]) - direction_of(rays_[from])).norm();
    if (turn > kJump) return;
    parts_[to] = number;
    open_.push_back(to);
  }

  const RayTable& rays_;
  std::vector<std::uint8_t>& parts_;
  std::vector<std::size_t> open_;
};

// The number of the part whose nearest pixel is nearest to the centre.
std::uint8_t part_at(const Pixel& centre,
                     const std::vector<std::uint8_t>& parts,
                     std::size_t width) {
  std::uint8_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t pixel = 0; pixel < parts.size(); ++pixel) {
    if (parts[pixel] >= kMostParts) continue;
    const std::size_t row = pixel / width;
    const double distance = std::hypot(static_cast<double>(pixel % width) - centre.u,
                                       static_cast<double>(row) - centre.v);
    if (distance >= least) continue;
    least = distance;
    nearest = parts[pixel];
  }
  return nearest;
}

}  // namespace

MirrorParts::MirrorParts(const RayTable& rays, const Pixel& centre)
    : parts_(std::size_t{rays.width()} * rays.height(), kNone) {
  Filling filling(rays, parts_);
  std::uint8_t count = 0;
  for (std::size_t pixel = 0; pixel < parts_.size() && count < kMostParts; ++pixel) {
    if (parts_[pixel] != kNone || !rays[pixel].sees_something()) continue;
    if (kSmallest * filling.fill(pixel, count) < parts_.size()) {
      filling.forget();
    } else {
      ++count;
    }
  }
  if (count < 2) {
    parts_.clear();
    return;
  }
  const std::uint8_t inner = part_at(centre, parts_, rays.width());
  for (std::uint8_t& part : parts_) {
    if (part >= kMostParts) {
      part = kNone;
    } else if (part == inner) {
      part = kInner;
    } else if (part == kInner) {
      part = inner;
    }
  }
}

bool MirrorParts::is_seam(std::size_t pixel, std::size_t width) const {
  if (parts_.empty()) return false;
  const auto differs = [&](std::size_t other) {
    return other < parts_.size() && parts_[other] != parts_[pixel];
  };
  for (std::size_t k = 1; k <= kSeam; ++k) {
    if (differs(pixel - k) || differs(pixel + k) || differs(pixel - k * width) ||
        differs(pixel + k * width)) {
      return true;
    }
  }
  return false;
}

}  // namespace teamsight::vision
