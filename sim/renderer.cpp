// sim/renderer.cpp: see renderer.hpp.
#include "sim/renderer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/expect.hpp"

namespace teamsight::sim {
namespace {

// A pixel's material: 0 ... 200 is carpet with so much paint, then these.
constexpr std::uint8_t kBeyond = FloorTexture::kBeyond;
constexpr std::uint8_t kBody = 202;
constexpr std::uint8_t kBall = 203;
constexpr std::size_t kMaterials = 204;

struct Yuv {
  std::uint8_t y{0};
  std::uint8_t u{128};
  std::uint8_t v{128};
};

constexpr Yuv kCarpet{87, 101, 94};
constexpr Yuv kLine{230, 128, 128};

std::uint8_t mixed(std::uint8_t from, std::uint8_t to, std::size_t share) {
  const double part = static_cast<double>(share) / FloorTexture::kPaint;
  return static_cast<std::uint8_t>(std::lround(from + part * (to - from)));
}

std::array<Yuv, kMaterials> make_palette() {
  std::array<Yuv, kMaterials> palette;
  for (std::size_t share = 0; share <= FloorTexture::kPaint; ++share) {
    palette[share] = {mixed(kCarpet.y, kLine.y, share),
                      mixed(kCarpet.u, kLine.u, share),
                      mixed(kCarpet.v, kLine.v, share)};
  }
  palette[kBeyond] = {112, 128, 128};
  palette[kBody] = {20, 128, 128};
  palette[kBall] = {139, 61, 200};
  return palette;
}

const std::array<Yuv, kMaterials> kPalette = make_palette();

constexpr std::size_t kBins = 720;
constexpr double kTwoPi = 6.283185307179586;

std::size_t bin_of(double azimuth) {
  const double turn = azimuth / kTwoPi;
  const auto bin = static_cast<std::size_t>((turn - std::floor(turn)) * kBins);
  return std::min(bin, kBins - 1);
}

std::uint8_t with_noise(std::uint8_t value, std::int8_t noise) {
  return static_cast<std::uint8_t>(std::clamp(value + noise, 0, 255));
}

// Sums of many uniform numbers: close enough to normal, and the same on every machine.
std::vector<std::int8_t> make_noise(double sigma) {
  constexpr std::size_t kCount = std::size_t{1} << 16;
  std::mt19937 random(7);
  std::vector<std::int8_t> noise(kCount);
  for (std::int8_t& value : noise) {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) {
      sum += static_cast<double>(random()) / 4294967296.0;
    }
    value = static_cast<std::int8_t>(std::clamp(std::lround(sigma * sum), -127L, 127L));
  }
  return noise;
}

}  // namespace

Renderer::Renderer(const vision::CameraParameters& camera,
                   const FieldModel& field,
                   const RenderParameters& parameters)
    : parameters_(parameters),
      width_px_(camera.width_px),
      height_px_(camera.height_px),
      format_(camera.format),
      texture_(field),
      noise_(make_noise(parameters.pixel_noise_sigma)) {
  TEAMSIGHT_EXPECT(camera.format == vision::PixelFormat::kYuyv ||
                   camera.format == vision::PixelFormat::kUyvy);
  TEAMSIGHT_EXPECT(camera.width_px % 2 == 0);
  const vision::RayTable rays(vision::CameraModel(camera), camera.width_px, camera.height_px);
  const std::uint32_t pixels = camera.width_px * camera.height_px;
  blank_.assign(pixels, kBody);  // own body inside, the mirror's holder outside
  for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
    if (rays[pixel].sees_floor()) {
      add_floor_pixel(pixel, rays[pixel]);
    } else if (rays[pixel].sees_something()) {
      blank_[pixel] = kBeyond;
    }
  }
  add_sights(rays);
  materials_ = blank_;
}

// A pixel's patch of floor is long along the line of sight and narrow across it: several narrow
// samples in a row, so that lines far away are smeared along the view only.
void Renderer::add_floor_pixel(std::uint32_t pixel, const vision::PixelRay& ray) {
  const double across = std::max<double>(ray.tangential_footprint, 0.5 * FloorTexture::kFinest);
  const double along = std::max<double>(ray.radial_footprint, across);
  const double level = std::floor(std::log2(across / FloorTexture::kFinest) + 0.5);
  const double square = FloorTexture::kFinest * std::exp2(std::max(level, 0.0));
  const int count = std::clamp(static_cast<int>(std::lround(along / square)), 1, 16);
  const double distance = std::hypot(ray.floor_x, ray.floor_y);
  floor_.push_back(
      {pixel,
       static_cast<std::uint32_t>(samples_.size()),
       static_cast<std::uint16_t>(count),
       static_cast<std::uint8_t>(std::clamp(level, 0.0, FloorTexture::kLevels - 1.0))});
  for (int i = 0; i < count; ++i) {
    const double offset = along * ((i + 0.5) / count - 0.5);
    const auto scale = static_cast<float>(1.0 + offset / std::max(distance, 1e-3));
    samples_.push_back({ray.floor_x * scale, ray.floor_y * scale});
  }
}

void Renderer::add_sights(const vision::RayTable& rays) {
  std::array<std::vector<Sight>, kBins> bins;
  for (std::uint32_t pixel = 0; pixel < blank_.size(); ++pixel) {
    const vision::PixelRay& ray = rays[pixel];
    if (!ray.sees_something()) {
      continue;
    }
    const float reach = ray.sees_floor() ? std::hypot(ray.floor_x, ray.floor_y)
                                         : std::numeric_limits<float>::infinity();
    bins[bin_of(std::atan2(ray.direction_y, ray.direction_x))].push_back({pixel,
                                                                          ray.origin_x,
                                                                          ray.origin_y,
                                                                          ray.origin_z,
                                                                          ray.direction_x,
                                                                          ray.direction_y,
                                                                          ray.direction_z,
                                                                          reach});
  }
  for (std::vector<Sight>& bin : bins) {
    std::sort(
        bin.begin(), bin.end(), [](const Sight& a, const Sight& b) { return a.reach < b.reach; });
    bin_starts_.push_back(static_cast<std::uint32_t>(sights_.size()));
    sights_.insert(sights_.end(), bin.begin(), bin.end());
  }
  bin_starts_.push_back(static_cast<std::uint32_t>(sights_.size()));
}

void Renderer::draw(const Scene& scene, std::mt19937& random, std::vector<std::uint8_t>& out) {
  std::copy(blank_.begin(), blank_.end(), materials_.begin());
  draw_floor(scene.X_FR);
  draw_standing(scene);
  develop(random, out);
}

void Renderer::draw_floor(const Pose<Field, Robot>& X_FR) {
  const auto c = static_cast<float>(std::cos(X_FR.theta()));
  const auto s = static_cast<float>(std::sin(X_FR.theta()));
  const auto x = static_cast<float>(X_FR.x());
  const auto y = static_cast<float>(X_FR.y());
  for (const FloorPixel& pixel : floor_) {
    unsigned sum = 0;
    unsigned beyond = 0;
    for (unsigned i = 0; i < pixel.samples; ++i) {
      const FloorSample& p = samples_[pixel.first_sample + i];
      const std::uint8_t paint =
          texture_.at(x + c * p.x - s * p.y, y + s * p.x + c * p.y, pixel.level);
      beyond += paint == kBeyond ? 1 : 0;
      sum += paint;
    }
    materials_[pixel.pixel] =
        2 * beyond >= pixel.samples  // there is at least one sample
            ? kBeyond
            : static_cast<std::uint8_t>(std::min<unsigned>(
                  (sum - beyond * kBeyond) / (pixel.samples - beyond), FloorTexture::kPaint));
  }
}

// From far to near: what is nearer is painted over what is behind it.
void Renderer::draw_standing(const Scene& scene) {
  const Pose<Robot, Field> X_RF = scene.X_FR.inverse();
  std::array<std::pair<double, Point<Robot>>, 32> robots;
  std::size_t count = 0;
  for (const Point<Field>& p_F : scene.others) {
    if (count < robots.size()) {
      const Point<Robot> p_R = X_RF * p_F;
      robots[count++] = {p_R.vector().norm(), p_R};
    }
  }
  std::sort(robots.begin(),
            robots.begin() + static_cast<std::ptrdiff_t>(count),
            [](const auto& a, const auto& b) { return a.first > b.first; });
  const Point3<Robot> ball = X_RF * scene.p_FB;
  const double ball_distance = ball.on_floor().vector().norm();
  bool has_ball = false;
  for (std::size_t i = 0; i < count; ++i) {
    if (!has_ball && robots[i].first < ball_distance) {
      draw_ball(ball);
      has_ball = true;
    }
    draw_robot(robots[i].second);
  }
  if (!has_ball) {
    draw_ball(ball);
  }
}

template <class Hits>
void Renderer::paint_sector(const Point<Robot>& p_R,
                            double radius,
                            std::uint8_t material,
                            Hits hits) {
  const double distance = p_R.vector().norm();
  const double middle = std::atan2(p_R.y, p_R.x);
  const double half = distance > radius ? std::asin(radius / distance) : kTwoPi / 2.0;
  // A bin more on both sides: a mirror off the axis bends lines of sight out of their bin.
  const auto bins = static_cast<std::size_t>(half / kTwoPi * 2.0 * kBins) + 5;
  const std::size_t first = bin_of(middle - half) + kBins - 2;
  const auto nearest = static_cast<float>(distance - radius);
  for (std::size_t i = 0; i < std::min(bins, kBins); ++i) {
    for (const Sight& sight : sights_beyond((first + i) % kBins, nearest)) {
      std::uint8_t& shown = materials_[sight.pixel];
      shown = hits(sight) ? material : shown;
    }
  }
}

std::span<const Renderer::Sight> Renderer::sights_beyond(std::size_t bin, float distance) const {
  const std::span<const Sight> all =
      std::span(sights_).subspan(bin_starts_[bin], bin_starts_[bin + 1] - bin_starts_[bin]);
  const auto first = std::partition_point(
      all.begin(), all.end(), [distance](const Sight& sight) { return sight.reach < distance; });
  return all.subspan(static_cast<std::size_t>(first - all.begin()));
}

void Renderer::draw_robot(const Point<Robot>& p_R) {
  const auto cx = static_cast<float>(p_R.x);
  const auto cy = static_cast<float>(p_R.y);
  const auto radius = static_cast<float>(parameters_.robot_radius);
  const auto height = static_cast<float>(parameters_.robot_height);
  paint_sector(p_R, parameters_.robot_radius, kBody, [&](const Sight& s) {
    const float dx = cx - s.origin_x;
    const float dy = cy - s.origin_y;
    const float flat = s.direction_x * s.direction_x + s.direction_y * s.direction_y;
    const float along = dx * s.direction_x + dy * s.direction_y;
    const float square = along * along - flat * (dx * dx + dy * dy - radius * radius);
    if (square < 0.0F || flat < 1e-9F) {
      return false;
    }
    const float t = (along - std::sqrt(square)) / flat;
    const float z = s.origin_z + t * s.direction_z;
    return t > 0.0F && z >= 0.0F && z <= height;
  });
}

void Renderer::draw_ball(const Point3<Robot>& p_R) {
  const auto cx = static_cast<float>(p_R.x);
  const auto cy = static_cast<float>(p_R.y);
  const auto cz = static_cast<float>(p_R.z);
  const auto radius = static_cast<float>(parameters_.ball_radius);
  paint_sector(p_R.on_floor(), parameters_.ball_radius, kBall, [&](const Sight& s) {
    const float dx = cx - s.origin_x;
    const float dy = cy - s.origin_y;
    const float dz = cz - s.origin_z;
    const float along = dx * s.direction_x + dy * s.direction_y + dz * s.direction_z;
    return along > 0.0F && dx * dx + dy * dy + dz * dz - along * along <= radius * radius;
  });
}

void Renderer::develop(std::mt19937& random, std::vector<std::uint8_t>& out) const {
  out.resize(2 * materials_.size());
  const bool is_yuyv = format_ == vision::PixelFormat::kYuyv;
  const std::size_t luminance = is_yuyv ? 0 : 1;
  const std::size_t chroma = is_yuyv ? 1 : 0;
  const std::size_t mask = noise_.size() - 1;
  std::size_t n = random();
  for (std::size_t i = 0; i < materials_.size(); i += 2) {
    if (i % 512 == 0) {
      n = random();
    }
    const Yuv& left = kPalette[materials_[i]];
    const Yuv& right = kPalette[materials_[i + 1]];
    std::uint8_t* pair = out.data() + 2 * i;
    pair[luminance] = with_noise(left.y, noise_[n++ & mask]);
    pair[luminance + 2] = with_noise(right.y, noise_[n++ & mask]);
    pair[chroma] = static_cast<std::uint8_t>((left.u + right.u + 1) / 2);
    pair[chroma + 2] = static_cast<std::uint8_t>((left.v + right.v + 1) / 2);
  }
}

}  // namespace teamsight::sim
