// vision/mirror/trace.hpp: what a pixel of a mirror camera sees, in the meridian plane.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "vision/mirror/assembly.hpp"
#include "vision/mirror/profile.hpp"

namespace teamsight::mirror {

/// A reflected ray in its meridian plane.
struct Ray {
  std::size_t part{0};  ///< of the profile, where it starts
  Node origin;          ///< on the mirror
  double psi{0.0};      ///< angle from the downward vertical, outwards; rad; over pi/2 it rises
};

/// Reflects a ray that comes up to the mirror.
///
/// @param alpha  angle of the coming ray from the upward vertical, outwards; rad
/// @param slope  of the mirror where it meets it
/// @return angle of the reflected ray from the downward vertical, outwards; rad
[[nodiscard]] double reflected_angle(double alpha, double slope);

/// The reflected ray of the camera ray that meets the mirror in `node`.
[[nodiscard]] Ray reflect(std::size_t part, const Node& node);

/// Traces one pixel. @param radius_px  distance from the image centre, 0 or more
/// @return nothing if the pixel shows what is beside the mirror
[[nodiscard]] std::optional<Ray> trace(const Assembly& assembly, double radius_px);

/// Floor distance of the ray from the axis; m. @return nothing if it never comes down
[[nodiscard]] std::optional<double> floor_distance(const Ray& ray, double pinhole_height);

/// Height of the ray over the floor at a distance from the axis; m.
///
/// @return nothing if the ray starts further out, or has met the floor before
[[nodiscard]] std::optional<double> height_at(const Ray& ray,
                                              double pinhole_height,
                                              double distance);

/// How far the ray passes outside the robot's body, measured at the top edges; m.
///
/// @return negative where it hits the body; infinity if there is no body below the ray
[[nodiscard]] double body_clearance(const Ray& ray, const Assembly& assembly);

/// What one node of the profile shows of the floor.
struct FloorSample {
  std::size_t part{0};
  Node node;
  double radius_px{0.0};
  std::optional<double> distance;  ///< on the floor; m; nothing at and above the horizon
  std::optional<double> m_per_px;  ///< change of distance with the image radius
  double clearance{0.0};           ///< outside the body; m; negative: hidden

  [[nodiscard]] bool is_visible() const { return distance.has_value() && clearance > 0.0; }
};

/// The floor as each node shows it, from the axis outwards.
[[nodiscard]] std::vector<FloorSample> sample_floor(const Assembly& assembly);

/// A stretch of floor that one part shows, in front of the body.
struct FloorView {
  std::size_t part{0};
  double near{0.0};  ///< m from the axis
  double far{0.0};   ///< m; the last distance before the horizon if `to_horizon`
  bool to_horizon{false};
};

/// The visible stretches of floor, part by part. The border of the body is interpolated.
[[nodiscard]] std::vector<FloorView> visible_floor(const std::vector<FloorSample>& samples);

/// The nearest floor that is seen at all; m. @return nothing if no floor is seen
[[nodiscard]] std::optional<double> blind_radius(const std::vector<FloorView>& views);

/// What one pixel means at a floor distance; m per pixel, the finest of the parts that show it.
///
/// @return nothing if no part shows that distance
[[nodiscard]] std::optional<double> pixel_error(const std::vector<FloorSample>& samples,
                                                double distance);

}  // namespace teamsight::mirror
