// vision/ball_traits.cpp: size for its place, shape, and the ring around a blob.
#include "vision/ball_traits.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "geometry/angle.hpp"

namespace teamsight::vision {

namespace {

constexpr int kRingPoints = 24;          // around a blob
constexpr double kRingGrowth = 1.45;     // of the ring over the blob's ellipse
constexpr double kRingMargin = 2.0;      // px
constexpr double kBeside = 0.06;         // rad, to radial lines that show where the carpet ends
constexpr double kPixels = 20.0;         // that lengths in the image are counted in
constexpr double kMostInside = 2.0;      // of those; more says no more
constexpr double kOddest = 2.0;          // of a size's logarithm: seen from where no ball can be
constexpr float kBodyLuminance = 0.5F;   // of the carpet's
constexpr float kPaintLuminance = 1.2F;  // of the carpet's

/// What is seen around a blob.
struct Ring {
  double points{0.0};  // that the own body does not hide
  double ground{0.0};
  double u_chroma{0.0};  // sums
  double v_chroma{0.0};
};

// Mean over the pixel and its eight neighbours: a single one is noisy.
Chroma chroma_around(const PixelReader& pixels, std::size_t pixel) {
  const std::size_t width = pixels.width();
  unsigned u = 0;
  unsigned v = 0;
  for (const std::size_t row : {pixel - width, pixel, pixel + width}) {
    for (const std::size_t place : {row - 1, row, row + 1}) {
      const Chroma chroma = pixels.chroma(place);
      u += chroma.u;
      v += chroma.v;
    }
  }
  return {static_cast<std::uint8_t>(u / 9), static_cast<std::uint8_t>(v / 9)};
}

void look_at(std::size_t pixel, bool is_near, const FrameTables& frame, Ring& ring) {
  const float carpet = frame.scan.carpet().luminance;
  const std::uint8_t y = frame.pixels.luminance(pixel);
  const auto luminance = static_cast<float>(y);
  const Chroma chroma = chroma_around(frame.pixels, pixel);
  const ColourClass colour = frame.colours.chromatic(y, chroma);
  // A ball in front of the robot touches the own body in the picture.
  const bool is_body = colour == ColourClass::kBlue || colour == ColourClass::kRed ||
                       luminance < kBodyLuminance * carpet;
  if (is_near && is_body) return;
  ring.points += 1.0;
  ring.u_chroma += chroma.u;
  ring.v_chroma += chroma.v;
  if (colour == ColourClass::kGreen) ring.ground += 1.0;
  if (colour == ColourClass::kNone && luminance > kPaintLuminance * carpet) ring.ground += 0.5;
}

Ring ring_around(const BlobEllipse& ellipse, std::uint8_t part, const BallTraitSource& source) {
  const FrameTables& frame = source.frame;
  const double major = kRingGrowth * ellipse.major + kRingMargin;
  const double minor = kRingGrowth * ellipse.minor + kRingMargin;
  const double cosine = std::cos(ellipse.direction);
  const double sine = std::sin(ellipse.direction);
  const double reach = std::hypot(ellipse.u - source.centre.u, ellipse.v - source.centre.v);
  Ring ring;
  for (int i = 0; i < kRingPoints; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / kRingPoints;
    const double along = major * std::cos(turn);
    const double across = minor * std::sin(turn);
    const double u = std::round(ellipse.u + along * cosine - across * sine);
    const double v = std::round(ellipse.v + along * sine + across * cosine);
    // All eight neighbours are in the image.
    if (u < 1.0 || v < 1.0 || u + 1.0 >= frame.rays.width() || v + 1.0 >= frame.rays.height()) {
      continue;
    }
    const auto pixel =
        static_cast<std::size_t>(v) * frame.rays.width() + static_cast<std::size_t>(u);
    if (source.solid_angle[pixel] <= 0.0F || source.parts[pixel] != part) continue;
    look_at(pixel, reach < source.near_px, frame, ring);
  }
  return ring;
}

// How far from the centre the inner part of the mirror shows the floor that a pixel sees; px.
double inner_radius(const PixelRay& ray, std::span<const ScanSample> line, const Pixel& centre) {
  if (!ray.sees_floor()) return std::numeric_limits<double>::infinity();
  const float distance = std::hypot(ray.floor_x, ray.floor_y);
  const auto place = std::ranges::partition_point(
      line, [&](const ScanSample& sample) { return std::hypot(sample.x, sample.y) < distance; });
  const ScanSample& sample = place == line.end() ? line.back() : *place;
  return std::hypot(static_cast<double>(sample.u) - centre.u,
                    static_cast<double>(sample.v) - centre.v);
}

// From the blob's middle outwards to the end of the carpet's hull; px of scale 1.
double inside_carpet(const BlobEllipse& ellipse, std::uint8_t part, const BallTraitSource& source) {
  const ScanLines& lines = source.frame.lines;
  const auto radial = lines.radial();
  const double u = ellipse.u - source.centre.u;
  const double v = ellipse.v - source.centre.v;
  const double direction = std::atan2(-v, u);
  const PixelRay& middle = source.frame.rays.at(static_cast<std::uint32_t>(std::lround(ellipse.u)),
                                                static_cast<std::uint32_t>(std::lround(ellipse.v)));
  // The nearest lines on both sides: a strut may hide the one in the middle.
  double farthest = 0.0;
  double radius = std::hypot(u, v);
  for (std::size_t i = 0; i < radial.size(); ++i) {
    if (std::abs(angle_difference(radial[i].image_direction, direction)) > kBeside) continue;
    const auto line = lines.samples(radial[i]);
    const ScanSample& last = line[std::min(source.frame.hull.end(i), line.size() - 1)];
    farthest = std::max(farthest,
                        std::hypot(static_cast<double>(last.u) - source.centre.u,
                                   static_cast<double>(last.v) - source.centre.v));
    if (part != MirrorParts::kInner) radius = inner_radius(middle, line, source.centre);
  }
  return (farthest - radius) / static_cast<double>(lines.scale());
}

// Logarithm of the blob's radius over that of a ball on the floor there.
double odd_size(const BallBlob& blob, const BlobEllipse& ellipse, const BallTraitSource& source) {
  const double expected =
      expected_radius(source.frame.rays, source.ball_radius, {ellipse.u, ellipse.v});
  if (expected <= 0.0) return kOddest;
  const double seen = std::sqrt(static_cast<double>(blob.pixels) / std::numbers::pi);
  return std::clamp(std::log(seen / expected), -kOddest, kOddest);
}

// The same of a ball of which a part is seen.
double odd_size(const std::optional<BallCone>& cone, double ball_radius) {
  const double expected = cone ? angular_radius_on_floor(cone->axis_R, ball_radius) : 0.0;
  if (expected <= 0.0) return kOddest;
  return std::clamp(std::log(cone->angular_radius / expected), -kOddest, kOddest);
}

}  // namespace

double expected_radius(const RayTable& rays, double ball_radius, const Pixel& middle) {
  const auto u = static_cast<std::uint32_t>(std::lround(middle.u));
  const auto v = static_cast<std::uint32_t>(std::lround(middle.v));
  const PixelRay& ray = rays.at(u, v);
  const double down = -static_cast<double>(ray.direction_z);
  const double height = static_cast<double>(ray.origin_z) - ball_radius;
  const auto solid = static_cast<double>(solid_angle_of(rays, u, v));
  if (down <= 0.0 || height <= 0.0 || solid <= 0.0) return 0.0;
  return ball_radius * down / height / std::sqrt(solid);
}

BallTraits traits_of(const BallBlob& blob, const BallTraitSource& source) {
  const BlobEllipse ellipse = ellipse_of(blob);
  const Ring ring = ring_around(ellipse, blob.mirror_part, source);
  double size = odd_size(blob, ellipse, source);
  double roundness = roundness_of(blob);
  if (is_cut(blob)) {
    const auto cone = cone_of(blob.outline);
    size = odd_size(cone, source.ball_radius);
    roundness = cone ? std::max(0.0, 1.0 - 2.0 * cone->sigma / cone->angular_radius) : 0.0;
  }
  const double small = std::min(0.0, size);
  const double large = std::max(0.0, size);
  const auto count = static_cast<double>(blob.pixels);
  double ground = 0.0;
  double contrast = 0.0;
  if (4.0 * ring.points >= kRingPoints) {
    ground = ring.ground / ring.points;
    contrast = std::hypot(blob.sum_u_chroma / count - ring.u_chroma / ring.points,
                          blob.sum_v_chroma / count - ring.v_chroma / ring.points);
  }
  return {
      small * small,
      large * large,
      roundness,
      ground,
      std::clamp(
          inside_carpet(ellipse, blob.mirror_part, source) / kPixels, -kMostInside, kMostInside),
      std::log(std::max(1.0, contrast))};
}

}  // namespace teamsight::vision
