// geometry/field_model.hpp: what is painted on and standing around a playing field.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "geometry/frames.hpp"

namespace teamsight {

/// Which family of the founding paper's lines a segment belongs to; its method needs them apart.
enum class LineFamily : std::uint8_t {
  kOther,
  kVertical,    ///< parallel to y: goal lines, area fronts, centre line
  kHorizontal,  ///< parallel to x: side lines or walls, area sides, goal sides
};

/// A straight painted line; the centre of the paint. Never of no length: settings/ refuses that.
struct FieldLine {
  std::string name;
  Point<Field> from;
  Point<Field> to;
  LineFamily family{LineFamily::kOther};

  friend bool operator==(const FieldLine&, const FieldLine&) = default;
};

/// A painted circle or a part of one; the centre of the paint.
struct FieldArc {
  std::string name;
  Point<Field> centre;
  double radius{0.0};  ///< m
  double start{0.0};   ///< direction of the first point from the centre in F; rad
  double sweep{0.0};   ///< counter-clockwise extent, in (0, 2 pi]; rad

  friend bool operator==(const FieldArc&, const FieldArc&) = default;
};

/// A filled round mark: centre mark, penalty marks, restart marks.
struct FieldSpot {
  std::string name;
  Point<Field> centre;
  double radius{0.0};  ///< m

  friend bool operator==(const FieldSpot&, const FieldSpot&) = default;
};

enum class GoalColour : std::uint8_t { kNone, kBlue, kYellow, kWhite };

/// A goal: its mouth between two posts on the floor.
struct Goal {
  std::string name;
  Point<Field> left_post;   ///< as seen from the field
  Point<Field> right_post;  ///< as seen from the field
  double height{0.0};       ///< m
  double depth{0.0};        ///< m, behind the mouth
  GoalColour colour{GoalColour::kNone};

  friend bool operator==(const Goal&, const Goal&) = default;
};

/// An upright white wall standing on the floor, as the field of 2001 had.
struct Wall {
  std::string name;
  Point<Field> from;
  Point<Field> to;
  double height{0.0};  ///< m

  friend bool operator==(const Wall&, const Wall&) = default;
};

/// A playing field in F. Made from a field file by `settings::load_field`.
struct FieldModel {
  std::string name;
  double length{0.0};      ///< along x, between the goal lines' centres; m
  double width{0.0};       ///< along y, between the side lines' centres; m
  double surround{0.0};    ///< carpet beyond the lines; m
  double line_width{0.0};  ///< m
  Point<Field> centre;     ///< where the centre mark is; the origin unless a file is shifted
  std::vector<FieldLine> lines;
  std::vector<FieldArc> arcs;
  std::vector<FieldSpot> spots;
  std::vector<Goal> goals;
  std::vector<Wall> walls;

  friend bool operator==(const FieldModel&, const FieldModel&) = default;
};

/// Where the paint nearest to a floor point is.
struct NearestLine {
  double distance{0.0};        ///< signed along `normal`: p = closest + distance * normal; m
  Eigen::Vector2d closest_F;   ///< on the paint's centre line; m
  Eigen::Vector2d normal_F;    ///< unit length
  std::uint16_t primitive{0};  ///< index into lines, then arcs
  bool is_end{false};          ///< `closest` is an end point, so the normal is not the line's
};

/// Finds the painted line or arc nearest to `p_F`, by comparing with each of them.
///
/// @return nothing if the field has neither lines nor arcs
[[nodiscard]] std::optional<NearestLine> nearest_line(const FieldModel& field,
                                                      const Point<Field>& p_F);

/// Distance of `p_F` to one primitive (index into lines, then arcs).
///
/// @pre primitive < lines.size() + arcs.size()
[[nodiscard]] NearestLine line_at(const FieldModel& field,
                                  std::uint16_t primitive,
                                  const Point<Field>& p_F);

/// Whether `p_F` lies on the carpet: inside the lines or in the surround.
[[nodiscard]] bool is_on_carpet(const FieldModel& field, const Point<Field>& p_F);

/// Whether half a turn about the centre maps the painted field onto itself (coloured goals do not).
[[nodiscard]] bool is_half_turn_symmetric(const FieldModel& field);

/// The same field, painted elsewhere: every coordinate moved by `offset`.
[[nodiscard]] FieldModel shifted(FieldModel field, const Eigen::Vector2d& offset_F);

}  // namespace teamsight
