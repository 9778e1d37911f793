// vision/ball_detector.cpp: seeds, blobs, and what makes a blob a ball.
#include "vision/ball_detector.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "geometry/angle.hpp"
#include "vision/camera_model.hpp"
#include "vision/polygon.hpp"

namespace teamsight::vision {

namespace {

constexpr std::size_t kFewestPixels = 6;
constexpr std::size_t kMostPixels = 40000;
constexpr double kPixelSigma = 0.6;      // px, of a blob's middle
constexpr double kWorthReporting = 0.3;  // confidence
constexpr double kSizeSpread = 0.45;     // log of seen over expected radius, one sigma
constexpr std::size_t kMostBlobs = 128;
constexpr std::size_t kFewestInPart = 4;  // pixels
constexpr std::size_t kBehind = 30;       // samples behind the end of the carpet
constexpr double kPartsApart = 1.7;       // of the expected radius, between the parts' middles
constexpr double kPartsTogether = 1.3;    // of the expected radius, for both together
constexpr double kCarpetBeside = 0.06;    // rad, to radial lines that show where the carpet ends
constexpr double kAtTheEdge = 0.7;        // of the ground around it, where no carpet lies behind
constexpr double kCarpetMargin = 6.0;     // px, for the shadow before a ball
constexpr double kLeastGround = 0.3;      // of the ring
constexpr double kEnoughGround = 0.4;     // beyond the least
constexpr double kHalfGround = 0.5;
constexpr float kNear = 0.8F;    // m; there the own body hides parts of what surrounds a ball
constexpr int kRingPoints = 24;  // around a blob, where carpet is looked for
constexpr int kOwnBody = -1;
constexpr double kRingGrowth = 1.45;  // of the ring over the blob's ellipse
constexpr double kRingMargin = 2.0;   // px

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

bool is_in_rings(const Mask& mask, double radius_px) {
  return radius_px >= mask.inner_radius_px && radius_px <= mask.outer_radius_px;
}

}  // namespace

BallDetector::BallDetector(const RayTable& rays,
                           const Mask& mask,
                           const Pixel& centre,
                           double ball_radius)
    : centre_(centre),
      ball_radius_(ball_radius) {
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

BallDetector::Blob BallDetector::grow(const FrameTables& frame, std::size_t seed) {
  Blob blob;
  const PixelReader& pixels = frame.pixels;
  const std::size_t width = frame.rays.width();
  const auto visit = [&](std::size_t pixel) {
    if (visited_[pixel] == frame_ || solid_angle_[pixel] <= 0.0F) return;
    if (open_.size() >= kMostPixels) return;
    if (frame.colours.of(pixels.chroma(pixel)) != ColourClass::kBall) return;
    visited_[pixel] = frame_;
    open_.push_back(pixel);
  };
  open_.clear();
  visit(seed);
  // `open_` is not popped: it is both the queue and, at the end, the blob.
  for (std::size_t next = 0; next < open_.size(); ++next) {
    const std::size_t pixel = open_[next];
    const PixelRay& ray = frame.rays[pixel];
    const auto weight = static_cast<double>(solid_angle_[pixel]);
    const Eigen::Vector3d direction =
        Eigen::Vector3f(ray.direction_x, ray.direction_y, ray.direction_z).cast<double>();
    const Chroma chroma = pixels.chroma(pixel);
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
    blob.sum_luminance += pixels.luminance(pixel);
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

BallDetector::Blob BallDetector::sum_of(const Blob& a, const Blob& b) {
  Blob sum = a;
  sum.pixels += b.pixels;
  sum.solid_angle += b.solid_angle;
  sum.sum_u += b.sum_u;
  sum.sum_v += b.sum_v;
  sum.sum_uu += b.sum_uu;
  sum.sum_uv += b.sum_uv;
  sum.sum_vv += b.sum_vv;
  sum.sum_luminance += b.sum_luminance;
  sum.sum_u_chroma += b.sum_u_chroma;
  sum.sum_v_chroma += b.sum_v_chroma;
  sum.sum_direction += b.sum_direction;
  sum.sum_origin += b.sum_origin;
  sum.sum_square += b.sum_square;
  return sum;
}

BallDetector::Ellipse BallDetector::ellipse_of(const Blob& blob) {
  const auto count = static_cast<double>(blob.pixels);
  Ellipse ellipse;
  ellipse.u = blob.sum_u / count;
  ellipse.v = blob.sum_v / count;
  const double uu = blob.sum_uu / count - ellipse.u * ellipse.u;
  const double vv = blob.sum_vv / count - ellipse.v * ellipse.v;
  const double uv = blob.sum_uv / count - ellipse.u * ellipse.v;
  const double middle = 0.5 * (uu + vv);
  const double reach = std::hypot(0.5 * (uu - vv), uv);
  ellipse.major = 2.0 * std::sqrt(middle + reach);
  ellipse.minor = 2.0 * std::sqrt(std::max(0.0, middle - reach));
  ellipse.direction = 0.5 * std::atan2(2.0 * uv, uu - vv);
  return ellipse;
}

Chroma BallDetector::chroma_around(const FrameTables& frame, std::size_t pixel) const {
  const std::size_t width = frame.rays.width();
  unsigned u = 0;
  unsigned v = 0;
  unsigned count = 0;
  for (const std::size_t row : {pixel - width, pixel, pixel + width}) {
    for (const std::size_t place : {row - 1, row, row + 1}) {
      if (place >= solid_angle_.size()) continue;  // unsigned wrap-around as well
      const Chroma chroma = frame.pixels.chroma(place);
      u += chroma.u;
      v += chroma.v;
      ++count;
    }
  }
  return {static_cast<std::uint8_t>(u / count), static_cast<std::uint8_t>(v / count)};
}

int BallDetector::ground_points(const FrameTables& frame, std::size_t pixel, bool is_near) const {
  const float carpet = frame.scan.carpet().luminance;
  const auto luminance = static_cast<float>(frame.pixels.luminance(pixel));
  const ColourClass colour = frame.colours.of(chroma_around(frame, pixel));
  // A ball in front of the robot touches the own body in the picture.
  const bool is_body =
      colour == ColourClass::kBlue || colour == ColourClass::kRed || luminance < 0.5F * carpet;
  if (is_near && is_body) return kOwnBody;
  if (colour == ColourClass::kGreen) return 2;
  return colour == ColourClass::kNone && luminance > 1.2F * carpet ? 1 : 0;
}

double BallDetector::ground_around(const FrameTables& frame, const Ellipse& ellipse) const {
  const double major = kRingGrowth * ellipse.major + kRingMargin;
  const double minor = kRingGrowth * ellipse.minor + kRingMargin;
  const bool is_near = std::hypot(ellipse.u - centre_.u, ellipse.v - centre_.v) < near_px_;
  int ground = 0;
  int seen = 0;
  for (int i = 0; i < kRingPoints; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / kRingPoints;
    const double along = major * std::cos(turn);
    const double across = minor * std::sin(turn);
    const double cosine = std::cos(ellipse.direction);
    const double sine = std::sin(ellipse.direction);
    const double u = std::round(ellipse.u + along * cosine - across * sine);
    const double v = std::round(ellipse.v + along * sine + across * cosine);
    if (u < 0.0 || v < 0.0 || u >= frame.rays.width() || v >= frame.rays.height()) continue;
    const auto pixel =
        static_cast<std::size_t>(v) * frame.rays.width() + static_cast<std::size_t>(u);
    if (solid_angle_[pixel] <= 0.0F) continue;
    const int points = ground_points(frame, pixel, is_near);
    if (points == kOwnBody) continue;
    ++seen;
    ground += points;
  }
  return seen < kRingPoints / 4 ? 0.0 : 0.5 * ground / seen;
}

double BallDetector::expected_radius(const FrameTables& frame, double u, double v) const {
  const std::size_t pixel = static_cast<std::size_t>(std::lround(v)) * frame.rays.width() +
                            static_cast<std::size_t>(std::lround(u));
  const PixelRay& ray = frame.rays[pixel];
  const double down = -static_cast<double>(ray.direction_z);
  const double height = static_cast<double>(ray.origin_z) - ball_radius_;
  const auto solid = static_cast<double>(solid_angle_[pixel]);
  if (down <= 0.0 || height <= 0.0 || solid <= 0.0) return 0.0;
  return ball_radius_ * down / height / std::sqrt(solid);
}

bool BallDetector::are_parts(const FrameTables& frame, const Blob& a, const Blob& b) const {
  const Blob both = sum_of(a, b);
  const Ellipse whole = ellipse_of(both);
  const Ellipse one = ellipse_of(a);
  const Ellipse other = ellipse_of(b);
  const double radius = expected_radius(frame, whole.u, whole.v);
  const double seen = std::sqrt(static_cast<double>(both.pixels) / std::numbers::pi);
  return std::hypot(one.u - other.u, one.v - other.v) < kPartsApart * radius &&
         seen < kPartsTogether * radius;
}

void BallDetector::join_parts(const FrameTables& frame) {
  for (std::size_t i = 0; i < blobs_.size(); ++i) {
    const auto rest = std::remove_if(
        blobs_.begin() + static_cast<std::ptrdiff_t>(i) + 1, blobs_.end(), [&](const Blob& other) {
          if (!are_parts(frame, blobs_[i], other)) return false;
          blobs_[i] = sum_of(blobs_[i], other);
          return true;
        });
    blobs_.erase(rest, blobs_.end());
  }
}

double BallDetector::carpet_beside(const FrameTables& frame, const Ellipse& ellipse) const {
  const auto radial = frame.lines.radial();
  const double direction = std::atan2(centre_.v - ellipse.v, ellipse.u - centre_.u);
  const double middle = std::hypot(ellipse.u - centre_.u, ellipse.v - centre_.v);
  // The nearest lines on both sides: a strut may hide the one in the middle.
  double farthest = 0.0;
  for (std::size_t i = 0; i < radial.size(); ++i) {
    const double off = std::abs(angle_difference(radial[i].image_direction, direction));
    if (off > kCarpetBeside) continue;
    const std::size_t end = frame.scan.carpet_end(i);
    const auto line = frame.lines.samples(radial[i]);
    const ScanSample& last = line[std::min(end, line.size() - 1)];
    const double reach = std::hypot(static_cast<double>(last.u) - centre_.u,
                                    static_cast<double>(last.v) - centre_.v);
    farthest = std::max(farthest, reach);
  }
  if (farthest >= middle) return 1.0;
  return farthest + kCarpetMargin > middle - ellipse.minor ? kAtTheEdge : 0.1;
}

void BallDetector::judge(const FrameTables& frame, const Blob& blob) {
  if (blob.pixels < kFewestPixels || blob.solid_angle <= 0.0) return;
  const Ellipse ellipse = ellipse_of(blob);
  const double ground = ground_around(frame, ellipse) * carpet_beside(frame, ellipse);
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
  ray.confidence = 0.97 * enough * std::min(1.0, 1.8 * roundness(spread, ray.ray_R.direction)) *
                   size_fit(ray.ray_R, ray.angular_radius, ball_radius_) *
                   std::clamp((ground - kLeastGround) / kEnoughGround, 0.0, 1.0);
  if (ray.confidence < kWorthReporting) return;
  candidate.pixels = {blob.sum_u / count,
                      blob.sum_v / count,
                      std::sqrt(count / std::numbers::pi),
                      ground >= kHalfGround};
  found_.push_back(candidate);
}

void BallDetector::seed_from(const FrameTables& frame, std::size_t radial_line) {
  const ScanRange& range = frame.lines.radial()[radial_line];
  const auto taps = frame.lines.taps(range);
  const auto classes = frame.scan.classes(range);
  const std::size_t end = std::min(frame.scan.carpet_end(radial_line) + kBehind, taps.size() - 1);
  for (std::size_t i = 0; i < end; ++i) {
    // Two in a row: single pixels of noise are not worth a search.
    if (classes[i] != ColourClass::kBall || classes[i + 1] != ColourClass::kBall) continue;
    const std::size_t pixel = taps[i].nearest(frame.pixels.width());
    if (visited_[pixel] == frame_ || blobs_.size() == kMostBlobs) continue;
    const Blob blob = grow(frame, pixel);
    if (blob.pixels >= kFewestInPart) blobs_.push_back(blob);
  }
}

std::span<const BallCandidate> BallDetector::find(const FrameTables& frame) {
  ++frame_;
  found_.clear();
  blobs_.clear();
  for (std::size_t i = 0; i < frame.lines.radial().size(); ++i) seed_from(frame, i);
  join_parts(frame);
  for (const Blob& blob : blobs_) judge(frame, blob);
  std::ranges::sort(found_, [](const BallCandidate& a, const BallCandidate& b) {
    return a.ray.confidence > b.ray.confidence;
  });
  if (found_.size() > kMaxBallRays) found_.resize(kMaxBallRays);
  return found_;
}

}  // namespace teamsight::vision
