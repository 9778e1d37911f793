// vision/obstacle_detector.hpp: what stands on the carpet, and how far the carpet is free.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/sighting.hpp"
#include "vision/camera_model.hpp"
#include "vision/carpet_hull.hpp"
#include "vision/obstacle_feet.hpp"
#include "vision/obstacle_model.hpp"
#include "vision/obstacle_traits.hpp"
#include "vision/radial_scan.hpp"
#include "vision/scan_lines.hpp"
#include "vision/shirt_votes.hpp"
#include "vision/team_shirts.hpp"

namespace teamsight::vision {

/// How far the floor is free along one line of sight.
struct FreeSpace {
  double azimuth{0.0};   ///< in R; rad
  double distance{0.0};  ///< m; up to there nothing stands
  bool blocked{false};   ///< something stands there; else the view simply ends

  friend bool operator==(const FreeSpace&, const FreeSpace&) = default;
};

/// What an obstacle most probably is: a robot by its model, else somebody's legs.
enum class ObstacleKind : std::uint8_t { kRobot, kLegs };

/// Where a frame's image shows an obstacle; the pixel side of an ObstacleSighting.
struct ObstaclePixels {
  double u_px{0.0};  ///< its foot: the middle of the part nearest to the image centre
  double v_px{0.0};
  ObstacleKind kind{ObstacleKind::kRobot};
  ColourClass shirt{ColourClass::kNone};  ///< the commonest strong colour above its foot
  ObstacleTraits traits{};
  ShirtVotes votes{};  ///< a robot's lines that show a team's shirt
  /// Its foot lies within the convex hull of the carpet that is seen.
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
  ObstacleModel model{trained_obstacle_model()};
  TeamShirts shirts{};
};

/// Walks outwards along each radial line until the carpet ends in something dark or strongly
/// coloured, and joins neighbouring lines whose feet belong together. What does not stand out
/// before the carpet's own end (walls, posts, nets, furniture) is none. Its buffers are its only
/// state.
class ObstacleDetector {
 public:
  ObstacleDetector(const ObstacleRules& rules, const ScanLines& lines, const CameraModel& model);

  /// @param lines those of the constructor
  /// @param hull of the same scan
  /// @return nearest first, as many as there are; valid until the next call
  [[nodiscard]] std::span<const ObstacleCandidate> find(const RadialScan& scan,
                                                        const ScanLines& lines,
                                                        const CarpetHull& hull);

  /// Of the last frame, one per radial line, by image direction.
  [[nodiscard]] std::span<const FreeSpace> free_space() const { return free_; }

 private:
  /// Too little to be anything by itself.
  struct LegPart {
    ObstacleCandidate candidate;
    std::size_t lines{0};  ///< that stand
  };

  [[nodiscard]] Foot foot_of(const RadialScan& scan,
                             const ScanLines& lines,
                             std::size_t index) const;
  void join_parts();
  void join_legs();
  void add(const FootGroup& group, const TraitSource& source);
  /// Legs with their foot at the group's; a robot has to be made of them.
  [[nodiscard]] ObstacleCandidate candidate_of(const FootGroup& group,
                                               double width,
                                               const CarpetHull& hull) const;
  [[nodiscard]] ColourClass shirt_of(const FootGroup& group,
                                     const RadialScan& scan,
                                     const ScanLines& lines) const;

  ObstacleRules rules_;
  Pixel centre_;
  std::vector<double> azimuths_;    // of the radial lines
  std::vector<std::uint8_t> runs_;  // of each radial sample: so many decide what stands there
  Feet feet_;
  std::vector<FootGroup> groups_;
  std::vector<FreeSpace> free_;
  std::vector<ObstacleCandidate> found_;
  std::vector<LegPart> parts_;
};

}  // namespace teamsight::vision
