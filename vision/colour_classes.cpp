// vision/colour_classes.cpp: filling the tables, and the way back from another light.
#include "vision/colour_classes.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/LU>

#include "geometry/expect.hpp"

namespace teamsight::vision {

namespace {

ColourClass nearest_class(const ColourParameters& parameters, int u, int v) {
  ColourClass result = ColourClass::kNone;
  int nearest = std::numeric_limits<int>::max();
  for (const ColourSample& sample : parameters.samples) {
    const int du = u - sample.u;
    const int dv = v - sample.v;
    const int square = du * du + dv * dv;
    if (square > sample.radius * sample.radius || square >= nearest) continue;
    nearest = square;
    result = sample.colour;
  }
  return result;
}

bool holds(const HueSector& sector, int u, int v) {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const double du = u - 128;
  const double dv = v - 128;
  const double chroma = std::hypot(du, dv);
  if (chroma < sector.min_chroma || chroma > sector.max_chroma) return false;
  const double way = std::fmod(std::atan2(dv, du) - sector.from, kTurn);
  return (way < 0.0 ? way + kTurn : way) <= sector.to - sector.from;
}

ColourClass class_at(const ColourParameters& parameters, int u, int v) {
  const ColourClass by_sample = nearest_class(parameters, u, v);
  if (by_sample != ColourClass::kNone) return by_sample;
  for (const HueSector& sector : parameters.sectors) {
    if (holds(sector, u, v)) return sector.colour;
  }
  return ColourClass::kNone;
}

}  // namespace

ColourClasses::ColourClasses(const ColourParameters& parameters)
    : trained_(parameters.table),
      has_table_(method_of(parameters) == ColourMethod::kTable),
      white_min_y_(parameters.white_min_y),
      black_max_y_(parameters.black_max_y) {
  TEAMSIGHT_EXPECT(!has_table_ || trained_.size() == kClassCells);
  for (std::size_t i = 0; i < table_.size(); ++i) {
    table_[i] = class_at(parameters, static_cast<int>(i & 255U), static_cast<int>(i >> 8U));
  }
  if (method_of(parameters) != ColourMethod::kCube) return;
  TEAMSIGHT_EXPECT(parameters.cube.has_value());
  cube_.emplace(ColourCube::transform_of(parameters.cube->planes));
  vertex_classes_ = parameters.cube->classes;
  std::ranges::transform(vertex_classes_, vertex_colours_.begin(), [](ColourClass colour) {
    const bool has_none = colour == ColourClass::kWhite || colour == ColourClass::kBlack;
    return has_none ? ColourClass::kNone : colour;
  });
}

void ColourClasses::classify(std::span<const std::uint8_t> luminance,
                             std::span<const Chroma> chroma,
                             std::span<ColourClass> classes) const {
  const std::size_t n = classes.size();
  TEAMSIGHT_EXPECT(luminance.size() == n && chroma.size() == n);
  if (!has_table_ && !cube_) {
    for (std::size_t i = 0; i < n; ++i) classes[i] = of(chroma[i]);
    return;
  }
  for (std::size_t i = 0; i < n; ++i) {
    classes[i] = of(SampledColour{luminance[i], chroma[i].u, chroma[i].v});
  }
}

SampledColour ColourClasses::restored_glare(int y, int du, int dv) const {
  const Eigen::Array3d shown = rgb_of(y, 128 + du, 128 + dv).array();
  const Eigen::Array3d gains(gains_.red, gains_.green, gains_.blue);
  const Eigen::Array3d back = shown / gains;
  const double brightest = back.maxCoeff();
  const Eigen::Vector3d rgb = (shown > double{kBrightest}).select(brightest, back).matrix();
  const Eigen::Vector3d yuv = yuv_from_rgb() * rgb;
  const auto byte = [](double value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
  };
  return {byte(yuv.x()), byte(128.0 + yuv.y()), byte(128.0 + yuv.z())};
}

void ColourClasses::adapt(const LightGains& gains) {
  TEAMSIGHT_EXPECT(gains.red > 0.0 && gains.green > 0.0 && gains.blue > 0.0);
  gains_ = gains;
  is_adapted_ = gains != LightGains{};
  exposure_ = static_cast<float>(exposure_of(gains));
  const Eigen::Matrix3d to_yuv = yuv_from_rgb();
  const Eigen::Vector3d weaker{1.0 / gains.red, 1.0 / gains.green, 1.0 / gains.blue};
  const Eigen::Matrix3d back = to_yuv * weaker.asDiagonal() * to_yuv.inverse();
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      const double value = back(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column));
      back_[row][column] = static_cast<int>(std::lround(value * (1 << kShift)));
    }
  }
}

}  // namespace teamsight::vision
