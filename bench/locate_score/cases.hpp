// bench/locate_score/cases.hpp: the cases of `teamsight score locate`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/locate_score/line_view.hpp"
#include "bench/locate_score/point_errors.hpp"
#include "bench/locate_score/spoils.hpp"
#include "bench/locate_score/tally.hpp"
#include "geometry/field_model.hpp"
#include "vision/camera_parameters.hpp"

namespace teamsight::locate_score {

/// What all cases share.
struct CaseOptions {
  vision::CameraParameters camera;
  FieldModel field;
  FieldModel other_field;  ///< for "other field size"
  std::size_t poses{1000};
  std::uint32_t seed{1};
  double pixel_noise_sigma{3.0};  ///< grey levels
  bool rivals{true};
};

/// One case, or a part of one, with what each method said.
struct CaseResult {
  std::string name;    ///< of the case: "noise", "hardware", "faults", "drive"
  std::string detail;  ///< of the part; empty if there is one only
  std::map<std::string, Tally> tallies;
  std::optional<PointErrors> points{};  ///< of rendered frames seen through an exact camera file
};

/// (a) Points drawn on the paint with independent errors: there the bound means what it says.
[[nodiscard]] CaseResult run_drawn_noise(const CaseOptions& options);

/// (a) Rendered frames with pixel noise, through a camera that is what its file says.
[[nodiscard]] CaseResult run_noise(const CaseOptions& options);

/// (b) Ten robots whose calibrated camera files are wrong by what calibration leaves.
[[nodiscard]] CaseResult run_hardware(const CaseOptions& options,
                                      const CalibrationRemainder& remainder);

/// (c) Hidden lines, false white, robots around, another field, a leaning head, glare: `poses`
/// each, seen through cameras as in (b), another one in each pose.
[[nodiscard]] std::vector<CaseResult> run_faults(const CaseOptions& options,
                                                 const CalibrationRemainder& remainder);

/// What became of the kidnappings, by one method.
struct Recoveries {
  std::size_t within_1s{0};  ///< right again, modulo symmetry, within a second, and stayed so
  double slowest_s{0.0};     ///< until right, of those found
};

/// What happened on drives beside the errors of single frames.
struct DriveResult {
  CaseResult frames;  ///< after the first second and apart from kidnappings
  std::size_t sequences{0};
  std::size_t kidnappings{0};
  std::map<std::string, Recoveries> recoveries;  ///< by method
  std::size_t wrong_halves{0};       ///< sequences that began on the wrong half, with a compass
  std::size_t halves_repaired{0};    ///< within five seconds
  std::size_t false_ok_episodes{0};  ///< `ok` for over 0.3 s while wrong by over 0.5 m
  double longest_false_ok_s{0.0};    ///< of sequences that begin on the right half
  std::size_t slips{0};              ///< noticed
};

/// (d) Drives of ten seconds with slipping wheels and a head that leans by 0.17 degrees per m/s^2,
/// seen through eyes as in (b), another one in each; every other one is kidnapped, every fifth
/// begins on the wrong half with a compass on board. A twenty-fifth of `poses` is their number.
[[nodiscard]] DriveResult run_drives(const CaseOptions& options,
                                     const CalibrationRemainder& remainder);

}  // namespace teamsight::locate_score
