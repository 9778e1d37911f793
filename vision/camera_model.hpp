// vision/camera_model.hpp: from pixels to rays in space and back, for a camera below a mirror.
#pragma once

#include <optional>
#include <variant>

#include <Eigen/Core>

#include "geometry/frames.hpp"
#include "vision/camera_parameters.hpp"
#include "vision/mirror_trace.hpp"
#include "vision/monotone_curve.hpp"

namespace teamsight::vision {

/// A place in frame I: column and row; whole numbers are the middles of pixels.
struct Pixel {
  double u{0.0};
  double v{0.0};

  friend bool operator==(const Pixel&, const Pixel&) = default;
};

/// One robot's eye as geometry. A value; all functions are pure.
class CameraModel {
 public:
  /// @pre the parameters were checked: a radial table has growing rows (at least two), a profile
  ///      grows outwards
  explicit CameraModel(const CameraParameters& parameters);

  /// What the pixel looks along: from the mirror (or its virtual viewpoint) outwards, in R.
  ///
  /// @return nothing where the mirror shows nothing: outside the table or the profile
  [[nodiscard]] std::optional<Ray<Robot>> ray(const Pixel& pixel) const;

  /// Where the pixel's ray meets the horizontal plane at `height`; m over the floor.
  ///
  /// @return nothing if the ray does not go down to it
  [[nodiscard]] std::optional<Point<Robot>> on_plane(const Pixel& pixel, double height) const;

  /// Where a point in space appears.
  ///
  /// @return nothing if the camera cannot see it
  [[nodiscard]] std::optional<Pixel> project(const Point3<Robot>& p_R) const;

  /// Metres on the floor per pixel, d(x, y)/d(u, v) in R.
  [[nodiscard]] std::optional<Eigen::Matrix2d> floor_jacobian(const Pixel& pixel) const;

  /// The pixel on the camera's axis.
  [[nodiscard]] Pixel centre() const { return centre_; }

  /// The direction in the picture (counter-clockwise from image right) of an azimuth in R.
  [[nodiscard]] double image_direction(double azimuth) const;

  /// The inverse of image_direction.
  [[nodiscard]] double azimuth(double image_direction) const;

 private:
  /// A mirror seen through one virtual viewpoint on the axis: angle from straight down over radius.
  struct Radial {
    MonotoneCurve angle_from_down;
    double viewpoint_height;
    Eigen::Matrix3d R_RH;  // the head (H) is turned about the viewpoint
  };

  [[nodiscard]] std::optional<Ray<Robot>> radial_ray(const Radial& radial,
                                                     double du,
                                                     double dv) const;
  [[nodiscard]] std::optional<Pixel> project_radial(const Radial& radial,
                                                    const Point3<Robot>& p_R) const;

  /// How far the ray of `pixel` passes above `p_R` (elevation) and to its left (azimuth); rad.
  [[nodiscard]] std::optional<Eigen::Vector2d> miss(const Pixel& pixel,
                                                    const Point3<Robot>& p_R) const;
  [[nodiscard]] std::optional<Pixel> project_on_meridian(const Point3<Robot>& p_R) const;
  [[nodiscard]] std::optional<Pixel> project_through_mirror(const Point3<Robot>& p_R) const;

  Pixel centre_;
  double forward_;
  bool mirrored_;
  std::variant<Radial, MirrorTrace> eye_;
};

/// Where a ray meets the horizontal plane at `height`; m over the floor.
///
/// @return nothing if it does not go down to it
template <class Frame>
[[nodiscard]] std::optional<Point<Frame>> meet_plane(const Ray<Frame>& ray, double height) {
  const double down = -ray.direction.z();
  if (down <= 1e-9 || ray.origin.z <= height) return std::nullopt;
  const double t = (ray.origin.z - height) / down;
  return Point<Frame>{ray.origin.x + t * ray.direction.x(), ray.origin.y + t * ray.direction.y()};
}

}  // namespace teamsight::vision
