// vision/mirror/profile.hpp: the meridian of a mirror of revolution, as nodes with exact slopes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace teamsight::mirror {

/// A point of the meridian. The origin is the pinhole, y points up along the axis.
struct Node {
  double x{0.0};      ///< distance from the axis; m
  double y{0.0};      ///< height over the pinhole; m
  double slope{0.0};  ///< dy/dx, dimensionless

  friend bool operator==(const Node&, const Node&) = default;
};

/// A smooth piece of the meridian; nodes by growing x, at least two.
struct Part {
  std::string name;
  std::vector<Node> nodes;
  bool kinked_start{false};  ///< the tangent may jump where this part begins

  friend bool operator==(const Part&, const Part&) = default;
};

/// The whole meridian from the axis outwards. A part begins where the one before it ends.
struct Profile {
  std::vector<Part> parts;

  friend bool operator==(const Profile&, const Profile&) = default;
};

/// Where a camera ray meets the mirror.
struct Hit {
  std::size_t part{0};  ///< index in `Profile::parts`
  Node node;
};

/// The point of a part at `x`, by cubic Hermite interpolation between its nodes.
///
/// @param x  m, within the part; outside it the end piece is continued
[[nodiscard]] Node at(const Part& part, double x);

/// Finds where the camera ray of a given angle meets the mirror.
///
/// @param tan_alpha  tangent of the angle between the ray and the axis, 0 or more
/// @pre x/y grows along the profile (see `check_image_order`)
/// @return the point; nothing if the ray passes outside the rim. At a joint the inner part answers.
[[nodiscard]] std::optional<Hit> find_hit(const Profile& profile, double tan_alpha);

/// The last node of the last part. @pre the profile has a part
[[nodiscard]] const Node& rim(const Profile& profile);

}  // namespace teamsight::mirror
