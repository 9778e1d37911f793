// geometry/frames.hpp: points, directions and velocities that know their frame. See docs/frames.md.
#pragma once

#include <Eigen/Core>

namespace teamsight {

/// Frame F: origin at the centre mark, x towards the opponent goal, y left, z up. Metres.
struct Field {};

/// Frame R: on the floor below the robot's centre, x forward, y left, z up. Metres.
struct Robot {};

/// Frame C: in the pinhole, z along the optical axis towards the mirror, x towards image right.
struct Camera {};

/// Frame D: where R stood when the wheels began to count; it drifts against F.
struct Drive {};

/// A place on the floor, expressed in `Frame`; metres.
template <class Frame>
struct Point {
  double x{0.0};
  double y{0.0};

  [[nodiscard]] Eigen::Vector2d vector() const { return {x, y}; }

  static Point from(const Eigen::Vector2d& v) { return {v.x(), v.y()}; }

  friend bool operator==(const Point&, const Point&) = default;
};

/// A place in space, expressed in `Frame`; metres.
template <class Frame>
struct Point3 {
  double x{0.0};
  double y{0.0};
  double z{0.0};

  [[nodiscard]] Eigen::Vector3d vector() const { return {x, y, z}; }

  [[nodiscard]] Point<Frame> on_floor() const { return {x, y}; }

  static Point3 from(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

  friend bool operator==(const Point3&, const Point3&) = default;
};

/// A velocity over the floor, relative to F, expressed in `Frame`; metres per second.
template <class Frame>
struct Velocity {
  double x{0.0};
  double y{0.0};

  [[nodiscard]] Eigen::Vector2d vector() const { return {x, y}; }

  static Velocity from(const Eigen::Vector2d& v) { return {v.x(), v.y()}; }

  friend bool operator==(const Velocity&, const Velocity&) = default;
};

/// A velocity in space, relative to F, expressed in `Frame`; metres per second.
template <class Frame>
struct Velocity3 {
  double x{0.0};
  double y{0.0};
  double z{0.0};

  [[nodiscard]] Eigen::Vector3d vector() const { return {x, y, z}; }

  static Velocity3 from(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

  friend bool operator==(const Velocity3&, const Velocity3&) = default;
};

/// A half line in space, expressed in `Frame`.
template <class Frame>
struct Ray {
  Point3<Frame> origin;                       ///< metres
  Eigen::Vector3d direction{0.0, 0.0, -1.0};  ///< unit length, away from the origin

  friend bool operator==(const Ray&, const Ray&) = default;
};

}  // namespace teamsight
