// bench/locate_score/paper.hpp: the founding paper's experiment (section 4.6), made again.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/locate_score/cases.hpp"
#include "bench/locate_score/tally.hpp"
#include "geometry/pose.hpp"

namespace teamsight::locate_score {

/// One image of the experiment.
struct PaperImage {
  std::string spot;  ///< a place whose coordinates are known from the field file
  Pose<Field, Robot> truth;
};

/// Ninety images: fifteen known spots of the field, six headings at each.
[[nodiscard]] std::vector<PaperImage> paper_images(const FieldModel& field, std::uint32_t seed);

/// The methods that the paper gives or compares itself with, on the same ninety rendered images
/// through cameras with a calibration's remainder: "hough2001" on the images themselves,
/// "triangulation" (bearings to upright edges, extended Kalman filter), "markov" (grid, from no
/// knowledge), "track", "rprop10" and "mcl500". Half of the field: as each method says; those that
/// cannot know count modulo symmetry.
[[nodiscard]] CaseResult run_paper(const CaseOptions& options,
                                   const CalibrationRemainder& remainder);

}  // namespace teamsight::locate_score
