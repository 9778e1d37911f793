// vision/ball_detector.cpp: seeds, blobs, and what makes a blob a ball.
#include "vision/ball_detector.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>

#include "vision/ball_images.hpp"
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
// Of a cone's radius: nearer to its axis is no outline, ever more strictly.
constexpr std::array<double, 3> kInterior{0.8, 0.9, 0.95};
constexpr double kSeedStep = 8.0;         // parts of the expected radius
constexpr std::size_t kMostSeedStep = 8;  // px
constexpr double kLeastSeen = 0.1;        // of a ball, for its uncertainty
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

// A ball of which a part is seen: direction and size by the cone through its outline.
//
// @return the share that is seen
double complete(const BallBlob& blob, BallRay& ray) {
  const auto cone = cone_of(blob.outline);
  if (!cone) return kLeastSeen;
  ray.ray_R = cone->axis_R;
  ray.angular_radius = cone->angular_radius;
  const double whole = 2.0 * std::numbers::pi * (1.0 - std::cos(cone->angular_radius));
  return std::clamp(blob.solid_angle / whole, kLeastSeen, 1.0);
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
      rules_(rules),
      parts_(rays, centre),
      patterned_({rules.ball_radius, rules.pattern, rules.pattern_model}, centre) {
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
    if (parts_[pixel] == MirrorParts::kInner && ray.sees_floor() &&
        std::hypot(ray.floor_x, ray.floor_y) < kNear) {
      near_px_ = std::max(near_px_, radius);
    }
    // Struts are not masked: they have no ball's colour, and a ball shows on both of their sides.
    if (is_in_rings(mask, radius) && !is_hidden(mask, {1.0 * u, 1.0 * v}) &&
        !parts_.is_seam(pixel, rays.width())) {
      solid_angle_[pixel] = solid_angle_of(rays, u, v);
    }
  }
  if (parts_.are_several()) find_seeds(rays);
}

// So close that none misses a ball on the floor.
void BallDetector::find_seeds(const RayTable& rays) {
  for (std::size_t pixel = 0; pixel < solid_angle_.size(); ++pixel) {
    if (parts_[pixel] == MirrorParts::kInner || solid_angle_[pixel] <= 0.0F) continue;
    const std::size_t column = pixel % rays.width();
    const std::size_t row = pixel / rays.width();
    const Pixel place{static_cast<double>(column), static_cast<double>(row)};
    const double radius = expected_radius(rays, rules_.ball_radius, place);
    if (radius <= 0.0) continue;
    const std::size_t step = std::bit_floor(
        std::clamp(static_cast<std::size_t>(radius / kSeedStep), std::size_t{1}, kMostSeedStep));
    if (column % step == 0 && row % step == 0) seeds_.push_back(pixel);
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
  blob.mirror_part = parts_[seed];
  if (parts_.are_several()) blob.outline = outline_of(frame.rays);
  return blob;
}

BallOutline BallDetector::outline_beyond(const RayTable& rays,
                                         const Eigen::Vector3d& axis,
                                         double angle) const {
  const std::size_t width = rays.width();
  const double most = std::cos(angle);
  BallOutline outline;
  for (const std::size_t pixel : open_) {
    bool is_edge = false;
    bool is_at_end = false;
    for (const std::size_t neighbour : {pixel - 1, pixel + 1, pixel - width, pixel + width}) {
      if (neighbour >= visited_.size() || visited_[neighbour] == visited_[pixel]) continue;
      is_edge = true;
      is_at_end = is_at_end || solid_angle_[neighbour] <= 0.0F;
    }
    const PixelRay& ray = rays[pixel];
    if (is_at_end) {
      ++outline.cut;
    } else if (is_edge &&
               axis.dot(Eigen::Vector3f(ray.direction_x, ray.direction_y, ray.direction_z)
                            .cast<double>()) < most) {
      outline.add(ray);
    }
  }
  return outline;
}

// Glare makes holes, whose edges are no outline: those lie inside the cone through all.
BallOutline BallDetector::outline_of(const RayTable& rays) const {
  BallOutline outline = outline_beyond(rays, Eigen::Vector3d::Zero(), 0.0);
  if (outline.cut == 0) return {};
  for (const double interior : kInterior) {
    const auto cone = cone_of(outline);
    if (!cone) break;
    outline = outline_beyond(rays, cone->axis_R.direction, interior * cone->angular_radius);
  }
  return outline;
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
  if (a.mirror_part != b.mirror_part) return false;
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

BallTraits BallDetector::traits_in(const FrameTables& frame, const BallBlob& blob) const {
  double near = near_px_;
  if (blob.mirror_part != MirrorParts::kInner) {
    const BlobEllipse ellipse = ellipse_of(blob);
    const PixelRay& ray = frame.rays.at(static_cast<std::uint32_t>(std::lround(ellipse.u)),
                                        static_cast<std::uint32_t>(std::lround(ellipse.v)));
    const bool is_near = ray.sees_floor() && std::hypot(ray.floor_x, ray.floor_y) < kNear;
    near = is_near ? std::numeric_limits<double>::infinity() : 0.0;
  }
  return traits_of(blob, {frame, solid_angle_, parts_, centre_, near, rules_.ball_radius});
}

BallCandidate BallDetector::candidate_of(const FrameTables& frame, const BallBlob& blob) const {
  BallCandidate candidate;
  candidate.pixels.traits = traits_in(frame, blob);
  candidate.pixels.mirror_part = blob.mirror_part;
  BallRay& ray = candidate.ray;
  const auto count = static_cast<double>(blob.pixels);
  ray.ray_R.origin = Point3<Robot>::from(blob.sum_origin / blob.solid_angle);
  ray.ray_R.direction = blob.sum_direction.normalized();
  ray.angular_radius = angular_extent_of(blob);
  double seen = 1.0;
  if (is_cut(blob)) seen = complete(blob, ray);
  const double pixel_angle = std::sqrt(blob.solid_angle / count);
  // The outline of n pixels is wrong by about a pixel of blur, and the middle by less.
  ray.sigma_angular_radius = std::max(kSizeSigma * ray.angular_radius, 0.7 * pixel_angle) / seen;
  const double sigma = (kPixelSigma * pixel_angle + 0.03 * ray.angular_radius) / seen;
  const double level = ray.ray_R.direction.head<2>().norm();
  const double sigma_azimuth = sigma / std::max(level, 0.05);
  ray.cov_direction = Eigen::Vector2d(sigma_azimuth * sigma_azimuth, sigma * sigma).asDiagonal();
  ray.colour = colour_name(blob.sum_u_chroma / count, blob.sum_v_chroma / count);
  candidate.pixels.u_px = blob.sum_u / count;
  candidate.pixels.v_px = blob.sum_v / count;
  candidate.pixels.r_px = std::sqrt(count / std::numbers::pi);
  candidate.pixels.on_carpet = candidate.pixels.traits[kInsideCarpet] > 0.0;
  return candidate;
}

void BallDetector::judge(const FrameTables& frame, const BallBlob& blob) {
  if (blob.pixels < kFewestPixels || blob.solid_angle <= 0.0) return;
  const double confidence = probability(rules_.model, traits_in(frame, blob));
  if (confidence < rules_.model.least) return;
  found_.push_back(candidate_of(frame, blob));
  found_.back().ray.confidence = confidence;
}

// All pixels whose middles lie within the disc.
BallBlob BallDetector::blob_of(const FrameTables& frame, const PatternedDisc& disc) const {
  const LocalView& view = disc.view;
  const PixelBox box = box_around(view, disc.radius, frame.rays);
  BallBlob blob;
  for (std::uint32_t row = box.first_row; row < box.end_row; ++row) {
    for (std::uint32_t column = box.first_column; column < box.end_column; ++column) {
      const Eigen::Vector2d step(column - view.middle.u, row - view.middle.v);
      const std::size_t pixel = std::size_t{row} * frame.rays.width() + column;
      if (solid_angle_[pixel] <= 0.0F || (view.to_angles * step).norm() > disc.radius) continue;
      add(frame, pixel, blob);
      blob.mirror_part = parts_[pixel];
    }
  }
  return blob;
}

void BallDetector::find_patterned(const FrameTables& frame) {
  if (!patterned_.is_any()) return;
  for (const PatternedDisc& disc : patterned_.find(frame, solid_angle_)) {
    const BallBlob blob = blob_of(frame, disc);
    if (blob.pixels < kFewestPixels || blob.solid_angle <= 0.0) continue;
    std::erase_if(found_, [&](const BallCandidate& part) {
      const LocalView& view = disc.view;
      const Eigen::Vector2d step(part.pixels.u_px - view.middle.u,
                                 part.pixels.v_px - view.middle.v);
      return (view.to_angles * step).norm() < disc.radius;
    });
    BallCandidate ball = candidate_of(frame, blob);
    ball.pixels.pattern = disc.traits;
    ball.ray.angular_radius = disc.radius;
    ball.ray.colour = BallColour::kPatterned;
    ball.ray.confidence = disc.probability;
    found_.push_back(ball);
  }
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
    start_from(frame, places[i]);
  }
}

void BallDetector::start_from(const FrameTables& frame, std::size_t pixel) {
  if (is_taken(pixel) || blobs_.size() == kMostBlobs) return;
  const BallBlob blob = grow_ball(frame, pixel);
  if (blob.pixels >= kFewestInPart) blobs_.push_back(blob);
}

void BallDetector::seed_from_further_parts(const FrameTables& frame) {
  const auto is_of_ball = [&](std::size_t pixel) {
    return frame.colours.chromatic(frame.pixels.luminance(pixel), frame.pixels.chroma(pixel)) ==
           ColourClass::kBall;
  };
  for (const std::size_t pixel : seeds_) {
    if (is_of_ball(pixel) && is_of_ball(pixel + 1)) start_from(frame, pixel);
  }
}

std::span<const BallCandidate> BallDetector::find(const FrameTables& frame) {
  frame_ += 2;
  found_.clear();
  blobs_.clear();
  for (std::size_t i = 0; i < frame.lines.radial().size(); ++i) seed_from(frame, i);
  seed_from_further_parts(frame);
  join_parts(frame.rays);
  for (const BallBlob& blob : blobs_) judge(frame, blob);
  find_patterned(frame);
  join_images(found_, rules_.ball_radius);
  std::ranges::sort(found_, [](const BallCandidate& a, const BallCandidate& b) {
    return a.ray.confidence > b.ray.confidence;
  });
  if (found_.size() > rules_.most) found_.resize(rules_.most);
  return found_;
}

}  // namespace teamsight::vision
