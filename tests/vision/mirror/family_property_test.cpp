// tests/vision/mirror/family_property_test.cpp: what holds for every multi-part mirror of the
// family.
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "tests/support/property.hpp"
#include "vision/mirror/design.hpp"
#include "vision/mirror/trace.hpp"

namespace teamsight::mirror {
namespace {

using testing_support::holds_for_all;
using testing_support::number;

constexpr int kCases = 60;

/// Mounting height, mirror radius and split over the ranges that are known to close.
MirrorParameters any_member() {
  MultiPart shape;
  shape.isometric_share = *number(0.70, 0.92);
  const double radius = *number(0.08, 0.10);
  const double height = *number(0.75, 0.85);
  return {.name = "member",
          .rim = {radius, height},
          .shape = shape,
          .scale = RimRadiusPx{*number(240.0, 1024.0)},
          .body = {}};
}

void scale_lengths(MirrorParameters& parameters, double factor) {
  auto& shape = std::get<MultiPart>(parameters.shape);
  for (double* length : {&parameters.rim.radius,
                         &parameters.rim.height,
                         &shape.isometric_range,
                         &shape.max_distance,
                         &shape.max_height,
                         &shape.ring_near,
                         &shape.ring_far}) {
    *length *= factor;
  }
}

TEST(MirrorFamily, ClosesWithContinuousTangentAndMeetsItsConditions) {
  holds_for_all(
      1999,
      [] {
        const auto mirror = design(any_member());
        RC_ASSERT(mirror.has_value());
        const auto& s = *mirror->multi_part;
        const Node end_of_arc = at(s.arc, s.point_B.x);
        const double H = mirror->assembly.pinhole_height;

        RC_ASSERT(std::abs(end_of_arc.y - s.point_B.y) < 1e-12);
        RC_ASSERT(std::abs(end_of_arc.slope - s.point_B.slope) < 1e-10);
        RC_ASSERT(mirror->margins.joint_slope_jump.value < 1e-10);
        RC_ASSERT(mirror->margins.second_hit.value > 0.0);
        RC_ASSERT(std::abs(height_at(reflect(1, s.point_B), H, 11.2).value() - 0.6) < 1e-9);
        RC_ASSERT(std::abs(floor_distance(reflect(0, s.point_A), H).value() - 6.0) < 1e-9);
        RC_ASSERT(std::abs(floor_distance(reflect(2, {s.point_B.x, s.point_B.y, 0.0}), H).value() -
                           0.39) < 1e-12);
        RC_ASSERT(std::abs(floor_distance(reflect(2, s.point_C), H).value() - 0.51) < 1e-12);
      },
      kCases);
}

TEST(MirrorFamily, IsToScaleAtEveryPixelUpToSixMetres) {
  holds_for_all(
      2000,
      [] {
        const auto mirror = design(any_member());
        RC_ASSERT(mirror.has_value());
        const double end = mirror->assembly.focal_px * mirror->multi_part->isometric.tan_end;
        for (int i = 0; i < 40; ++i) {
          const double share = *number(0.0, 0.9999);
          const auto ray = trace(mirror->assembly, share * end);
          const auto floor = floor_distance(*ray, mirror->assembly.pinhole_height);
          RC_ASSERT(std::abs(*floor - 6.0 * share) < 1e-6);
        }
      },
      kCases);
}

TEST(MirrorFamily, GrowsWithItsWorld) {
  holds_for_all(
      2001,
      [] {
        MirrorParameters parameters = any_member();
        const auto small = design(parameters);
        const double factor = *number(0.5, 3.0);
        scale_lengths(parameters, factor);
        const auto large = design(parameters);
        RC_ASSERT(small.has_value() && large.has_value());

        RC_ASSERT(std::abs(large->assembly.focal_px / small->assembly.focal_px - 1.0) < 1e-9);
        RC_ASSERT(std::abs(large->multi_part->point_A.x - factor * small->multi_part->point_A.x) <
                  1e-9);
        RC_ASSERT(std::abs(large->multi_part->point_A.slope - small->multi_part->point_A.slope) <
                  1e-7);
      },
      kCases);
}

TEST(MirrorFamily, LosesWithTheTangentPlanesWhatTheFacetsAreLarge) {
  holds_for_all(
      2002,
      [] {
        MirrorParameters parameters = any_member();
        parameters.facet_px = 1.0;
        const auto coarse = design(parameters);
        parameters.facet_px = 0.25;
        const auto fine = design(parameters);
        RC_ASSERT(coarse.has_value() && fine.has_value());

        const double ratio = coarse->integrations->profile / fine->integrations->profile;
        const double facets = static_cast<double>(fine->integrations->facets) /
                              static_cast<double>(coarse->integrations->facets);
        RC_ASSERT(std::abs(ratio / facets - 1.0) < 0.1);
      },
      kCases);
}

}  // namespace
}  // namespace teamsight::mirror
