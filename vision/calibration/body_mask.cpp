// vision/calibration/body_mask.cpp: variance per pixel, then rings and sectors of what stays.
#include "vision/calibration/body_mask.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "vision/pixel_reader.hpp"

namespace teamsight::vision {

namespace {

constexpr std::size_t kFewestFrames = 10;
constexpr double kStill = 2.5;         // of the noise of pixels that never change
constexpr double kLeastSigma = 2.0;    // grey levels; less is rounding
constexpr double kMostlyStill = 0.75;  // of the picture: then the robot stood
constexpr double kBody = 0.85;         // of a ring, for the inner disc
constexpr double kPart = 0.6;          // of a cell, for a patch
constexpr double kStrutPart = 0.3;     // of a cell, for a strut
constexpr int kDirections = 360;       // of 1 degree
constexpr double kRing = 4.0;          // px
constexpr double kTurn = 2.0 * std::numbers::pi;

/// How much of each cell of a polar grid stays still.
class PolarShare {
 public:
  explicit PolarShare(double rim)
      : rings_(static_cast<std::size_t>(std::ceil(rim / kRing))),
        all_(rings_ * kDirections, 0),
        still_(all_.size(), 0) {}

  void add(double radius, double direction, bool is_still) {
    const double turn = direction < 0.0 ? direction + kTurn : direction;
    const auto column = std::min<std::size_t>(static_cast<std::size_t>(turn / kTurn * kDirections),
                                              kDirections - 1);
    const auto ring = static_cast<std::size_t>(radius / kRing);
    if (ring >= rings_) return;
    ++all_[ring * kDirections + column];
    if (is_still) ++still_[ring * kDirections + column];
  }

  [[nodiscard]] std::size_t rings() const { return rings_; }

  // Near the centre cells are smaller than pixels: some have none, and say nothing.
  [[nodiscard]] bool is_empty(std::size_t ring, std::size_t column) const {
    return all_[ring * kDirections + column % kDirections] == 0;
  }

  [[nodiscard]] bool is_still(std::size_t ring, std::size_t column, double part = kPart) const {
    const std::size_t i = ring * kDirections + column % kDirections;
    return all_[i] > 0 && still_[i] > part * all_[i];
  }

  [[nodiscard]] double ring_share(std::size_t ring) const {
    double all = 0.0;
    double still = 0.0;
    for (std::size_t c = 0; c < kDirections; ++c) {
      all += all_[ring * kDirections + c];
      still += still_[ring * kDirections + c];
    }
    return all > 0.0 ? still / all : 1.0;
  }

  [[nodiscard]] double share() const {
    double all = 0.0;
    double still = 0.0;
    for (const int count : all_) all += count;
    for (const int count : still_) still += count;
    return still / std::max(all, 1.0);
  }

 private:
  std::size_t rings_;
  std::vector<int> all_;
  std::vector<int> still_;
};

// Whether cells along one direction stay still from the disc to the rim. A strut need not fill its
// cells: what it hides beside its middle is lost as well. Its foot is thin and blurred: up to a
// quarter of the way may miss, and a few rings at the rim, which is half outside the mirror.
bool is_strut(const PolarShare& polar, std::size_t inner, std::size_t column) {
  constexpr std::size_t kGapAtRim = 3;  // rings
  const std::size_t way = polar.rings() - inner;
  const std::size_t longest_gap = std::max(kGapAtRim, way / 4);
  std::size_t still = 0;
  std::size_t gap = 0;
  for (std::size_t ring = inner; ring < polar.rings(); ++ring) {
    if (gap == 0 && polar.is_empty(ring, column)) continue;
    gap = polar.is_still(ring, column, kStrutPart) ? 0 : gap + 1;
    if (gap == 0) ++still;
    if (gap > longest_gap) return false;
  }
  return gap <= kGapAtRim && 2 * still > way;
}

BodyPatch patch_of(std::size_t column, std::size_t first_ring, std::size_t end_ring) {
  return {kTurn * static_cast<double>(column) / kDirections,
          kTurn * static_cast<double>(column + 1) / kDirections,
          kRing * static_cast<double>(first_ring),
          kRing * static_cast<double>(end_ring)};
}

// What stays still along one direction beyond the inner disc: a strut, or stretches of cells. A
// single ring is the edge of the disc, or chance.
std::vector<BodyPatch> stretches(const PolarShare& polar, std::size_t inner, std::size_t column) {
  std::vector<BodyPatch> found;
  if (is_strut(polar, inner, column)) {
    found.push_back(patch_of(column, inner, polar.rings()));
    found.back().is_strut = true;
    return found;
  }
  std::size_t first = inner;
  for (std::size_t ring = inner; ring <= polar.rings(); ++ring) {
    if (ring < polar.rings() && polar.is_still(ring, column)) continue;
    if (ring > first + 1) found.push_back(patch_of(column, first, ring));
    first = ring + 1;
  }
  return found;
}

// Joins each patch to its neighbour of the direction before, if they reach equally far.
void join(std::vector<BodyPatch>& patches, const BodyPatch& next) {
  constexpr double kMostTurn = 1.0;  // rad: a patch must not look like a sector of half the picture
  for (BodyPatch& patch : patches) {
    const bool touches =
        patch.is_strut == next.is_strut && std::abs(patch.to - next.from) < 1e-9 &&
        patch.inner_px <= next.inner_px + kRing && next.inner_px <= patch.inner_px + kRing &&
        std::abs(patch.outer_px - next.outer_px) <= 2.0 * kRing && next.to - patch.from < kMostTurn;
    if (!touches) continue;
    patch.to = next.to;
    patch.inner_px = std::min(patch.inner_px, next.inner_px);
    patch.outer_px = std::max(patch.outer_px, next.outer_px);
    return;
  }
  patches.push_back(next);
}

}  // namespace

BodyWatch::BodyWatch(const Pixel& centre,
                     double rim_px,
                     std::uint32_t width_px,
                     std::uint32_t height_px)
    : centre_(centre),
      rim_(rim_px),
      width_(width_px),
      height_(height_px),
      cells_(std::size_t{width_px} * height_px) {}

void BodyWatch::add(const ImageView& image) {
  const PixelReader pixels(image);
  ++frames_;
  const float share = 1.0F / static_cast<float>(frames_);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    Cell& cell = cells_[i];
    const auto y = static_cast<float>(pixels.luminance(i));
    const float off = y - cell.mean;
    cell.mean += share * off;
    cell.square += off * (y - cell.mean);
    const Chroma chroma = pixels.chroma(i);
    cell.u += static_cast<float>(chroma.u);
    cell.v += static_cast<float>(chroma.v);
  }
}

double BodyWatch::sigma(const Cell& cell) const {
  return std::sqrt(static_cast<double>(cell.square) / static_cast<double>(frames_ - 1));
}

// Of pixels that never change: the calmest twentieth of the picture is own body, or nothing is.
double BodyWatch::noise() const {
  std::vector<double> sigmas;
  for (std::size_t i = 0; i < cells_.size(); i += 7) sigmas.push_back(sigma(cells_[i]));
  const auto calm = sigmas.begin() + static_cast<std::ptrdiff_t>(sigmas.size() / 20);
  std::nth_element(sigmas.begin(), calm, sigmas.end());
  return std::max(*calm, kLeastSigma);
}

std::vector<std::uint8_t> BodyWatch::still_pixels(const ColourClasses& colours) const {
  const double limit = kStill * noise();
  const float share = 1.0F / static_cast<float>(frames_);
  std::vector<std::uint8_t> still(cells_.size(), 0);
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const Cell& cell = cells_[i];
    const Chroma mean{static_cast<std::uint8_t>(cell.u * share),
                      static_cast<std::uint8_t>(cell.v * share)};
    still[i] = sigma(cell) < limit && colours.of(mean) != ColourClass::kGreen ? 1 : 0;
  }
  return still;
}

Result<Body, BodyFailure> BodyWatch::body(const ColourClasses& colours) const {
  if (frames_ < kFewestFrames) return failure(BodyFailure::kTooFew);
  const auto still = still_pixels(colours);
  PolarShare polar(rim_);
  for (std::uint32_t v = 0; v < height_; ++v) {
    for (std::uint32_t u = 0; u < width_; ++u) {
      const double du = u - centre_.u;
      const double dv = v - centre_.v;
      polar.add(std::hypot(du, dv), std::atan2(-dv, du), still[std::size_t{v} * width_ + u] != 0);
    }
  }
  Body body;
  body.hidden_share = polar.share();
  if (body.hidden_share > kMostlyStill) return failure(BodyFailure::kNotMoving);
  std::size_t inner = 0;
  while (inner < polar.rings() && polar.ring_share(inner) > kBody) ++inner;
  body.inner_radius_px = kRing * static_cast<double>(inner);
  for (std::size_t column = 0; column < kDirections; ++column) {
    for (const BodyPatch& patch : stretches(polar, inner, column)) join(body.patches, patch);
  }
  return body;
}

}  // namespace teamsight::vision
