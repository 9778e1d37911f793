// sim/render/shapes.hpp: upright cylinders, balls and panels, painted with smooth edges.
#pragma once

#include <vector>

#include "geometry/frames.hpp"
#include "sim/render/ball_look.hpp"
#include "sim/render/paint.hpp"
#include "sim/render/sights.hpp"

namespace teamsight::sim {

/// The light of every pixel, linear.
using Canvas = std::vector<Light, Eigen::aligned_allocator<Light>>;

/// An upright cylinder with a lid, in R.
struct Cylinder {
  Point<Robot> p_R;    ///< of its axis
  double radius{0.0};  ///< m
  double low{0.0};     ///< m over the floor
  double high{0.0};    ///< m
  Paint side;
  Paint lid;
};

/// A ball, in R.
struct Sphere {
  Point3<Robot> p_R;   ///< of its middle
  double radius{0.0};  ///< m
  Paint paint;
  BallPattern pattern{BallPattern::kPlain};
  Paint panels{};                                             ///< of the pattern
  Eigen::Quaternionf turn_R{Eigen::Quaternionf::Identity()};  ///< from the ball's own frame to R
};

/// An upright rectangle, in R.
struct Panel {
  Point<Robot> from;
  Point<Robot> to;
  double low{0.0};   ///< m
  double high{0.0};  ///< m
  Paint paint;
  double share{1.0};  ///< of what is behind that it hides: a net is thin
};

/// Each of these lays a shape over what the canvas shows; a pixel at an edge gets the share of it
/// that the shape fills, taken along the direction across the edge.
void paint_cylinder(Canvas& canvas, const Sights& sights, const Cylinder& cylinder);
void paint_ball(Canvas& canvas, const Sights& sights, const Sphere& ball);
void paint_panel(Canvas& canvas, const Sights& sights, const Panel& panel);

/// Darkens the floor around something that stands or lies there, as light from many lamps does.
void shade_floor(Canvas& canvas, const Sights& sights, const Point<Robot>& p_R, double radius);

}  // namespace teamsight::sim
