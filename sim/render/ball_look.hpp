// sim/render/ball_look.hpp: what is painted on a ball.
#pragma once

#include <cstdint>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "sim/render/paint.hpp"

namespace teamsight::sim {

/// Where a ball has its second paint.
enum class BallPattern : std::uint8_t {
  kPlain,     ///< nowhere
  kFootball,  ///< on the twelve pentagons of a truncated icosahedron
  kOctants,   ///< on four of eight octants, no two of which share an edge
};

/// A ball's paints, and how it is turned.
struct BallLook {
  Paint paint{240, 110, 20};
  BallPattern pattern{BallPattern::kPlain};
  Paint panels{20, 20, 20};  ///< the second paint
  /// From the ball's own frame, in which the pattern lies, to F.
  Eigen::Quaterniond turn_F{Eigen::Quaterniond::Identity()};

  friend bool operator==(const BallLook&, const BallLook&) = default;
};

/// How deep a place on the ball lies inside of its panels, as a share of the ball's radius and
/// about as long as the way over its surface to the nearest edge; negative: outside of them.
///
/// @param place  of unit length, in the ball's own frame
[[nodiscard]] float depth_in_panels(BallPattern pattern, const Eigen::Vector3f& place);

}  // namespace teamsight::sim
