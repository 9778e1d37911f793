// vision/obstacle_detector.hpp: what stands on the carpet, and how far the carpet is free.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/sighting.hpp"
#include "vision/camera_model.hpp"
#include "vision/colour_classes.hpp"
#include "vision/pixel_reader.hpp"
#include "vision/scan_lines.hpp"

namespace teamsight::vision {

/// How far the floor is free along one line of sight.
struct FreeSpace {
  double azimuth{0.0};   ///< in R; rad
  double distance{0.0};  ///< m; up to there nothing stands
  bool blocked{false};   ///< something stands there; else the view simply ends

  friend bool operator==(const FreeSpace&, const FreeSpace&) = default;
};

/// An obstacle on both sides of the lens.
struct ObstacleCandidate {
  ObstacleSighting sighting;
  double u_px{0.0};  ///< its foot
  double v_px{0.0};
  double azimuth{0.0};   ///< of the middle of its foot in R; rad
  double distance{0.0};  ///< of its foot; m
};

/// What an obstacle may look like.
struct ObstacleRules {
  double line_width{0.125};   ///< m; a bright run not longer than twice this may be paint
  double robot_radius{0.25};  ///< m; wider things than six of it are walls
};

/// Walks outwards along each radial line until the carpet ends in something dark or coloured.
/// Its buffers are its only state.
class ObstacleDetector {
 public:
  explicit ObstacleDetector(const ObstacleRules& rules) : rules_(rules) {}

  /// @param model the camera that `lines` was made for
  /// @return nearest first, at most kMaxObstacleSightings; valid until the next call
  [[nodiscard]] std::span<const ObstacleCandidate> find(const PixelReader& pixels,
                                                        const ColourClasses& colours,
                                                        const ScanLines& lines,
                                                        const CameraModel& model);

  /// Of the last frame, one per radial line, by image direction.
  [[nodiscard]] std::span<const FreeSpace> free_space() const { return free_; }

 private:
  struct Foot {
    double azimuth{0.0};
    double distance{0.0};
    double depth{0.0};  // metres of floor per pixel there
    double u{0.0};
    double v{0.0};
    bool blocked{false};
  };

  void classify(const PixelReader& pixels,
                const ColourClasses& colours,
                std::span<const ScanSample> line);
  [[nodiscard]] Foot foot_of(std::span<const ScanSample> line) const;
  void group();
  void add(std::size_t first, std::size_t last);

  ObstacleRules rules_;
  std::vector<unsigned char>
      stands_;  // of each sample: 1 = something that is not floor, paint or ball
  std::vector<Foot> feet_;
  std::vector<FreeSpace> free_;
  std::vector<ObstacleCandidate> found_;
};

}  // namespace teamsight::vision
