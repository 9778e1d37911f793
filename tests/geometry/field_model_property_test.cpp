// tests/geometry/field_model_property_test.cpp: nearest paint against sampling all of the paint.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/field_model.hpp"
#include "tests/geometry/fields.hpp"
#include "tests/support/property.hpp"

namespace teamsight {
namespace {

using testing_support::holds_for_all;
using testing_support::number;

constexpr double kPace = 0.01;  // between samples; m

Point<Field> some_point() {
  return {*number(-7.0, 7.0), *number(-5.0, 5.0)};
}

// Points on all the paint, no further apart than kPace.
std::vector<Eigen::Vector2d> sampled(const FieldModel& field) {
  std::vector<Eigen::Vector2d> samples;
  for (const FieldLine& line : field.lines) {
    const Eigen::Vector2d along = line.to.vector() - line.from.vector();
    const int steps = static_cast<int>(std::ceil(along.norm() / kPace));
    for (int i = 0; i <= steps; ++i) samples.emplace_back(line.from.vector() + along * i / steps);
  }
  for (const FieldArc& arc : field.arcs) {
    const int steps = static_cast<int>(std::ceil(arc.sweep * arc.radius / kPace));
    for (int i = 0; i <= steps; ++i) {
      const double at = arc.start + arc.sweep * i / steps;
      samples.emplace_back(arc.centre.vector() +
                           arc.radius * Eigen::Vector2d(std::cos(at), std::sin(at)));
    }
  }
  return samples;
}

TEST(FieldModelProperty, NearestLineAgreesWithSampling) {
  const FieldModel field = small_field();
  const std::vector<Eigen::Vector2d> samples = sampled(field);

  holds_for_all(21, [&] {
    const Point<Field> p = some_point();
    double best = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& sample : samples)
      best = std::min(best, (p.vector() - sample).norm());

    const double distance = std::abs(nearest_line(field, p).value().distance);

    RC_ASSERT(distance <= best + 1e-12);
    RC_ASSERT(best <= distance + 0.5 * kPace);
  });
}

TEST(FieldModelProperty, PointIsClosestPlusDistanceAlongTheUnitNormal) {
  const FieldModel field = small_field();

  holds_for_all(22, [&] {
    const Point<Field> p = some_point();
    const auto primitive = *rc::gen::inRange<std::uint16_t>(0, 8);

    const NearestLine nearest = line_at(field, primitive, p);

    RC_ASSERT(std::abs(nearest.normal_F.norm() - 1.0) < 1e-12);
    RC_ASSERT((nearest.closest_F + nearest.distance * nearest.normal_F - p.vector()).norm() < 1e-9);
    RC_ASSERT(nearest.primitive == primitive);
  });
}

TEST(FieldModelProperty, ShiftingFieldAndPointChangesNoDistance) {
  const FieldModel field = small_field();

  holds_for_all(23, [&] {
    const Point<Field> p = some_point();
    const Eigen::Vector2d offset = some_point().vector();
    const Point<Field> moved = Point<Field>::from(p.vector() + offset);

    const double before = nearest_line(field, p).value().distance;
    const double after = nearest_line(shifted(field, offset), moved).value().distance;

    RC_ASSERT(std::abs(std::abs(before) - std::abs(after)) < 1e-9);
  });
}

TEST(FieldModelProperty, HalfATurnChangesNoDistanceOnASymmetricField) {
  const FieldModel field = small_field();

  holds_for_all(24, [&] {
    const Point<Field> p = some_point();

    const double here = nearest_line(field, p).value().distance;
    const double there = nearest_line(field, {-p.x, -p.y}).value().distance;

    RC_ASSERT(std::abs(std::abs(here) - std::abs(there)) < 1e-9);
  });
}

}  // namespace
}  // namespace teamsight
