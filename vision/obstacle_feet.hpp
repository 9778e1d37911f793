// vision/obstacle_feet.hpp: where each radial line runs into something, and groups of such lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace teamsight::vision {

/// What one radial line runs into; places are counted in its samples' lengths from the image
/// centre.
struct Foot {
  double azimuth{0.0};   ///< in R; rad
  double distance{0.0};  ///< of the foot, m
  double depth{0.0};     ///< metres of floor per sample there
  float u{0.0F};         ///< px
  float v{0.0F};
  float radius{0.0F};       ///< of the foot
  float carpet_end{0.0F};   ///< from there on nothing is carpet any more
  std::uint16_t index{0};   ///< of the radial line
  std::uint16_t sample{0};  ///< of that line, at the foot
  bool stands{false};       ///< something dark or coloured has its foot on the carpet
};

/// Neighbouring feet, by index; `last` included, both may pass the end.
struct FootGroup {
  std::size_t first{0};
  std::size_t last{0};
};

/// The feet of one frame, all around the robot.
class Feet {
 public:
  Feet() = default;

  /// @param lines    how many there will be
  /// @param spacing  of the lines; rad
  Feet(std::size_t lines, double spacing);

  void clear() { feet_.clear(); }

  void add(const Foot& foot) { feet_.push_back(foot); }

  [[nodiscard]] std::size_t size() const { return feet_.size(); }

  /// Indices go around: the foot after the last one is the first one.
  [[nodiscard]] const Foot& operator[](std::size_t i) const {
    while (i >= feet_.size()) i -= feet_.size();
    return feet_[i];
  }

  /// Whether both feet may be one thing's.
  [[nodiscard]] bool joined(const Foot& a, const Foot& b) const;

  /// Replaces `groups` by all things that stand, those side by side parted.
  void collect(double robot_radius, std::vector<FootGroup>& groups);

  [[nodiscard]] std::size_t standing_in(const FootGroup& group) const;
  [[nodiscard]] double angle_of(const FootGroup& group) const;  ///< rad
  [[nodiscard]] double width_of(const FootGroup& group) const;  ///< m
  /// The nearest foot that is not a single line's noise.
  [[nodiscard]] std::size_t nearest_in(const FootGroup& group) const;
  /// The middle of what is as near as that; px from the image's corner.
  [[nodiscard]] Eigen::Vector2d front_of(const FootGroup& group) const;

  /// How far, in pixels, the carpet goes on beside the group; the smaller and the larger side.
  [[nodiscard]] std::pair<double, double> prominence(const FootGroup& group) const;

 private:
  /// The radius of foot `i` of a group, or a larger one if it may be a single line's noise; that of
  /// what does not stand is larger than any.
  [[nodiscard]] float sure_radius(const FootGroup& group, std::size_t i) const;
  /// Fills `behind_` for the feet behind the group's second.
  void look_back(const FootGroup& group);
  [[nodiscard]] std::size_t valley_in(const FootGroup& group);
  void split(const FootGroup& group, double robot_radius, std::vector<FootGroup>& groups);

  std::vector<Foot> feet_;
  /// Of each foot of a group, from its first on: the radius of the nearest from there to the last.
  std::vector<float> behind_;
  double spacing_{0.0};
};

}  // namespace teamsight::vision
