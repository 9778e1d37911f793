// vision/patterned_disc.hpp: the disc of a ball's colours around a place on the carpet.
#pragma once

#include <optional>
#include <span>

#include "vision/ball_pattern.hpp"
#include "vision/frame_tables.hpp"
#include "vision/local_view.hpp"
#include "vision/pattern_traits.hpp"

namespace teamsight::vision {

/// Something that may be a patterned ball: a disc in angles about a place in the picture.
struct PatternedDisc {
  LocalView view;      ///< about its middle
  double radius{0.0};  ///< rad
  PatternTraits traits{};
  double probability{0.0};  ///< that it is a ball
};

/// A place in a frame, somewhere within what may be a ball.
struct PatternPlace {
  const FrameTables& frame;
  /// Of each pixel; 0 where own body and mirror hide the world.
  std::span<const float> solid_angle;
  const BallPattern& pattern;
  const PatternModel& model;
  Pixel centre;             ///< of the mirror in the image
  double ball_radius{0.0};  ///< m
  Pixel pixel;              ///< the place
  float carpet{0.0F};       ///< luminance of the carpet beside it
};

/// The angular radius of a ball on the floor whose middle a ray meets; rad. 0: none can be there.
[[nodiscard]] double angular_radius_at(const PixelRay& ray, double ball_radius);

/// Rays go out from the place in all directions to where the carpet begins. A ball leaves a disc of
/// about the size it has there, whatever touches it on one or two sides.
///
/// @return nothing if what is there is no disc, of another size altogether, of one colour, or less
///         probable than the model asks for
[[nodiscard]] std::optional<PatternedDisc> disc_around(const PatternPlace& place);

}  // namespace teamsight::vision
