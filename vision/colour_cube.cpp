// vision/colour_cube.cpp: three planes in fixed point, and the signs of eight pixels at once.
#include "vision/colour_cube.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

#include <Eigen/LU>

#include "geometry/expect.hpp"
#include "vision/lanes.hpp"
#include "vision/light_gains.hpp"
#include "vision/pixel_reader.hpp"

namespace teamsight::vision {

namespace {

constexpr double kMost = 32000.0;  // of a value in fixed point; what is left is for rounding
constexpr double kMiddle = 128.0;  // grey levels; there rounding the weights moves nothing
constexpr double kLargest = 255.0;
constexpr std::size_t kEight = 2 * kLanes;

using Row = Eigen::RowVector4d;

ColourCube::Plane plane_of(const Row& row) {
  const Eigen::RowVector3d weights = row.head<3>();
  TEAMSIGHT_EXPECT(row.allFinite() && !weights.isZero(0.0));
  // The largest value of any colour, of either sign.
  const double bright = row(3) + kLargest * weights.cwiseMax(0.0).sum();
  const double dark = row(3) + kLargest * weights.cwiseMin(0.0).sum();
  const double scale = kMost / std::max({std::abs(bright), std::abs(dark), std::abs(row(3))});
  ColourCube::Plane plane;
  double middle = scale * (row(3) + kMiddle * weights.sum());
  for (Eigen::Index i = 0; i < weights.size(); ++i) {
    const double weight = std::round(scale * weights(i));
    plane.weights[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(weight);
    middle -= kMiddle * weight;
  }
  plane.offset = static_cast<std::int16_t>(std::lround(middle));
  return plane;
}

ColourCube::Planes planes_of(const ColourCube::Transform& transform) {
  return {plane_of(transform.row(0)), plane_of(transform.row(1)), plane_of(transform.row(2))};
}

// The transform of (b, g, r, 1) instead.
ColourCube::Transform from_bgr(const ColourCube::Transform& from_yuv) {
  ColourCube::Transform transform = from_yuv;
  const Eigen::Matrix3d weights = from_yuv.leftCols<3>() * yuv_from_rgb();
  transform.leftCols<3>() = weights.rowwise().reverse();
  transform.col(3) += kMiddle * (from_yuv.col(1) + from_yuv.col(2));
  return transform;
}

EightHalves all(std::int16_t value) {
  return EightHalves{} + static_cast<std::uint16_t>(value);
}

// `first` in the even lanes and `second` in the odd ones.
EightHalves in_turn(std::int16_t first, std::int16_t second) {
  const auto a = static_cast<std::uint16_t>(first);
  const auto b = static_cast<std::uint16_t>(second);
  return EightHalves{a, b, a, b, a, b, a, b};
}

// In arithmetic modulo 2^16 only the result must fit, and it does.
EightHalves bit_of(const EightHalves& value, std::uint16_t bit) {
  const EightShorts is_bright = std::bit_cast<EightShorts>(value) > 0;
  return std::bit_cast<EightHalves>(is_bright) & bit;
}

/// A plane for pixels that share u and v in twos.
struct PairedPlane {
  explicit PairedPlane(const ColourCube::Plane& plane)
      : luminance(all(plane.weights[0])),
        chroma(in_turn(plane.weights[1], plane.weights[2])),
        offset(all(plane.offset)) {}

  // `pairs`: u and v in turn.
  [[nodiscard]] EightHalves value(const EightHalves& y, const EightHalves& pairs) const {
    const EightHalves parts = pairs * chroma;
    return luminance * y + parts + offset +
           __builtin_shufflevector(parts, parts, 1, 0, 3, 2, 5, 4, 7, 6);
  }

  EightHalves luminance;
  EightHalves chroma;
  EightHalves offset;
};

/// A plane for pixels of three channels.
struct SinglePlane {
  explicit SinglePlane(const ColourCube::Plane& plane)
      : a(all(plane.weights[0])),
        b(all(plane.weights[1])),
        c(all(plane.weights[2])),
        offset(all(plane.offset)) {}

  [[nodiscard]] EightHalves value(const EightHalves& first,
                                  const EightHalves& second,
                                  const EightHalves& third) const {
    return a * first + b * second + c * third + offset;
  }

  EightHalves a;
  EightHalves b;
  EightHalves c;
  EightHalves offset;
};

void store_vertices(const EightHalves& red,
                    const EightHalves& green,
                    const EightHalves& blue,
                    std::uint8_t* to) {
  const EightHalves vertices = bit_of(red, 1) | bit_of(green, 2) | bit_of(blue, 4);
  store_lanes(__builtin_convertvector(vertices, EightBytes), to);
}

// Of YUYV or, `kIsYuyv` being false, UYVY; returns how many pixels were segmented.
template <bool kIsYuyv>
std::size_t segment_pairs(const ColourCube::Planes& planes,
                          const std::uint8_t* bytes,
                          std::span<std::uint8_t> vertices) {
  const PairedPlane red(planes[0]);
  const PairedPlane green(planes[1]);
  const PairedPlane blue(planes[2]);
  std::size_t i = 0;
  for (; i + kEight <= vertices.size(); i += kEight) {
    const auto words = load_lanes<EightHalves>(bytes + 2 * i);
    const EightHalves y = kIsYuyv ? words & 0xFFU : words >> 8U;
    const EightHalves pairs = kIsYuyv ? words >> 8U : words & 0xFFU;
    store_vertices(red.value(y, pairs), green.value(y, pairs), blue.value(y, pairs), &vertices[i]);
  }
  return i;
}

EightHalves every_third(const std::uint8_t* p) {
  return EightHalves{p[0], p[3], p[6], p[9], p[12], p[15], p[18], p[21]};
}

// Returns how many pixels were segmented.
std::size_t segment_bgr(const ColourCube::Planes& planes,
                        const std::uint8_t* bytes,
                        std::span<std::uint8_t> vertices) {
  const SinglePlane red(planes[0]);
  const SinglePlane green(planes[1]);
  const SinglePlane blue(planes[2]);
  std::size_t i = 0;
  for (; i + kEight <= vertices.size(); i += kEight) {
    const EightHalves b = every_third(bytes + 3 * i);
    const EightHalves g = every_third(bytes + 3 * i + 1);
    const EightHalves r = every_third(bytes + 3 * i + 2);
    store_vertices(red.value(b, g, r), green.value(b, g, r), blue.value(b, g, r), &vertices[i]);
  }
  return i;
}

}  // namespace

ColourCube::ColourCube(const Transform& from_yuv)
    : yuv_(planes_of(from_yuv)),
      bgr_(planes_of(from_bgr(from_yuv))) {}

ColourCube::Transform ColourCube::transform_of(const std::array<CubePlane, 3>& planes) {
  Eigen::Matrix3d weights;
  Eigen::Vector3d thresholds;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const CubePlane& plane = planes[static_cast<std::size_t>(axis)];
    weights.row(axis) << plane.red, plane.green, plane.blue;
    thresholds(axis) = plane.threshold;
  }
  Transform transform;
  transform.leftCols<3>() = weights * yuv_from_rgb().inverse();
  transform.col(3) = -thresholds - kMiddle * (transform.col(1) + transform.col(2));
  return transform;
}

ColourCube::Transform ColourCube::thresholds(const Eigen::Vector3d& thresholds) {
  return transform_of({CubePlane{1.0, 0.0, 0.0, thresholds(0)},
                       CubePlane{0.0, 1.0, 0.0, thresholds(1)},
                       CubePlane{0.0, 0.0, 1.0, thresholds(2)}});
}

void ColourCube::segment(const ImageView& image, std::span<std::uint8_t> vertices) const {
  const PixelReader pixels(image);
  const std::uint8_t* bytes = pixels.bytes();
  const std::size_t n = std::size_t{image.width_px} * image.height_px;
  TEAMSIGHT_EXPECT(vertices.size() == n);
  std::size_t i = 0;
  if (image.format == PixelFormat::kYuyv) i = segment_pairs<true>(yuv_, bytes, vertices);
  if (image.format == PixelFormat::kUyvy) i = segment_pairs<false>(yuv_, bytes, vertices);
  if (image.format == PixelFormat::kBgr) {
    for (i = segment_bgr(bgr_, bytes, vertices); i < n; ++i) {
      vertices[i] = vertex_of_bgr(bytes[3 * i], bytes[3 * i + 1], bytes[3 * i + 2]);
    }
  }
  for (; i < n; ++i) {
    const Chroma chroma = pixels.chroma(i);
    vertices[i] = vertex({pixels.luminance(i), chroma.u, chroma.v});
  }
}

}  // namespace teamsight::vision
