// tests/vision/mirror/independent_test.cpp: every mirror against the ray tracer of this folder.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "tests/vision/mirror/mirrors.hpp"
#include "tests/vision/mirror/ray_tracer.hpp"
#include "vision/mirror/trace.hpp"

namespace teamsight::test {
namespace {

using testing::Lt;

constexpr int kRays = 500;
constexpr double kTooFar = 12.0;  // m; beyond, 1e-6 m are below the precision of a slope

/// Nothing but the points leaves the profile.
Surface surface_of(const mirror::Part& part) {
  std::vector<std::array<double, 2>> points;
  for (const mirror::Node& node : part.nodes) {
    points.push_back({node.x, node.y});
  }
  const mirror::Node& first = part.nodes.front();
  return {points, first.x == 0.0 && first.slope == 0.0};
}

std::vector<Surface> surfaces_of(const mirror::Mirror& mirror) {
  std::vector<Surface> surfaces;
  for (const mirror::Part& part : mirror.assembly.profile.parts) {
    surfaces.push_back(surface_of(part));
  }
  return surfaces;
}

/// Rays to one part at all azimuths: tangents of their angles, ends left out.
std::vector<double> tangents_of(const mirror::Part& part) {
  const double from = part.nodes.front().x / part.nodes.front().y;
  const double to = part.nodes.back().x / part.nodes.back().y;
  std::vector<double> tangents;
  for (int i = 0; i < kRays; ++i) {
    tangents.push_back(from + (to - from) * (i + 0.5) / kRays);
  }
  return tangents;
}

double azimuth(std::size_t i) {
  return 2.399963 * static_cast<double>(i);  // the golden angle: never twice the same
}

class EveryMirror : public testing::TestWithParam<std::string> {};

TEST_P(EveryMirror, ShowsTheFloorWhereTheTracerDoes) {
  const mirror::Mirror mirror = designed(GetParam());
  const double height = mirror.assembly.pinhole_height;
  int compared = 0;

  for (const mirror::Part& part : mirror.assembly.profile.parts) {
    const Surface surface = surface_of(part);
    const auto tangents = tangents_of(part);
    for (std::size_t i = 0; i < tangents.size(); ++i) {
      const auto expected = surface.reflect(camera_ray(tangents[i], azimuth(i)));
      const auto ray = mirror::trace(mirror.assembly, tangents[i] * mirror.assembly.focal_px);
      ASSERT_TRUE(expected && ray) << part.name << " at tangent " << tangents[i];
      const auto floor = at_height(*expected, -height);
      if (!floor || radius_of(*floor) > kTooFar) {
        continue;
      }
      ASSERT_NEAR(*mirror::floor_distance(*ray, height), radius_of(*floor), 1e-6)
          << part.name << " at tangent " << tangents[i];
      EXPECT_NEAR(
          std::remainder(std::atan2((*floor)[1], (*floor)[0]) - azimuth(i), 2.0 * std::numbers::pi),
          0.0,
          1e-9);
      ++compared;
    }
  }

  EXPECT_GT(compared, kRays / 3);
}

TEST_P(EveryMirror, SendsNoRayBackToItself) {
  const mirror::Mirror mirror = designed(GetParam());
  const auto surfaces = surfaces_of(mirror);

  for (std::size_t k = 0; k < surfaces.size(); ++k) {
    for (const double tangent : tangents_of(mirror.assembly.profile.parts[k])) {
      const auto ray = surfaces[k].reflect(camera_ray(tangent, 0.3));
      ASSERT_TRUE(ray.has_value());
      EXPECT_FALSE(meets_again(*ray, surfaces, 1e-3)) << GetParam() << " at tangent " << tangent;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Independent,
                         EveryMirror,
                         testing::ValuesIn(kMirrorFiles),
                         [](const auto& file) { return file.param; });

TEST(IndependentTracer, FindsTheIsometricPartToScaleWithinAMicrometreUpToSixMetres) {
  const mirror::Mirror mirror = designed("multi_part");
  const mirror::Part& part = mirror.assembly.profile.parts.front();
  const double eta = 6.0 / (part.nodes.back().x / part.nodes.back().y);
  double worst = 0.0;

  const auto tangents = tangents_of(part);
  for (std::size_t i = 0; i < tangents.size(); ++i) {
    const auto ray = surface_of(part).reflect(camera_ray(tangents[i], azimuth(i)));
    const auto floor = at_height(*ray, -mirror.assembly.pinhole_height);
    worst = std::max(worst, std::abs(radius_of(*floor) - eta * tangents[i]));
  }

  EXPECT_THAT(worst, Lt(1e-6));
}

TEST(IndependentTracer, SeesTheGoalsHeightAtTheFarEndOfTheField) {
  const mirror::Mirror mirror = designed("multi_part");
  const mirror::Part& part = mirror.assembly.profile.parts[1];
  const mirror::Node& B = part.nodes.back();

  const auto ray = surface_of(part).reflect(camera_ray(B.x / B.y * (1.0 - 1e-12), 1.0));

  ASSERT_TRUE(ray.has_value());
  EXPECT_NEAR(at_distance(*ray, 11.2)[2] + mirror.assembly.pinhole_height, 0.6, 1e-6);
}

TEST(IndependentTracer, SeesTheFloorBesideTheRobotInTheRing) {
  const mirror::Mirror mirror = designed("multi_part");
  const mirror::Part& ring = mirror.assembly.profile.parts[2];
  const auto seen = [&](const mirror::Node& node, double inwards) {
    const auto ray = surface_of(ring).reflect(camera_ray(node.x / node.y * inwards, 2.0));
    return radius_of(*at_height(*ray, -mirror.assembly.pinhole_height));
  };

  EXPECT_NEAR(seen(ring.nodes.front(), 1.0 + 1e-12), 0.39, 1e-9);
  EXPECT_NEAR(seen(ring.nodes.back(), 1.0 - 1e-12), 0.51, 1e-9);
}

TEST(IndependentTracer, AgreesWithItselfOnAPlane) {
  const Surface plane({{0.0, 0.2}, {0.05, 0.2}, {0.1, 0.2}}, true);

  const auto ray = plane.reflect(camera_ray(0.25, 0.7));

  ASSERT_TRUE(ray.has_value());
  EXPECT_NEAR(radius_of(*at_height(*ray, -0.6)), 0.25 * (0.2 + 0.2 + 0.6), 1e-12);
}

}  // namespace
}  // namespace teamsight::test
