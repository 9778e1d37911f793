// vision/goal_detector.hpp: goals behind the end of the carpet.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "vision/camera_model.hpp"
#include "vision/radial_scan.hpp"
#include "vision/scan_lines.hpp"

namespace teamsight::vision {

/// Something of a goal's colour and width that rises where the carpet ends.
struct SeenGoal {
  ColourClass colour{ColourClass::kNone};  ///< kBlue, kYellow or kWhite
  double azimuth{0.0};                     ///< of its middle in R; rad
  double left{0.0};                        ///< of its left edge, as seen from the robot; rad
  double right{0.0};
  std::optional<double> distance;  ///< m; nothing if its foot is hidden

  friend bool operator==(const SeenGoal&, const SeenGoal&) = default;
};

/// Looks for wide runs of blue, yellow or white behind the carpet. White walls look like white
/// goals; who knows the posture can tell. Its buffers are its only state.
class GoalDetector {
 public:
  GoalDetector(const ScanLines& lines, const CameraModel& model);

  /// @return widest first; valid until the next call
  [[nodiscard]] std::span<const SeenGoal> find(const RadialScan& scan, const ScanLines& lines);

 private:
  struct Behind {
    ColourClass colour{ColourClass::kNone};
    double distance{0.0};  // m, of the carpet's end there
    bool foot_seen{false};
  };

  [[nodiscard]] Behind behind(const RadialScan& scan, const ScanLines& lines, std::size_t i) const;
  void add(std::size_t first, std::size_t last);

  std::vector<double> azimuths_;
  std::vector<Behind> behind_;
  std::vector<SeenGoal> found_;
};

}  // namespace teamsight::vision
