// vision/patterned_balls.cpp: where to look, and what is kept.
#include "vision/patterned_balls.hpp"

#include <algorithm>
#include <cmath>

#include "vision/lanes.hpp"

namespace teamsight::vision {

namespace {

constexpr std::size_t kMostTried = 256;  // places looked at in one frame
constexpr std::size_t kMostFound = 16;   // of these kept
constexpr double kApart = 0.7;           // of the expected radius, between places looked at
constexpr float kWindow = 2.0F;          // expected radii, between two of its colours
constexpr float kLowest = 1.5F;          // expected radii, of a ball across a radial line
constexpr float kHighest = 2.6F;
constexpr float kNowhere = 1e9F;  // expected radii, where no ball can be
constexpr double kSame = 0.7;     // of the radius: two discs so near are one ball

double distance_between(const Pixel& a, const Pixel& b) {
  return std::hypot(a.u - b.u, a.v - b.v);
}

// Lines that run across are lower, what is higher is no ball alone.
bool is_as_high_as_a_ball(float radii) {
  return radii > kLowest && radii < kHighest;
}

// Whether there was one of the ball's colours before, and another.
bool is_other(ColourClass before, ColourClass colour) {
  return before != ColourClass::kNone && before != colour;
}

// The first sample behind `i` that is no carpet.
std::size_t carpet_end(std::span<const Surface> surfaces, std::size_t i) {
  ++i;
  i += leading_eights(surfaces.subspan(i), Surface::kCarpet);
  while (i < surfaces.size() && surfaces[i] == Surface::kCarpet) ++i;
  return i;
}

bool are_same(const PatternedDisc& a, const PatternedDisc& b) {
  const Eigen::Vector2d step(b.view.middle.u - a.view.middle.u, b.view.middle.v - a.view.middle.v);
  return (a.view.to_angles * step).norm() < kSame * std::max(a.radius, b.radius);
}

}  // namespace

PatternedBalls::PatternedBalls(const PatternRules& rules, const Pixel& centre)
    : rules_(rules),
      pattern_(rules.classes),
      centre_(centre) {
  for (std::size_t i = 0; i < kColourClasses; ++i) {
    for (std::size_t k = 0; k < kSurfaces; ++k) {
      own_[i][k] = own_class(static_cast<ColourClass>(i), static_cast<Surface>(k));
    }
  }
  tried_.reserve(kMostTried);
  found_.reserve(kMostFound);
}

std::span<const PatternedDisc> PatternedBalls::find(const FrameTables& frame,
                                                    std::span<const float> solid_angle) {
  tried_.clear();
  found_.clear();
  if (radius_px_.empty()) measure_radii(frame, solid_angle);
  for (std::size_t i = 0; i < frame.lines.radial().size(); ++i) look_along(frame, solid_angle, i);
  return found_;
}

ColourClass PatternedBalls::own_class(ColourClass chromatic, Surface surface) const {
  ColourClass colour = chromatic;
  if (chromatic == ColourClass::kNone || !pattern_.has(chromatic)) {
    if (surface == Surface::kDark) {
      colour = ColourClass::kBlack;
    } else if (chromatic == ColourClass::kNone && surface == Surface::kPaint) {
      colour = ColourClass::kWhite;
    }
  }
  return pattern_.has(colour) ? colour : ColourClass::kNone;
}

void PatternedBalls::look_along(const FrameTables& frame,
                                std::span<const float> solid_angle,
                                std::size_t radial_line) {
  const ScanRange& range = frame.lines.radial()[radial_line];
  const auto surfaces = frame.scan.surfaces(range);
  const auto classes = frame.scan.classes(range);
  const std::size_t end = std::min(frame.hull.end(radial_line), surfaces.size());
  ColourClass last = ColourClass::kNone;  // of the ball's, since the carpet
  std::size_t last_at = 0;
  std::size_t bare_from = 0;  // since the carpet
  for (std::size_t i = 0; i < end; ++i) {
    if (surfaces[i] == Surface::kCarpet) {
      if (last != ColourClass::kNone) {
        look_at_whole(frame, solid_angle, {radial_line, bare_from, i});
        last = ColourClass::kNone;
      }
      bare_from = carpet_end(surfaces.first(end), i);
      i = bare_from - 1;
      continue;
    }
    const ColourClass colour =
        own_[static_cast<std::size_t>(classes[i])][static_cast<std::size_t>(surfaces[i])];
    if (colour == ColourClass::kNone) continue;
    if (is_other(last, colour) && is_near(range, last_at, bare_from, i)) {
      look_at(frame, solid_angle, {radial_line, last_at, i});
    }
    last = colour;
    last_at = i;
  }
}

void PatternedBalls::look_at_whole(const FrameTables& frame,
                                   std::span<const float> solid_angle,
                                   const Stretch& stretch) {
  const ScanRange& range = frame.lines.radial()[stretch.line];
  if (!is_as_high_as_a_ball(apart(range, stretch.from, stretch.to))) return;
  look_at(frame, solid_angle, stretch);
}

bool PatternedBalls::is_near(const ScanRange& range,
                             std::size_t first,
                             std::size_t bare_from,
                             std::size_t second) const {
  // It stands on the carpet: that ends not far in front of it.
  return apart(range, first, second) < kWindow && apart(range, bare_from, second) < kHighest;
}

void PatternedBalls::measure_radii(const FrameTables& frame, std::span<const float> solid_angle) {
  for (const ScanRange& range : frame.lines.radial()) {
    const auto pixels = frame.lines.pixels(range);
    radius_px_.resize(std::max(radius_px_.size(), range.first + range.count), 0.0F);
    for (std::size_t i = 0; i < range.count; ++i) {
      const float solid = solid_angle[pixels[i]];
      const double radius = angular_radius_at(frame.rays[pixels[i]], rules_.ball_radius);
      radius_px_[range.first + i] =
          solid > 0.0F ? static_cast<float>(radius) / std::sqrt(solid) : 0.0F;
    }
  }
}

float PatternedBalls::apart(const ScanRange& range, std::size_t from, std::size_t to) const {
  const float radius_px = radius_px_[range.first + (from + to) / 2];
  return radius_px > 0.0F ? static_cast<float>((to - from) * range.pitch) / radius_px : kNowhere;
}

void PatternedBalls::look_at(const FrameTables& frame,
                             std::span<const float> solid_angle,
                             const Stretch& stretch) {
  const ScanRange& range = frame.lines.radial()[stretch.line];
  const std::size_t sample = (stretch.from + stretch.to) / 2;
  const std::size_t pixel = frame.lines.pixels(range)[sample];
  if (tried_.size() == kMostTried) return;
  const auto radius_px = static_cast<double>(radius_px_[range.first + sample]);
  const std::size_t row = pixel / frame.rays.width();
  const std::size_t column = pixel % frame.rays.width();
  const Pixel place{static_cast<double>(column), static_cast<double>(row)};
  const bool is_known = std::ranges::any_of(tried_, [&](const Pixel& tried) {
    return distance_between(tried, place) < kApart * radius_px;
  });
  if (is_known) return;
  tried_.push_back(place);
  const float carpet = frame.scan.carpet_beside(range, sample);
  const auto disc = disc_around(
      {frame, solid_angle, pattern_, rules_.model, centre_, rules_.ball_radius, place, carpet});
  if (disc) keep(*disc);
}

void PatternedBalls::keep(const PatternedDisc& disc) {
  const auto same = std::ranges::find_if(
      found_, [&](const PatternedDisc& other) { return are_same(disc, other); });
  if (same == found_.end()) {
    if (found_.size() < kMostFound) found_.push_back(disc);
  } else if (same->probability < disc.probability) {
    *same = disc;
  }
}

}  // namespace teamsight::vision
