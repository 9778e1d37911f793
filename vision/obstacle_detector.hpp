// vision/obstacle_detector.hpp: what stands on the carpet, and how far the carpet is free.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/sighting.hpp"
#include "vision/camera_model.hpp"
#include "vision/radial_scan.hpp"
#include "vision/scan_lines.hpp"

namespace teamsight::vision {

/// How far the floor is free along one line of sight.
struct FreeSpace {
  double azimuth{0.0};   ///< in R; rad
  double distance{0.0};  ///< m; up to there nothing stands
  bool blocked{false};   ///< something stands there; else the view simply ends

  friend bool operator==(const FreeSpace&, const FreeSpace&) = default;
};

/// What an obstacle most probably is, by its width.
enum class ObstacleKind : std::uint8_t { kRobot, kLegs };

/// Where a frame's image shows an obstacle; the pixel side of an ObstacleSighting.
struct ObstaclePixels {
  double u_px{0.0};  ///< its foot: the middle of the part nearest to the image centre
  double v_px{0.0};
  ObstacleKind kind{ObstacleKind::kRobot};
  ColourClass shirt{ColourClass::kNone};  ///< the commonest strong colour above its foot
  /// Some carpet is seen behind it on both sides; else it may be part of what surrounds the carpet.
  bool on_carpet{true};

  friend bool operator==(const ObstaclePixels&, const ObstaclePixels&) = default;
};

/// An obstacle on both sides of the lens.
struct ObstacleCandidate {
  ObstacleSighting sighting;
  ObstaclePixels pixels;
  double azimuth{0.0};   ///< of the middle of its foot in R; rad
  double distance{0.0};  ///< of its foot; m
};

/// What an obstacle may look like.
struct ObstacleRules {
  double robot_radius{0.25};  ///< m; much wider things are walls
};

/// Walks outwards along each radial line until the carpet ends in something dark or strongly
/// coloured, and joins neighbouring lines whose feet belong together. What does not stand out
/// before the carpet's own end (walls, posts, nets, furniture) is none. Its buffers are its only
/// state.
class ObstacleDetector {
 public:
  ObstacleDetector(const ObstacleRules& rules, const ScanLines& lines, const CameraModel& model);

  /// @param lines those of the constructor
  /// @return nearest first, at most kMaxObstacleSightings; valid until the next call
  [[nodiscard]] std::span<const ObstacleCandidate> find(const RadialScan& scan,
                                                        const ScanLines& lines);

  /// Of the last frame, one per radial line, by image direction.
  [[nodiscard]] std::span<const FreeSpace> free_space() const { return free_; }

 private:
  /// What one radial line runs into; places are pixels from the image centre.
  struct Foot {
    double azimuth{0.0};
    double distance{0.0};  // of the foot, m
    double depth{0.0};     // metres of floor per pixel there
    float u{0.0F};
    float v{0.0F};
    float radius{0.0F};      // of the foot
    float carpet_end{0.0F};  // from there on nothing is carpet any more
    std::uint16_t index{0};  // of the radial line
    bool stands{false};      // something dark or coloured has its foot on the carpet
  };

  /// Neighbouring lines, by index into feet_; `last` included, both may pass the end.
  struct Group {
    std::size_t first{0};
    std::size_t last{0};
  };

  [[nodiscard]] Foot foot_of(const RadialScan& scan,
                             const ScanLines& lines,
                             std::size_t index) const;
  [[nodiscard]] std::size_t standing_in(const Group& group) const;

  [[nodiscard]] const Foot& foot(std::size_t i) const { return feet_[i % feet_.size()]; }

  [[nodiscard]] bool joined(const Foot& a, const Foot& b) const;
  [[nodiscard]] double angle_of(const Group& group) const;
  [[nodiscard]] double width_of(const Group& group) const;
  [[nodiscard]] std::size_t nearest_in(const Group& group) const;
  [[nodiscard]] Eigen::Vector2d front_of(const Group& group) const;
  /// How far, in pixels, the view goes on beside the group; the smaller and the larger side.
  [[nodiscard]] std::pair<double, double> prominence(const Group& group) const;
  void collect_groups();
  /// Where two obstacles side by side part: the deepest place between their nearest ones; `last`
  /// if there is none.
  [[nodiscard]] std::size_t valley_in(const Group& group) const;
  void split(const Group& group);
  void join_legs();
  void add(const Group& group, const RadialScan& scan, const ScanLines& lines);
  [[nodiscard]] ColourClass shirt_of(const Group& group,
                                     const RadialScan& scan,
                                     const ScanLines& lines) const;

  ObstacleRules rules_;
  Pixel centre_;
  std::vector<double> azimuths_;    // of the radial lines
  std::vector<std::uint8_t> runs_;  // of each radial sample: so many decide what stands there
  double spacing_{0.0};             // of the lines; rad
  std::vector<Foot> feet_;
  std::vector<Group> groups_;
  std::vector<FreeSpace> free_;
  std::vector<ObstacleCandidate> found_;
};

}  // namespace teamsight::vision
