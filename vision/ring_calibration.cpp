// vision/ring_calibration.cpp: bumps along directions, votes for radii, circles by medians.
#include "vision/ring_calibration.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include <Eigen/Cholesky>

#include "vision/monotone_curve.hpp"
#include "vision/pixel_reader.hpp"
#include "vision/scan_lines.hpp"

namespace teamsight::vision {

namespace {

constexpr int kDirections = 720;
constexpr double kStep = 0.25;      // px along a direction
constexpr float kContrast = 12.0F;  // grey levels of a ring over both sides
constexpr double kBin = 0.5;        // px of the votes' histogram
constexpr double kNear = 3.0;       // px: a bump this near to a ring's radius is that ring's
constexpr double kApart = 2.0;      // px between two rings; nearer ones run together
constexpr int kCoarseReach = 15;    // px, of the first search for the centre
constexpr double kOneRing = 1.2;    // of the directions: more bumps than one ring can have
constexpr double kShare = 0.35;     // of the directions in which a ring must be seen
constexpr int kCentreRounds = 6;
constexpr double kMadToSigma = 1.4826;
constexpr std::size_t kFewest = 3;  // rings that make a table
// How far a ring may lie from where the others put it. Real carpets: up to 1.8 px, or 3 % of the
// way between its neighbours; the robot's edge taken for a ring: 23 px, or 24 %.
constexpr double kOff = 3.0;       // px
constexpr double kOffShare = 0.1;  // of the way between its neighbours

struct Bump {
  double direction{0.0};  // of the picture; rad
  double radius{0.0};     // px
};

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<double> radii_of(const std::vector<Bump>& bumps) {
  std::vector<double> radii(bumps.size());
  std::ranges::transform(bumps, radii.begin(), &Bump::radius);
  return radii;
}

float luminance_at(const PixelReader& pixels, double u, double v) {
  const auto column = static_cast<std::size_t>(u);
  const auto row = static_cast<std::size_t>(v);
  const auto right = static_cast<float>(u - std::floor(u));
  const auto below = static_cast<float>(v - std::floor(v));
  const std::size_t corner = row * pixels.width() + column;
  const auto y = [&](std::size_t pixel) {
    return static_cast<float>(pixels.luminance(pixel));
  };
  const float above = y(corner) + right * (y(corner + 1) - y(corner));
  const std::size_t under = corner + pixels.width();
  const float lower = y(under) + right * (y(under + 1) - y(under));
  return above + below * (lower - above);
}

std::vector<float> profile_of(const ImageView& image,
                              const PixelReader& pixels,
                              const RingRules& rules,
                              double direction) {
  std::vector<float> profile;
  for (int step = 0;; ++step) {
    const double radius = rules.inner_radius_px + kStep * step;
    const double u = rules.centre.u + radius * std::cos(direction);
    const double v = rules.centre.v - radius * std::sin(direction);
    if (u < 0.0 || v < 0.0 || u >= image.width_px - 1.0 || v >= image.height_px - 1.0) break;
    profile.push_back(luminance_at(pixels, u, v));
  }
  return profile;
}

// The middle at half height of the maximum at `top`, whose inner valley is as deep as `valley`;
// the outer one lies at or behind `after`. In samples.
double middle_of(std::span<const float> profile, std::size_t top, std::size_t after, float valley) {
  const std::size_t n = profile.size();
  std::size_t bottom = after;
  while (bottom + 1 < n && profile[bottom + 1] <= profile[bottom]) ++bottom;
  const float level = 0.5F * (profile[top] + std::max(valley, profile[bottom]));
  std::size_t inner = top;
  std::size_t outer = top;
  while (inner > 0 && profile[inner - 1] > level) --inner;
  while (outer + 1 < n && profile[outer + 1] > level) ++outer;
  return 0.5 * static_cast<double>(inner + outer);
}

// Local maxima that stand out from the valleys on both sides; the middle at half height.
void add_bumps(std::span<const float> profile,
               const RingRules& rules,
               double direction,
               std::vector<Bump>& bumps) {
  float valley = profile.empty() ? 0.0F : profile[0];
  std::size_t top = 0;
  bool rising = false;
  for (std::size_t i = 1; i < profile.size(); ++i) {
    if (!rising) {
      valley = std::min(valley, profile[i]);
      rising = profile[i] >= valley + kContrast;
      top = i;
      continue;
    }
    if (profile[i] > profile[top]) top = i;
    if (profile[i] > profile[top] - kContrast) continue;
    const double middle = middle_of(profile, top, i, valley);
    bumps.push_back({direction, rules.inner_radius_px + kStep * middle});
    valley = profile[i];
    rising = false;
  }
}

std::vector<Bump> find_bumps(const ImageView& image, const RingRules& rules) {
  const PixelReader pixels(image);
  Mask mask;
  mask.sectors = rules.sectors;
  std::vector<Bump> bumps;
  for (int i = 0; i < kDirections; ++i) {
    const double direction = 2.0 * std::numbers::pi * i / kDirections;
    if (is_masked(mask, direction)) continue;
    add_bumps(profile_of(image, pixels, rules, direction), rules, direction, bumps);
  }
  return bumps;
}

// Directions that the mask leaves.
double open_directions(const RingRules& rules) {
  Mask mask;
  mask.sectors = rules.sectors;
  int count = 0;
  for (int i = 0; i < kDirections; ++i) {
    if (!is_masked(mask, 2.0 * std::numbers::pi * i / kDirections)) ++count;
  }
  return count;
}

std::vector<double> histogram_of(const std::vector<Bump>& bumps) {
  const double largest = std::ranges::max_element(bumps, {}, &Bump::radius)->radius;
  std::vector<double> histogram(static_cast<std::size_t>(largest / kBin) + 2, 0.0);
  for (const Bump& bump : bumps) histogram[static_cast<std::size_t>(bump.radius / kBin)] += 1.0;
  return histogram;
}

// Radii at which many directions have a bump, growing.
std::vector<double> vote(const std::vector<Bump>& bumps, double directions) {
  if (bumps.empty()) return {};
  const std::vector<double> histogram = histogram_of(bumps);
  // Votes within 1 px; a ring that wobbles by that much still gathers them.
  constexpr std::ptrdiff_t kWindow = 2;
  const auto last = static_cast<std::ptrdiff_t>(histogram.size()) - 1;
  const auto votes = [&](std::ptrdiff_t bin) {
    const auto begin = histogram.begin() + std::clamp<std::ptrdiff_t>(bin - kWindow, 0, last);
    const auto end = histogram.begin() + std::clamp<std::ptrdiff_t>(bin + kWindow, 0, last) + 1;
    return std::accumulate(begin, end, 0.0);
  };
  std::vector<double> found;
  for (std::ptrdiff_t bin = 0; bin <= last; ++bin) {
    const double here = votes(bin);
    if (here < kShare * directions || here < votes(bin - 1) || here <= votes(bin + 1)) continue;
    const double radius = (static_cast<double>(bin) + 0.5) * kBin;
    if (found.empty() || radius - found.back() >= kApart) found.push_back(radius);
  }
  return found;
}

// How few radii gather the bumps when the centre is moved by `shift`; more is better.
double sharpness(const std::vector<Bump>& bumps, const Pixel& shift, std::vector<Bump>& moved) {
  std::ranges::transform(bumps, moved.begin(), [&](const Bump& bump) {
    return Bump{bump.direction,
                std::hypot(bump.radius * std::cos(bump.direction) - shift.u,
                           bump.radius * std::sin(bump.direction) + shift.v)};
  });
  const std::vector<double> histogram = histogram_of(moved);
  return std::inner_product(histogram.begin(), histogram.end(), histogram.begin(), 0.0);
}

// The shift of the centre, in whole pixels, that gathers the bumps in the fewest radii.
Pixel coarse_shift(const std::vector<Bump>& bumps) {
  Pixel best;
  double best_sharpness = 0.0;
  std::vector<Bump> moved(bumps);
  for (int du = -kCoarseReach; du <= kCoarseReach; ++du) {
    for (int dv = -kCoarseReach; dv <= kCoarseReach; ++dv) {
      const Pixel shift{static_cast<double>(du), static_cast<double>(dv)};
      const double here = sharpness(bumps, shift, moved);
      if (here > best_sharpness) best = shift;
      best_sharpness = std::max(best_sharpness, here);
    }
  }
  return best;
}

// The bumps that belong to the ring at `radius`.
std::vector<Bump> ring_bumps(const std::vector<Bump>& bumps,
                             const std::vector<double>& radii,
                             double radius) {
  std::vector<Bump> mine;
  std::ranges::copy_if(bumps, std::back_inserter(mine), [&](const Bump& bump) {
    // Outwards the rings crowd: a bump belongs to the nearest one only.
    const double off = std::abs(bump.radius - radius);
    return off < kNear && std::ranges::none_of(radii, [&](double other) {
             return std::abs(bump.radius - other) < off;
           });
  });
  return mine;
}

// A ring that wobbles may win votes at two radii, each in its own directions; two rings are both
// seen in the same directions. Joins the former.
std::vector<double> join_halves(std::vector<double> radii,
                                const std::vector<Bump>& bumps,
                                double directions) {
  for (std::size_t k = 0; k + 1 < radii.size();) {
    const std::size_t seen =
        ring_bumps(bumps, radii, radii[k]).size() + ring_bumps(bumps, radii, radii[k + 1]).size();
    const bool is_one =
        radii[k + 1] - radii[k] < 2.0 * kNear && static_cast<double>(seen) < kOneRing * directions;
    if (is_one) {
      radii[k] = 0.5 * (radii[k] + radii[k + 1]);
      radii.erase(radii.begin() + static_cast<std::ptrdiff_t>(k + 1));
    } else {
      ++k;
    }
  }
  return radii;
}

// Moves the centre so that every ring's radius is the same in all directions: least squares of
// radius = r_k + a cos + b sin over the bumps near the rings, with far ones weighted down.
Pixel centre_shift(const std::vector<Bump>& bumps, const std::vector<double>& radii) {
  Eigen::Matrix2d normal = 1e-9 * Eigen::Matrix2d::Identity();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (const double radius : radii) {
    const auto mine = ring_bumps(bumps, radii, radius);
    if (mine.size() < 10) continue;
    const double middle = median(radii_of(mine));
    for (const Bump& bump : mine) {
      const Eigen::Vector2d along{std::cos(bump.direction), std::sin(bump.direction)};
      const double off = bump.radius - middle;
      const double weight = 1.0 / (1.0 + off * off);
      normal += weight * along * along.transpose();
      right += weight * off * along;
    }
  }
  const Eigen::Vector2d shift = normal.ldlt().solve(right);
  return {shift.x(), -shift.y()};
}

FoundRing measure(const std::vector<Bump>& bumps,
                  const std::vector<double>& radii,
                  double radius,
                  double distance) {
  const std::vector<double> own = radii_of(ring_bumps(bumps, radii, radius));
  FoundRing ring;
  ring.directions = own.size();
  ring.mark.distance = distance;
  ring.mark.radius_px = median(own);
  std::vector<double> off(own.size());
  std::ranges::transform(
      own, off.begin(), [&](double r) { return std::abs(r - ring.mark.radius_px); });
  ring.mark.sigma_px = std::max(0.05, kMadToSigma * median(off));
  // Neighbouring directions share their pixels: about one independent look per 4 degrees.
  const double looks = std::max(1.0, static_cast<double>(own.size()) / 8.0);
  ring.sigma_mean_px = 1.2533 * ring.mark.sigma_px / std::sqrt(looks);
  return ring;
}

// What the other rings say about each ring's radius, through the same curve that a camera uses.
void leave_one_out(std::vector<FoundRing>& rings, double height) {
  for (std::size_t k = 0; k < rings.size(); ++k) {
    std::vector<Knot> knots{{0.0, 0.0}};
    for (std::size_t i = 0; i < rings.size(); ++i) {
      if (i == k) continue;
      knots.push_back({rings[i].mark.radius_px, std::atan2(rings[i].mark.distance, height)});
    }
    const MonotoneCurve curve(std::move(knots));
    const double angle = std::atan2(rings[k].mark.distance, height);
    // The outermost ring has no neighbour outside; it would be an extrapolation.
    rings[k].left_out_px =
        k + 1 < rings.size() ? curve.inverse(angle) - rings[k].mark.radius_px : 0.0;
  }
}

// The k-th radius with the k-th distance.
std::vector<FoundRing> pair_up(const std::vector<Bump>& bumps,
                               const std::vector<double>& radii,
                               const RingRules& rules) {
  std::vector<FoundRing> rings;
  const std::size_t count = std::min(radii.size(), rules.distances.size());
  for (std::size_t k = 0; k < count; ++k) {
    rings.push_back(measure(bumps, radii, radii[k], rules.distances[k]));
  }
  leave_one_out(rings, rules.mirror_height);
  return rings;
}

// How far the ring lies off, as a share of what it may.
double strain(const std::vector<FoundRing>& rings, std::size_t k) {
  if (k + 1 >= rings.size()) return 0.0;
  const double inner = k > 0 ? rings[k - 1].mark.radius_px : 0.0;
  const double way = rings[k + 1].mark.radius_px - inner;
  return std::abs(rings[k].left_out_px) / std::max(kOff, kOffShare * way);
}

std::size_t most_strained(const std::vector<FoundRing>& rings) {
  std::size_t worst = 0;
  for (std::size_t k = 1; k < rings.size(); ++k) {
    if (strain(rings, k) > strain(rings, worst)) worst = k;
  }
  return worst;
}

// Looks for the one ring, or the one distance, without which all agree best.
std::optional<RingDoubt> doubt_of(const std::vector<FoundRing>& rings,
                                  const std::vector<Bump>& bumps,
                                  const std::vector<double>& radii,
                                  const RingRules& rules) {
  const std::size_t worst = most_strained(rings);
  if (strain(rings, worst) <= 1.0) return std::nullopt;
  RingDoubt doubt{RingTrouble::kUnclear, worst};
  double best = 1.0;
  const auto consider = [&](const std::vector<FoundRing>& without, const RingDoubt& reason) {
    if (without.size() < kFewest) return;
    const double left = strain(without, most_strained(without));
    if (left < best) doubt = reason;
    best = std::min(best, left);
  };
  for (std::size_t k = 0; k < rings.size(); ++k) {
    const auto at = static_cast<std::ptrdiff_t>(k);
    std::vector<double> fewer = radii;
    fewer.erase(fewer.begin() + at);
    consider(pair_up(bumps, fewer, rules), {RingTrouble::kNoRing, k});
    RingRules shorter = rules;
    shorter.distances.erase(shorter.distances.begin() + at);
    consider(pair_up(bumps, radii, shorter), {RingTrouble::kMissing, k});
  }
  return doubt;
}

}  // namespace

Result<RingCalibration, RingFailure> calibrate_rings(const ImageView& image,
                                                     const RingRules& guess) {
  if (image.format != PixelFormat::kGrey || !is_whole(image)) {
    return failure(RingFailure::kNotGrey);
  }
  RingRules rules = guess;
  const double directions = open_directions(rules);
  std::vector<Bump> bumps = find_bumps(image, rules);
  if (bumps.empty()) return failure(RingFailure::kTooFew);
  const Pixel coarse = coarse_shift(bumps);
  rules.centre = {rules.centre.u + coarse.u, rules.centre.v + coarse.v};
  std::vector<double> radii;
  for (int round = 0; round < kCentreRounds; ++round) {
    bumps = find_bumps(image, rules);
    radii = join_halves(vote(bumps, directions), bumps, directions);
    if (radii.empty()) return failure(RingFailure::kTooFew);
    const Pixel shift = centre_shift(bumps, radii);
    rules.centre = {rules.centre.u + shift.u, rules.centre.v + shift.v};
    if (std::hypot(shift.u, shift.v) < 0.01) break;
  }
  RingCalibration result{rules.centre, pair_up(bumps, radii, rules), {}};
  if (result.rings.size() < kFewest) return failure(RingFailure::kTooFew);
  result.doubt = doubt_of(result.rings, bumps, radii, rules);
  return result;
}

}  // namespace teamsight::vision
