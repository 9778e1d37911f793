// sim/match/pitch.hpp: what bounds a match: lines, boards around the carpet, goals with nets.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "geometry/field_model.hpp"
#include "sim/match/ball.hpp"

namespace teamsight::sim {

/// The field as bodies meet it.
class Pitch {
 public:
  explicit Pitch(const FieldModel& field);

  /// Keeps a ball that moved from `before` out of boards, posts and nets: boards throw it back at
  /// any height (the hall has a safety net), a net inside a goal takes nearly all its speed.
  [[nodiscard]] Ball kept(const Point3<Field>& before, Ball ball, double radius) const;

  /// Inside the lines, by at least `margin` (m; negative: so far outside).
  [[nodiscard]] bool is_inside(const Point<Field>& p_F, double margin) const;

  /// The place nearest to `p_F` that lies inside the lines by `margin`.
  [[nodiscard]] Point<Field> clamped(const Point<Field>& p_F, double margin) const;

  /// A place given as shares of half the length and half the width, from the centre.
  [[nodiscard]] Point<Field> at(double along, double across) const {
    return {centre_.x + along * half_length_, centre_.y + across * half_width_};
  }

  /// The middle of the goal line on the side of positive (1) or negative (-1) x.
  [[nodiscard]] Point<Field> goal(double side) const { return at(side, 0.0); }

  [[nodiscard]] double half_length() const { return half_length_; }

  [[nodiscard]] double half_width() const { return half_width_; }

 private:
  /// A goal's volume: g counts from the line outwards, w from the middle sideways.
  struct Net {
    Eigen::Vector2d middle;
    Eigen::Vector2d outwards;
    double half_width{0.0};
    double depth{0.0};
    double height{0.0};

    /// (g, w, z)
    [[nodiscard]] Eigen::Vector3d local(const Eigen::Vector3d& vector, bool is_point) const;
    [[nodiscard]] Eigen::Vector3d global(const Eigen::Vector3d& local, bool is_point) const;
  };

  static void meet_net(const Net& net, const Point3<Field>& before, Ball& ball, double radius);
  void meet_boards(Ball& ball, double radius) const;

  double half_length_;
  double half_width_;
  double surround_;
  Point<Field> centre_;
  std::vector<Net> nets_;
};

}  // namespace teamsight::sim
