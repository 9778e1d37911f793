// vision/ball_detector.cpp: seeds, blobs, and what makes a blob a ball.
#include "vision/ball_detector.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "vision/camera_model.hpp"
#include "vision/polygon.hpp"
#include "vision/surface.hpp"

namespace teamsight::vision {

namespace {

constexpr std::size_t kFewestPixels = 6;
constexpr std::size_t kMostPixels = 40000;
constexpr double kPixelSigma = 0.6;  // px, of a blob's middle
constexpr double kSizeSigma = 0.2;   // of a ball's size: shade, struts, blur and the mirror's table
constexpr std::size_t kMostBlobs = 128;
constexpr double kTooMany =
    2.5;  // of a ball's pixels on the floor: something behind has its colour
constexpr float kHalfHeight = 0.5F;       // of the strongest colour: there a ball's edge is
constexpr std::size_t kFewestInPart = 4;  // pixels
constexpr std::size_t kBehind = 30;       // samples behind the carpet's hull
constexpr double kPartsApart = 1.7;       // of the expected radius, between the parts' middles
constexpr double kPartsTogether = 1.3;    // of the expected radius, for both together
constexpr float kNear = 0.8F;  // m; there the own body hides parts of what surrounds a ball

BallColour colour_name(double u, double v) {
  // Hue sectors of the chroma plane about grey: orange lies between red (v up) and yellow (u down).
  const double hue = std::atan2(v - 128.0, u - 128.0);
  if (hue > 0.0 && hue < 0.62 * std::numbers::pi) return BallColour::kRed;
  if (hue >= 0.0 && hue < 0.80 * std::numbers::pi) return BallColour::kOrange;
  return hue > 0.0 ? BallColour::kYellow : BallColour::kUnknown;
}

bool is_in_rings(const Mask& mask, double radius_px) {
  return radius_px >= mask.inner_radius_px && radius_px <= mask.outer_radius_px;
}

// The first sample from `i` on that has the ball's colour; `end` if there is none before it.
std::size_t next_of_ball(std::span<const ColourClass> classes, std::size_t i, std::size_t end) {
  const std::span<const ColourClass> rest = classes.subspan(i, end - i);
  const void* found =
      std::memchr(rest.data(), static_cast<std::uint8_t>(ColourClass::kBall), rest.size());
  if (found == nullptr) return end;
  return static_cast<std::size_t>(static_cast<const ColourClass*>(found) - classes.data());
}

}  // namespace

BallDetector::BallDetector(const RayTable& rays,
                           const Mask& mask,
                           const Pixel& centre,
                           const BallRules& rules)
    : centre_(centre),
      rules_(rules) {
  const std::size_t pixels = std::size_t{rays.width()} * rays.height();
  solid_angle_.resize(pixels, 0.0F);
  visited_.resize(pixels, 0);
  open_.reserve(kMostPixels);
  blobs_.reserve(kMostBlobs);
  found_.reserve(kMostBlobs);
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    const auto u = static_cast<std::uint32_t>(pixel % rays.width());
    const auto v = static_cast<std::uint32_t>(pixel / rays.width());
    const double radius = std::hypot(u - centre.u, v - centre.v);
    const PixelRay& ray = rays[pixel];
    if (ray.sees_floor() && std::hypot(ray.floor_x, ray.floor_y) < kNear) {
      near_px_ = std::max(near_px_, radius);
    }
    // Struts are not masked: they have no ball's colour, and a ball shows on both of their sides.
    if (is_in_rings(mask, radius) && !is_hidden(mask, {1.0 * u, 1.0 * v})) {
      solid_angle_[pixel] = solid_angle_of(rays, u, v);
    }
  }
}

template <class Belongs>
BallBlob BallDetector::grow(const FrameTables& frame, std::size_t seed, Belongs belongs) {
  BallBlob blob;
  const std::size_t width = frame.rays.width();
  const auto visit = [&](std::size_t pixel) {
    if (open_.size() < kMostPixels && belongs(pixel)) open_.push_back(pixel);
  };
  open_.clear();
  visit(seed);
  // `open_` is not popped: it is both the queue and, at the end, the blob.
  for (std::size_t next = 0; next < open_.size(); ++next) {
    const std::size_t pixel = open_[next];
    add(frame, pixel, blob);
    // solid_angle_ is 0 in the last row and column, and unsigned wrap-around is caught by the size.
    for (const std::size_t neighbour : {pixel - 1, pixel + 1, pixel - width, pixel + width}) {
      if (neighbour < visited_.size()) visit(neighbour);
    }
  }
  return blob;
}

void BallDetector::add(const FrameTables& frame, std::size_t pixel, BallBlob& blob) const {
  const std::size_t width = frame.rays.width();
  const PixelRay& ray = frame.rays[pixel];
  const auto weight = static_cast<double>(solid_angle_[pixel]);
  const Eigen::Vector3d direction =
      Eigen::Vector3f(ray.direction_x, ray.direction_y, ray.direction_z).cast<double>();
  const Chroma chroma = frame.pixels.chroma(pixel);
  ++blob.pixels;
  blob.solid_angle += weight;
  const auto u = static_cast<double>(pixel % width);
  const std::size_t row = pixel / width;
  const auto v = static_cast<double>(row);
  blob.sum_u += u;
  blob.sum_v += v;
  blob.sum_uu += u * u;
  blob.sum_uv += u * v;
  blob.sum_vv += v * v;
  blob.sum_u_chroma += chroma.u;
  blob.sum_v_chroma += chroma.v;
  blob.sum_direction += weight * direction;
  blob.sum_square += weight * direction * direction.transpose();
  blob.sum_origin +=
      weight * Eigen::Vector3f(ray.origin_x, ray.origin_y, ray.origin_z).cast<double>();
}

BallBlob BallDetector::grow_of_class(const FrameTables& frame, std::size_t seed) {
  return grow(frame, seed, [&](std::size_t pixel) {
    if (is_taken(pixel) || solid_angle_[pixel] <= 0.0F) return false;
    const PixelReader& pixels = frame.pixels;
    if (frame.colours.chromatic(pixels.luminance(pixel), pixels.chroma(pixel)) !=
        ColourClass::kBall) {
      return false;
    }
    visited_[pixel] = frame_;
    return true;
  });
}

BallBlob BallDetector::grow_ball(const FrameTables& frame, std::size_t seed) {
  BallBlob blob = grow_of_class(frame, seed);
  if (blob.pixels < kFewestPixels) return blob;
  const std::size_t width = frame.rays.width();
  const std::size_t row = seed / width;
  const Pixel place{static_cast<double>(seed % width), static_cast<double>(row)};
  const double radius = expected_radius(frame.rays, rules_.ball_radius, place);
  const double expected = std::numbers::pi * radius * radius;
  if (expected <= 0.0 || static_cast<double>(blob.pixels) < kTooMany * expected) return blob;
  // The blob lies in the order of its distance from the seed: first what may be the ball.
  const auto near = static_cast<std::ptrdiff_t>(std::ceil(expected));
  const auto strength = [&](std::size_t pixel) {
    return distance_from_grey(frame.pixels.chroma(pixel));
  };
  const std::size_t core =
      *std::ranges::max_element(open_.begin(), open_.begin() + near, {}, strength);
  const float least = kHalfHeight * strength(core);
  return grow(frame, core, [&](std::size_t pixel) {
    if (visited_[pixel] != frame_ || strength(pixel) < least) return false;
    visited_[pixel] = frame_ + 1;
    return true;
  });
}

bool BallDetector::are_parts(const RayTable& rays, const BallBlob& a, const BallBlob& b) const {
  const BlobEllipse one = ellipse_of(a);
  const BlobEllipse other = ellipse_of(b);
  const Pixel middle{0.5 * (one.u + other.u), 0.5 * (one.v + other.v)};
  const double radius = expected_radius(rays, rules_.ball_radius, middle);
  const double seen = std::sqrt(static_cast<double>(a.pixels + b.pixels) / std::numbers::pi);
  return std::hypot(one.u - other.u, one.v - other.v) < kPartsApart * radius &&
         seen < kPartsTogether * radius;
}

void BallDetector::join_parts(const RayTable& rays) {
  for (std::size_t i = 0; i < blobs_.size(); ++i) {
    const auto rest = std::remove_if(blobs_.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                     blobs_.end(),
                                     [&](const BallBlob& other) {
                                       if (!are_parts(rays, blobs_[i], other)) return false;
                                       blobs_[i] += other;
                                       return true;
                                     });
    blobs_.erase(rest, blobs_.end());
  }
}

void BallDetector::judge(const FrameTables& frame, const BallBlob& blob) {
  if (blob.pixels < kFewestPixels || blob.solid_angle <= 0.0) return;
  BallCandidate candidate;
  candidate.pixels.traits =
      traits_of(blob, {frame, solid_angle_, centre_, near_px_, rules_.ball_radius});
  BallRay& ray = candidate.ray;
  ray.confidence = probability(rules_.model, candidate.pixels.traits);
  if (ray.confidence < rules_.model.least) return;
  const auto count = static_cast<double>(blob.pixels);
  ray.ray_R.origin = Point3<Robot>::from(blob.sum_origin / blob.solid_angle);
  ray.ray_R.direction = blob.sum_direction.normalized();
  ray.angular_radius = angular_extent_of(blob);
  const double pixel_angle = std::sqrt(blob.solid_angle / count);
  // The outline of n pixels is wrong by about a pixel of blur, and the middle by less.
  ray.sigma_angular_radius = std::max(kSizeSigma * ray.angular_radius, 0.7 * pixel_angle);
  const double sigma = kPixelSigma * pixel_angle + 0.03 * ray.angular_radius;
  const double level = ray.ray_R.direction.head<2>().norm();
  const double sigma_azimuth = sigma / std::max(level, 0.05);
  ray.cov_direction = Eigen::Vector2d(sigma_azimuth * sigma_azimuth, sigma * sigma).asDiagonal();
  ray.colour = colour_name(blob.sum_u_chroma / count, blob.sum_v_chroma / count);
  candidate.pixels.u_px = blob.sum_u / count;
  candidate.pixels.v_px = blob.sum_v / count;
  candidate.pixels.r_px = std::sqrt(count / std::numbers::pi);
  candidate.pixels.on_carpet = candidate.pixels.traits[kInsideCarpet] > 0.0;
  found_.push_back(candidate);
}

void BallDetector::seed_from(const FrameTables& frame, std::size_t radial_line) {
  const ScanRange& range = frame.lines.radial()[radial_line];
  const auto places = frame.lines.pixels(range);
  const auto classes = frame.scan.classes(range);
  const std::size_t end = std::min(frame.hull.end(radial_line) + kBehind, places.size() - 1);
  for (std::size_t i = next_of_ball(classes, 0, end); i < end;
       i = next_of_ball(classes, i + 1, end)) {
    // Two in a row: single pixels of noise are not worth a search.
    if (classes[i + 1] != ColourClass::kBall) continue;
    const std::size_t pixel = places[i];
    if (is_taken(pixel) || blobs_.size() == kMostBlobs) continue;
    const BallBlob blob = grow_ball(frame, pixel);
    if (blob.pixels >= kFewestInPart) blobs_.push_back(blob);
  }
}

std::span<const BallCandidate> BallDetector::find(const FrameTables& frame) {
  frame_ += 2;
  found_.clear();
  blobs_.clear();
  for (std::size_t i = 0; i < frame.lines.radial().size(); ++i) seed_from(frame, i);
  join_parts(frame.rays);
  for (const BallBlob& blob : blobs_) judge(frame, blob);
  std::ranges::sort(found_, [](const BallCandidate& a, const BallCandidate& b) {
    return a.ray.confidence > b.ray.confidence;
  });
  if (found_.size() > rules_.most) found_.resize(rules_.most);
  return found_;
}

}  // namespace teamsight::vision
