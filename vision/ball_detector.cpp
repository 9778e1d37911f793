// vision/ball_detector.cpp: seeds, blobs, and what makes a blob a ball.
#include "vision/ball_detector.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "vision/camera_model.hpp"

namespace teamsight::vision {

namespace {

constexpr std::size_t kFewestPixels = 6;
constexpr std::size_t kMostPixels = 40000;
constexpr double kPixelSigma = 0.6;      // px, of a blob's middle
constexpr double kWorthReporting = 0.1;  // confidence
constexpr double kSizeSpread = 0.45;     // log of seen over expected radius, one sigma

// The solid angle that a pixel covers: the parallelogram of its neighbours' directions.
float solid_angle_of(const RayTable& rays, std::uint32_t u, std::uint32_t v) {
  const auto direction = [&](std::uint32_t column, std::uint32_t row) {
    const PixelRay& ray = rays.at(column, row);
    return Eigen::Vector3f(ray.direction_x, ray.direction_y, ray.direction_z);
  };
  if (u + 1 >= rays.width() || v + 1 >= rays.height()) return 0.0F;
  if (!rays.at(u, v).sees_something() || !rays.at(u + 1, v).sees_something() ||
      !rays.at(u, v + 1).sees_something()) {
    return 0.0F;
  }
  const Eigen::Vector3f here = direction(u, v);
  return (direction(u + 1, v) - here).cross(direction(u, v + 1) - here).norm();
}

BallColour colour_name(double u, double v) {
  // Hue sectors of the chroma plane about grey: orange lies between red (v up) and yellow (u down).
  const double hue = std::atan2(v - 128.0, u - 128.0);
  if (hue > 0.0 && hue < 0.62 * std::numbers::pi) return BallColour::kRed;
  if (hue >= 0.0 && hue < 0.80 * std::numbers::pi) return BallColour::kOrange;
  return hue > 0.0 ? BallColour::kYellow : BallColour::kUnknown;
}

// 1 for a disc, towards 0 for a streak: the smaller over the larger spread of the directions.
double roundness(const Eigen::Matrix3d& spread, const Eigen::Vector3d& axis) {
  const Eigen::Vector3d a = axis.unitOrthogonal();
  const Eigen::Vector3d b = axis.cross(a);
  const double aa = a.dot(spread * a);
  const double bb = b.dot(spread * b);
  const double ab = a.dot(spread * b);
  const double middle = 0.5 * (aa + bb);
  const double reach = std::hypot(0.5 * (aa - bb), ab);
  return middle + reach > 0.0 ? std::sqrt(std::max(0.0, (middle - reach) / (middle + reach))) : 0.0;
}

// How well a blob's angular radius fits a ball lying on the floor, in [0.2, 1]: one in the air
// looks too large for its direction, and is still a ball.
double size_fit(const Ray<Robot>& ray, double angular_radius, double ball_radius) {
  const auto foot = meet_plane(ray, ball_radius);
  if (!foot) return 0.2;
  const Eigen::Vector3d way = Eigen::Vector3d(foot->x, foot->y, ball_radius) - ray.origin.vector();
  const double expected = std::asin(std::min(1.0, ball_radius / way.norm()));
  const double off = std::log(angular_radius / expected) / kSizeSpread;
  return 0.2 + 0.8 * std::exp(-0.5 * off * off);
}

}  // namespace

BallDetector::BallDetector(const RayTable& rays,
                           const Mask& mask,
                           const Pixel& centre,
                           double ball_radius)
    : ball_radius_(ball_radius) {
  const std::size_t pixels = std::size_t{rays.width()} * rays.height();
  solid_angle_.resize(pixels, 0.0F);
  visited_.resize(pixels, 0);
  open_.reserve(kMostPixels);
  for (std::uint32_t v = 0; v < rays.height(); ++v) {
    for (std::uint32_t u = 0; u < rays.width(); ++u) {
      const double du = u - centre.u;
      const double dv = v - centre.v;
      const double radius = std::hypot(du, dv);
      if (radius < mask.inner_radius_px || radius > mask.outer_radius_px) continue;
      if (is_masked(mask, std::atan2(-dv, du))) continue;
      solid_angle_[std::size_t{v} * rays.width() + u] = solid_angle_of(rays, u, v);
    }
  }
}

BallDetector::Blob BallDetector::grow(const PixelReader& pixels,
                                      const ColourClasses& colours,
                                      const RayTable& rays,
                                      std::size_t seed) {
  Blob blob;
  const std::size_t width = rays.width();
  const auto visit = [&](std::size_t pixel) {
    if (visited_[pixel] == frame_ || solid_angle_[pixel] <= 0.0F) return;
    if (open_.size() >= kMostPixels) return;
    if (colours.of(pixels.chroma(pixel)) != ColourClass::kBall) return;
    visited_[pixel] = frame_;
    open_.push_back(pixel);
  };
  open_.clear();
  visit(seed);
  // `open_` is not popped: it is both the queue and, at the end, the blob.
  for (std::size_t next = 0; next < open_.size(); ++next) {
    const std::size_t pixel = open_[next];
    const PixelRay& ray = rays[pixel];
    const auto weight = static_cast<double>(solid_angle_[pixel]);
    const Eigen::Vector3d direction =
        Eigen::Vector3f(ray.direction_x, ray.direction_y, ray.direction_z).cast<double>();
    const Chroma chroma = pixels.chroma(pixel);
    ++blob.pixels;
    blob.solid_angle += weight;
    blob.sum_u += static_cast<double>(pixel % width);
    const std::size_t row = pixel / width;
    blob.sum_v += static_cast<double>(row);
    blob.sum_u_chroma += chroma.u;
    blob.sum_v_chroma += chroma.v;
    blob.sum_direction += weight * direction;
    blob.sum_square += weight * direction * direction.transpose();
    blob.sum_origin +=
        weight * Eigen::Vector3f(ray.origin_x, ray.origin_y, ray.origin_z).cast<double>();
    // solid_angle_ is 0 in the last row and column, and unsigned wrap-around is caught by the size.
    for (const std::size_t neighbour : {pixel - 1, pixel + 1, pixel - width, pixel + width}) {
      if (neighbour < visited_.size()) visit(neighbour);
    }
  }
  return blob;
}

void BallDetector::judge(const Blob& blob) {
  if (blob.pixels < kFewestPixels || blob.solid_angle <= 0.0) return;
  const auto count = static_cast<double>(blob.pixels);
  const Eigen::Vector3d mean = blob.sum_direction / blob.solid_angle;
  BallCandidate candidate;
  BallRay& ray = candidate.ray;
  ray.ray_R.origin = Point3<Robot>::from(blob.sum_origin / blob.solid_angle);
  ray.ray_R.direction = mean.normalized();
  ray.angular_radius =
      std::acos(std::max(-1.0, 1.0 - blob.solid_angle / (2.0 * std::numbers::pi)));  // of a cone
  const double pixel_angle = std::sqrt(blob.solid_angle / count);
  // The outline of n pixels is wrong by about a pixel of blur, and the middle by less.
  ray.sigma_angular_radius = std::max(0.1 * ray.angular_radius, 0.7 * pixel_angle);
  const double sigma = kPixelSigma * pixel_angle + 0.03 * ray.angular_radius;
  const double level = ray.ray_R.direction.head<2>().norm();
  const double sigma_azimuth = sigma / std::max(level, 0.05);
  ray.cov_direction = Eigen::Vector2d(sigma_azimuth * sigma_azimuth, sigma * sigma).asDiagonal();
  ray.colour = colour_name(blob.sum_u_chroma / count, blob.sum_v_chroma / count);
  const Eigen::Matrix3d spread = blob.sum_square / blob.solid_angle - mean * mean.transpose();
  const double enough = 1.0 - std::exp(-count / 12.0);
  ray.confidence = 0.97 * enough * std::min(1.0, 1.4 * roundness(spread, ray.ray_R.direction)) *
                   size_fit(ray.ray_R, ray.angular_radius, ball_radius_);
  if (ray.confidence < kWorthReporting) return;
  candidate.pixels = {blob.sum_u / count, blob.sum_v / count, std::sqrt(count / std::numbers::pi)};
  found_.push_back(candidate);
}

void BallDetector::seed_from(std::span<const ScanSample> line,
                             const PixelReader& pixels,
                             const ColourClasses& colours,
                             const RayTable& rays) {
  const auto is_ball = [&](std::size_t pixel) {
    return colours.of(pixels.chroma(pixel)) == ColourClass::kBall;
  };
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const std::size_t pixel = line[i].nearest;
    if (visited_[pixel] == frame_) continue;
    // Two in a row: single pixels of noise are not worth a search.
    if (is_ball(pixel) && is_ball(line[i + 1].nearest)) judge(grow(pixels, colours, rays, pixel));
  }
}

std::span<const BallCandidate> BallDetector::find(const PixelReader& pixels,
                                                  const ColourClasses& colours,
                                                  const ScanLines& lines,
                                                  const RayTable& rays) {
  ++frame_;
  found_.clear();
  for (const ScanRange& range : lines.radial()) {
    seed_from(lines.samples(range), pixels, colours, rays);
  }
  std::ranges::sort(found_, [](const BallCandidate& a, const BallCandidate& b) {
    return a.ray.confidence > b.ray.confidence;
  });
  if (found_.size() > kMaxBallRays) found_.resize(kMaxBallRays);
  return found_;
}

}  // namespace teamsight::vision
