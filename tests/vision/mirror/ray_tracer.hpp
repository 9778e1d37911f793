// tests/vision/mirror/ray_tracer.hpp: a ray tracer in three dimensions that knows nothing but
// points of the meridian. It shares no code with vision/: own interpolation, own normals, own
// reflection.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace teamsight::test {

using Vector3 = std::array<double, 3>;

/// A ray after its reflection. The origin of the frame is the pinhole, z points up.
struct TracedRay {
  Vector3 origin{};
  Vector3 direction{};
};

/// One smooth piece of a surface of revolution about z.
class Surface {
 public:
  /// @param points          (distance from the axis, height over the pinhole), outwards; m
  /// @param is_round_inside  the surface is smooth across the axis, where it begins
  Surface(std::vector<std::array<double, 2>> points, bool is_round_inside);

  /// Height at a distance from the axis, by a polynomial of degree 5 through the nearest points.
  [[nodiscard]] double height(double distance) const;

  /// Sends a ray up from the pinhole. @return nothing if it misses this piece
  [[nodiscard]] std::optional<TracedRay> reflect(const Vector3& direction) const;

  [[nodiscard]] double inner() const { return inner_; }

  [[nodiscard]] double outer() const { return points_.back()[0]; }

 private:
  [[nodiscard]] Vector3 embed(double distance, double azimuth) const;
  [[nodiscard]] Vector3 normal(double distance, double azimuth) const;

  std::vector<std::array<double, 2>> points_;
  double inner_{0.0};
};

/// The direction that leaves the pinhole at an angle of which the tangent is given.
[[nodiscard]] Vector3 camera_ray(double tan_alpha, double azimuth);

/// Where the ray has come down to height z. @return nothing if it rises
[[nodiscard]] std::optional<Vector3> at_height(const TracedRay& ray, double z);

/// Where the ray is at a horizontal distance from the axis, going outwards.
[[nodiscard]] Vector3 at_distance(const TracedRay& ray, double distance);

/// Distance from the axis.
[[nodiscard]] double radius_of(const Vector3& point);

/// Whether the ray meets one of the surfaces again further out, looking every `step` metres.
[[nodiscard]] bool meets_again(const TracedRay& ray,
                               const std::vector<Surface>& surfaces,
                               double step);

}  // namespace teamsight::test
