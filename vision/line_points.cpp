// vision/line_points.cpp: bright bumps of the right width with carpet on both sides.
#include "vision/line_points.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "vision/lanes.hpp"

namespace teamsight::vision {

namespace {

constexpr float kBlur = 1.8F;        // px: what optics and interpolation add to a narrow line
constexpr float kSteepness = 0.3F;   // of the contrast, that an edge must rise in two samples
constexpr int kBase = 4;             // samples in which the floor beside an edge is looked for
constexpr std::size_t kNarrow = 4;   // samples; no wider a bump may be as wide as it likes
constexpr std::size_t kAsk = 8;      // samples after which a bump's width is looked at
constexpr double kNarrowest = 0.45;  // of the paint's width
constexpr double kCalibrationSigma = 0.25;  // px; what the camera model may be wrong by
constexpr double kGreySigma = 4.0;          // grey levels of pixel noise
// m; what paint is no ideal line by, where it ends, bends or joins. However near, a point is not
// surer, or one that belongs to another line outvotes a whole far one.
constexpr double kPaintSigma = 0.008;

using Profile = std::span<const std::uint8_t>;
using Taps = std::span<const SampleTap>;

/// Where on the floor and in the picture the places of a profile are, counted in taps.
class Line {
 public:
  explicit Line(const ScanProfile& scan)
      : samples_(scan.samples),
        step_(1.0F / static_cast<float>(scan.pitch)) {}

  /// The sample at or before a place that is not behind the last one.
  [[nodiscard]] const ScanSample& before(float place) const { return samples_[index(place)]; }

  /// Floor point, m; beyond the line's ends theirs.
  [[nodiscard]] Eigen::Vector2d floor_at(float place) const {
    const auto last = static_cast<float>(samples_.size() - 1) / step_;
    const Eigen::Vector2f floor =
        between(std::clamp(place, 0.0F, last), &ScanSample::x, &ScanSample::y);
    return floor.cast<double>();
  }

  /// Place in the picture, px.
  [[nodiscard]] Eigen::Vector2d pixel_at(float place) const {
    return between(place, &ScanSample::u, &ScanSample::v).cast<double>();
  }

  /// Whether two places lie more than `way` metres apart on the floor.
  [[nodiscard]] bool are_apart(std::size_t a, std::size_t b, float way) const {
    const Eigen::Vector2d gap = floor_at(static_cast<float>(b)) - floor_at(static_cast<float>(a));
    return gap.squaredNorm() > static_cast<double>(way * way);
  }

 private:
  [[nodiscard]] std::size_t index(float place) const {
    return std::min(static_cast<std::size_t>(place * step_), samples_.size() - 2);
  }

  [[nodiscard]] Eigen::Vector2f between(float place,
                                        float ScanSample::*x,
                                        float ScanSample::*y) const {
    const std::size_t i = index(place);
    const float t = place * step_ - static_cast<float>(i);
    const ScanSample& a = samples_[i];
    const ScanSample& b = samples_[i + 1];
    return {a.*x + t * (b.*x - a.*x), a.*y + t * (b.*y - a.*y)};
  }

  std::span<const ScanSample> samples_;
  float step_;  // samples per tap
};

/// A bright bump; places are in taps from the line's start.
struct Bump {
  float rise{0.0F};  // edge at half height
  float fall{0.0F};
  float contrast{0.0F};
  std::size_t end{0};  // first sample after the falling edge
};

int lowest(Profile profile, std::size_t first, std::size_t last) {
  std::uint8_t least = profile[first];
  for (std::size_t i = first + 1; i <= last; ++i) least = std::min(least, profile[i]);
  return least;
}

// Where the profile crosses `level` between sample i and i + 1.
float crossing(Profile profile, std::size_t i, float level) {
  const auto here = static_cast<float>(profile[i]);
  const float step = static_cast<float>(profile[i + 1]) - here;
  const float t = std::abs(step) > 0.5F ? (level - here) / step : 0.5F;
  return static_cast<float>(i) + std::clamp(t, 0.0F, 1.0F);
}

/// How far a bump may reach, and how bright it must be.
struct BumpRules {
  float widest{0.0F};    // m of floor
  float contrast{0.0F};  // grey levels
  int rise{0};           // the least whole number of them
};

float grey(Profile profile, std::size_t i) {
  return static_cast<float>(profile[i]);
}

/// The summit behind a rising edge.
struct Summit {
  int base{0};  // of the floor before the edge, grey levels
  std::size_t top{0};
  std::size_t foot{0};  // first sample that is down again
};

// The highest sample behind the rising edge at `i`; nothing if the profile does not come down to
// half height again within `widest` metres of floor, or does not rise by the contrast.
std::optional<Summit> summit_behind(const Line& line,
                                    Profile profile,
                                    std::size_t i,
                                    const BumpRules& rules) {
  Summit summit{lowest(profile, i > kBase ? i - kBase : 0, i), i, i + 1};
  const std::size_t n = profile.size();
  int peak = profile[i];
  int twice_half = summit.base + peak;
  std::size_t& j = summit.foot;
  while (j < n && 2 * profile[j] > twice_half) {
    const std::size_t asked = std::min(j + kAsk, n);
    for (; j < asked && 2 * profile[j] > twice_half; ++j) {
      if (profile[j] <= peak) continue;
      peak = profile[j];
      summit.top = j;
      twice_half = summit.base + peak;
    }
    // A line leads away from where it was: asked now and then, and at the end.
    const std::size_t last = j - 1;
    if (last > i + kNarrow && line.are_apart(i, last, rules.widest)) return std::nullopt;
  }
  const bool is_whole = j < n && summit.top != i && peak - summit.base >= rules.rise;
  return is_whole ? std::optional(summit) : std::nullopt;
}

// The bump whose rising edge is steepest at sample `i`.
std::optional<Bump> bump_at(const Line& line,
                            Profile profile,
                            std::size_t i,
                            const BumpRules& rules) {
  const auto summit = summit_behind(line, profile, i, rules);
  if (!summit) return std::nullopt;
  const std::size_t n = profile.size();
  const float peak = profile[summit->top];
  const auto left = static_cast<float>(summit->base);
  const auto right =
      static_cast<float>(lowest(profile, summit->foot, std::min(summit->foot + kBase, n - 1)));
  const float level_left = 0.5F * (left + peak);
  const float level_right = 0.5F * (right + peak);
  std::size_t rise = summit->top;
  while (rise > 0 && grey(profile, rise - 1) > level_left) --rise;
  std::size_t fall = summit->top;
  while (fall + 1 < n && grey(profile, fall + 1) > level_right) ++fall;
  if (rise == 0 || fall + 1 >= n) return std::nullopt;
  Bump bump;
  bump.contrast = peak - std::max(left, right);
  if (bump.contrast < rules.contrast) return std::nullopt;
  bump.rise = crossing(profile, rise - 1, level_left);
  bump.fall = crossing(profile, fall, level_right);
  bump.end = fall + 1;
  return bump;
}

// Whether three samples from `first` in steps of `step` show carpet on average: chroma is noisy.
bool is_carpet(const PixelReader& pixels,
               const ColourClasses& colours,
               Taps taps,
               std::ptrdiff_t first,
               std::ptrdiff_t step) {
  int u = 0;
  int v = 0;
  int y = 0;
  int count = 0;
  for (std::ptrdiff_t k = 0; k < 3; ++k) {
    const std::ptrdiff_t i = first + k * step;
    if (i < 0 || i >= static_cast<std::ptrdiff_t>(taps.size())) continue;
    const std::size_t pixel = taps[static_cast<std::size_t>(i)].nearest(pixels.width());
    const Chroma chroma = pixels.chroma(pixel);
    u += chroma.u;
    v += chroma.v;
    y += pixels.luminance(pixel);
    ++count;
  }
  if (count < 2) return false;
  const Chroma mean{static_cast<std::uint8_t>(u / count), static_cast<std::uint8_t>(v / count)};
  const SampledColour colour = colours.restored(static_cast<std::uint8_t>(y / count), mean);
  return colours.of(colour) == ColourClass::kGreen && colour.y < colours.white_min_y();
}

bool has_carpet_beside(const PixelReader& pixels,
                       const ColourClasses& colours,
                       Taps taps,
                       const Bump& bump) {
  // One and a half pixels away from the edge the chroma of two shared pixels is the floor's.
  const auto before = static_cast<std::ptrdiff_t>(std::floor(bump.rise - 1.5F));
  const auto after = static_cast<std::ptrdiff_t>(std::ceil(bump.fall + 1.5F));
  return is_carpet(pixels, colours, taps, before, -1) && is_carpet(pixels, colours, taps, after, 1);
}

// The covariance on the floor of a place known to `sigma` pixels.
Eigen::Matrix2d spread(const ScanSample& sample, const Eigen::Vector2d& p_R, double sigma) {
  const Eigen::Vector2d away = p_R / std::max(p_R.norm(), 1e-6);
  const Eigen::Vector2d across{-away.y(), away.x()};
  const double radial = sigma * static_cast<double>(sample.radial_footprint);
  const double tangential = sigma * static_cast<double>(sample.tangential_footprint);
  return radial * radial * away * away.transpose() +
         tangential * tangential * across * across.transpose();
}

std::optional<LinePoint> point_of(const Line& line, const Bump& bump, const LineRules& rules) {
  const float middle = 0.5F * (bump.rise + bump.fall);
  const float seen = bump.fall - bump.rise;
  const float half = 0.5F * std::sqrt(std::max(0.0F, seen * seen - kBlur * kBlur));
  const Eigen::Vector2d inner = line.floor_at(middle - half);
  const Eigen::Vector2d outer = line.floor_at(middle + half);
  const double width = (outer - inner).norm();
  const double pixel = (line.floor_at(middle + 0.5F) - line.floor_at(middle - 0.5F)).norm();
  if (width > kWidestCrossing * rules.line_width + pixel) return std::nullopt;
  if (width < kNarrowest * rules.line_width - pixel) return std::nullopt;
  const Eigen::Vector2d pixel_uv = line.pixel_at(middle);
  LinePoint point;
  point.u_px = pixel_uv.x();
  point.v_px = pixel_uv.y();
  // The middle of the paint on the floor, not in the picture, which is squeezed outwards.
  point.p_R = Point<Robot>::from(0.5 * (inner + outer));
  // Two edges of a blurred step in noise: sigma_I / C * sqrt(2 sqrt(pi) blur) / sqrt(2).
  const double noise = 1.3 * kGreySigma / static_cast<double>(bump.contrast);
  point.cov_R =
      spread(line.before(middle), point.p_R.vector(), std::hypot(noise, kCalibrationSigma));
  point.cov_R.diagonal().array() += kPaintSigma * kPaintSigma;
  return point;
}

// Whether the profile rises by at least `least` about sample `i`, and nowhere steeper beside it.
bool is_rise(Profile y, std::size_t i, std::uint8_t least) {
  const int slope = y[i + 1] - y[i - 1];
  return slope >= least && slope >= y[i] - y[i - 1] && slope >= y[i + 2] - y[i];
}

// The same of sixteen samples, a bit for each.
std::uint32_t rises_at(Profile y, std::size_t i, std::uint8_t least) {
  const auto here = load_lanes<SixteenBytes>(&y[i]);
  const auto next = load_lanes<SixteenBytes>(&y[i + 1]);
  const SixteenBytes slope = excess(next, load_lanes<SixteenBytes>(&y[i - 1]));
  const SixteenBytes behind = excess(load_lanes<SixteenBytes>(&y[i + 2]), here);
  return bits_of(
      std::bit_cast<SixteenBytes>((slope >= least) & (next >= here) & (slope >= behind)));
}

// The first such sample from `i` on; where there is none, one too near to the end for any.
std::size_t next_rise(Profile y, std::size_t i, std::uint8_t least) {
  constexpr std::size_t kAtOnce = sizeof(SixteenBytes);
  for (; i + kAtOnce + 2 <= y.size(); i += kAtOnce) {
    const std::uint32_t bits = rises_at(y, i, least);
    if (bits != 0) return i + static_cast<std::size_t>(std::countr_zero(bits));
  }
  if (y.size() < kAtOnce + 3) {
    while (i + 2 < y.size() && !is_rise(y, i, least)) ++i;
    return i;
  }
  // The last ones once more, without those before `i`.
  const std::size_t first = y.size() - kAtOnce - 2;
  const std::uint32_t bits = i + 2 < y.size() ? rises_at(y, first, least) >> (i - first) : 0;
  return bits != 0 ? i + static_cast<std::size_t>(std::countr_zero(bits)) : y.size();
}

}  // namespace

void find_line_points(const PixelReader& pixels,
                      const ColourClasses& colours,
                      const ScanProfile& scan,
                      const LineRules& rules,
                      std::vector<LinePoint>& points) {
  const BumpRules bumps{static_cast<float>(2.0 * kWidestCrossing * rules.line_width),
                        static_cast<float>(rules.min_contrast),
                        static_cast<int>(std::ceil(rules.min_contrast))};
  const Line line(scan);
  const Profile y = scan.luminance;
  const auto steep = static_cast<std::uint8_t>(std::ceil(kSteepness * bumps.contrast));
  for (std::size_t i = next_rise(y, 1, steep); i + 2 < y.size() && points.size() < kMaxLinePoints;
       i = next_rise(y, i + 1, steep)) {
    const auto bump = bump_at(line, y, i, bumps);
    if (!bump) continue;
    i = std::max(i, bump->end);
    if (!has_carpet_beside(pixels, colours, scan.taps, *bump)) continue;
    if (const auto point = point_of(line, *bump, rules)) points.push_back(*point);
  }
}

}  // namespace teamsight::vision
