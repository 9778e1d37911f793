// tests/geometry/field_model_test.cpp: nearest paint, symmetry and shifting, case by case.
#include "geometry/field_model.hpp"

#include <numbers>

#include <gmock/gmock.h>

#include "tests/geometry/fields.hpp"
#include "tests/support/geometry_matchers.hpp"

namespace teamsight {
namespace {

using testing_support::IsMatrixNear;
using testing_support::IsNear;

TEST(NearestLine, IsNothingWithoutPaint) {
  EXPECT_EQ(nearest_line(FieldModel{}, {1, 2}), std::nullopt);
}

TEST(NearestLine, SignsTheDistanceAlongTheNormal) {
  const FieldModel field = small_field();

  const NearestLine inside = nearest_line(field, {3.0, 2.8}).value();
  const NearestLine outside = nearest_line(field, {3.0, 3.2}).value();

  EXPECT_EQ(field.lines.at(inside.primitive).name, "left");
  EXPECT_NEAR(std::abs(inside.distance), 0.2, 1e-12);
  EXPECT_NEAR(inside.distance, -outside.distance, 1e-12);
  EXPECT_FALSE(inside.is_end);
}

TEST(NearestLine, BeyondTheEndIsTheEndPoint) {
  const NearestLine nearest = line_at(small_field(), 4, {0.3, 3.4});

  EXPECT_TRUE(nearest.is_end);
  EXPECT_THAT(nearest.closest_F, IsMatrixNear(Eigen::Vector2d(0, 3), 1e-12));
  EXPECT_NEAR(nearest.distance, 0.5, 1e-12);
}

TEST(NearestLine, CountsArcsBehindLines) {
  const NearestLine nearest = nearest_line(small_field(), {1.1, 0.0}).value();

  EXPECT_EQ(nearest.primitive, 5);
  EXPECT_NEAR(nearest.distance, 0.1, 1e-12);
  EXPECT_THAT(nearest.normal_F, IsMatrixNear(Eigen::Vector2d(1, 0), 1e-12));
}

TEST(NearestLine, InsideACircleHasANegativeDistance) {
  EXPECT_NEAR(line_at(small_field(), 5, {0.6, 0.0}).distance, -0.4, 1e-12);
}

TEST(NearestLine, AtTheCentreOfACircleIsAnyPointOfIt) {
  const NearestLine nearest = line_at(small_field(), 5, {0.0, 0.0});

  EXPECT_NEAR(nearest.distance, -1.0, 1e-12);
  EXPECT_NEAR(nearest.normal_F.norm(), 1.0, 1e-12);
}

TEST(NearestLine, OutsideTheSweepOfAnArcIsItsNearerEnd) {
  const FieldModel field = small_field();

  const NearestLine start = line_at(field, 6, {-4.4, -3.1});
  const NearestLine end = line_at(field, 6, {-5.1, -2.4});

  EXPECT_TRUE(start.is_end);
  EXPECT_THAT(start.closest_F, IsMatrixNear(Eigen::Vector2d(-4.5, -3.0), 1e-12));
  EXPECT_TRUE(end.is_end);
  EXPECT_THAT(end.closest_F, IsMatrixNear(Eigen::Vector2d(-5.0, -2.5), 1e-12));
}

TEST(LineAtDeathTest, RefusesAPrimitiveThatIsNotThere) {
  EXPECT_DEATH(std::ignore = line_at(small_field(), 8, {}), "expected: primitive");
}

TEST(IsOnCarpet, GoesWithTheShiftedField) {
  const FieldModel moved = shifted(small_field(), {1.0, 0.5});

  EXPECT_TRUE(is_on_carpet(moved, {6.5, 4.0}));
  EXPECT_FALSE(is_on_carpet(moved, {-5.0, 0.0}));
}

TEST(IsHalfTurnSymmetric, SeesOneLineTooMany) {
  FieldModel field = small_field();
  EXPECT_TRUE(is_half_turn_symmetric(field));

  field.lines.push_back({"kerb", {1, 1}, {2, 1}, LineFamily::kOther});

  EXPECT_FALSE(is_half_turn_symmetric(field));
}

TEST(IsHalfTurnSymmetric, SeesAnArcThatOpensTheWrongWay) {
  FieldModel field = small_field();

  field.arcs.at(2).start += 0.5 * std::numbers::pi;

  EXPECT_FALSE(is_half_turn_symmetric(field));
}

TEST(IsHalfTurnSymmetric, HoldsWhereverTheFieldIs) {
  EXPECT_TRUE(is_half_turn_symmetric(shifted(small_field(), {3.0, -7.0})));
}

TEST(Shifted, MovesEveryKindOfThing) {
  const FieldModel field = shifted(small_field(), {1.0, 0.5});

  EXPECT_THAT(field.centre, IsNear(Point<Field>{1, 0.5}, 0.0));
  EXPECT_THAT(field.lines.at(0).from, IsNear(Point<Field>{-4, 3.5}, 0.0));
  EXPECT_THAT(field.arcs.at(0).centre, IsNear(Point<Field>{1, 0.5}, 0.0));
  EXPECT_THAT(field.spots.at(0).centre, IsNear(Point<Field>{1, 0.5}, 0.0));
  EXPECT_THAT(field.goals.at(0).left_post, IsNear(Point<Field>{6, 1.5}, 0.0));
  EXPECT_THAT(field.walls.at(0).to, IsNear(Point<Field>{6, 4.5}, 0.0));
}

}  // namespace
}  // namespace teamsight
