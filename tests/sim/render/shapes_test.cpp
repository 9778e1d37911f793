// tests/sim/render/shapes_test.cpp: shapes fill the share of a picture that closed forms say.
#include "sim/render/shapes.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/sim/render/eyes.hpp"

namespace teamsight::sim {
namespace {

constexpr Paint kWhite{255, 255, 255};
constexpr std::uint32_t kWidth = 640;
constexpr std::uint32_t kHeight = 480;

class Shapes : public testing::TestWithParam<int> {
 protected:
  Canvas blank() const {
    return Canvas(std::size_t{sights_.width()} * sights_.height(), Light::Zero());
  }

  // What is painted, in pixels of the picture, with its middle.
  struct Blob {
    double area{0.0};
    double u{0.0};
    double v{0.0};
  };

  Blob blob(const Canvas& canvas) const {
    Blob blob;
    for (std::size_t i = 0; i < canvas.size(); ++i) {
      const double share = static_cast<double>(canvas[i][3]);
      blob.area += share;
      blob.u += share * static_cast<double>(i % sights_.width());
      blob.v += share * static_cast<double>(i / sights_.width());
    }
    const double n = GetParam();
    return {blob.area / (n * n),
            (blob.u / blob.area + 0.5) / n - 0.5,
            (blob.v / blob.area + 0.5) / n - 0.5};
  }

  Optics optics_{eye_below(plane)};
  Sights sights_{optics_, kWidth, kHeight, GetParam()};
};

// Below a plane mirror the picture is that of a pinhole 0.9 m over the floor: areas are exact.

TEST_P(Shapes, ALidIsADiscOfItsSize) {
  Canvas canvas = blank();
  paint_cylinder(canvas, sights_, {{0.2, 0.1}, 0.05, 0.0, 1e-4, kWhite, kWhite});

  const double scale = kFocal / 0.9;  // px per m
  const Blob seen = blob(canvas);
  EXPECT_NEAR(seen.area, std::numbers::pi * std::pow(0.05 * scale, 2), 0.01 * seen.area);
  EXPECT_NEAR(seen.u, 320.0 + 0.1 * scale, 0.05);
  EXPECT_NEAR(seen.v, 240.0 - 0.2 * scale, 0.05);
}

TEST_P(Shapes, ABallIsTheEllipseOfItsTangents) {
  Canvas canvas = blank();
  const double depth = 0.9 - 0.3;
  paint_ball(canvas, sights_, {{0.25, 0.0, 0.3}, 0.06, kWhite});

  // A sphere seen by a pinhole: major axis along the view, tangents at +-asin(r/d).
  const double off = std::atan2(0.25, depth);
  const double half = std::asin(0.06 / std::hypot(0.25, depth));
  const double far = kFocal * std::tan(off + half);
  const double near = kFocal * std::tan(off - half);
  const double major = (far - near) / 2.0;
  const double minor = kFocal * 0.06 / std::sqrt(depth * depth - 0.06 * 0.06);
  const Blob seen = blob(canvas);
  EXPECT_NEAR(seen.area, std::numbers::pi * major * minor, 0.01 * seen.area);
  EXPECT_NEAR(seen.v, 240.0 - (far + near) / 2.0, 0.1);
}

TEST_P(Shapes, APanelIsTheQuadrilateralOfItsCorners) {
  Canvas canvas = blank();
  paint_panel(canvas, sights_, {{0.3, -0.1}, {0.3, 0.1}, 0.0, 0.2, kWhite, 1.0});

  // Its foot is 0.9 m, its top 0.7 m below the eye.
  const double foot = kFocal / 0.9;
  const double top = kFocal / 0.7;
  const Blob seen = blob(canvas);
  EXPECT_NEAR(seen.area, 0.3 * (top - foot) * 0.2 * (top + foot) / 2.0, 0.02 * seen.area);
  EXPECT_NEAR(seen.u, 320.0, 0.05);
}

TEST_P(Shapes, ACylinderHidesFromItsFootToItsTop) {
  Canvas canvas = blank();
  paint_cylinder(canvas, sights_, {{0.3, 0.0}, 0.05, 0.0, 0.2, kWhite, kWhite});

  double along_the_view = 0.0;
  for (std::size_t row = 0; row < sights_.height(); ++row) {
    along_the_view +=
        static_cast<double>(canvas[row * sights_.width() + sights_.width() / 2][3]) / GetParam();
  }
  EXPECT_NEAR(along_the_view, kFocal * (0.35 / 0.7 - 0.25 / 0.9), 0.3);
}

INSTANTIATE_TEST_SUITE_P(Fineness, Shapes, testing::Values(1, 3));

}  // namespace
}  // namespace teamsight::sim
