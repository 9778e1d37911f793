// vision/ring_calibration.hpp: a radial table from a picture of rings at known distances.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/result.hpp"
#include "vision/camera_model.hpp"
#include "vision/camera_parameters.hpp"
#include "vision/image.hpp"

namespace teamsight::vision {

/// What is known before the rings are looked for.
struct RingRules {
  Pixel centre;                       ///< of the rings in this picture, within some 15 px
  std::vector<double> distances;      ///< of the rings' paint, growing; m
  std::vector<MaskedSector> sectors;  ///< image directions in which the camera sees its struts
  double mirror_height{0.67};         ///< of the virtual viewpoint; m; for the check only
  double inner_radius_px{60.0};       ///< nearer there is only own body
};

/// One ring as found.
struct FoundRing {
  RingMark mark;              ///< sigma_px: one direction's radius against the circle
  double sigma_mean_px{0.0};  ///< of the radius itself, from all directions
  std::size_t directions{0};  ///< in which it was seen
  double left_out_px{0.0};    ///< radius predicted from the other rings minus the found one
};

/// What is probably wrong when the rings contradict each other.
enum class RingTrouble : std::uint8_t {
  kNoRing,   ///< that one is none: without it the others agree
  kMissing,  ///< the one at that distance was not found: without the distance they agree
  kUnclear,  ///< no single one; that one is farthest from where the others put it
};

struct RingDoubt {
  RingTrouble trouble{RingTrouble::kUnclear};
  std::size_t ring{0};  ///< kMissing: of the rules' distances
};

struct RingCalibration {
  Pixel centre;  ///< of the rings, as fitted
  std::vector<FoundRing> rings;
  std::optional<RingDoubt> doubt;  ///< nothing: the rings agree, a table may be made of them
};

enum class RingFailure : std::uint8_t {
  kNotGrey,  ///< the picture is not whole, or not of luminance alone
  kTooFew,   ///< fewer than three rings were found
};

/// Finds rings in a picture and measures their radii.
///
/// Bright bumps along 720 directions vote for radii; circles with a common centre are fitted with
/// medians, so that struts and dirt do not matter. The k-th ring outwards is the k-th distance;
/// rings that run together beyond are left out. Where one ring lies far from where the others put
/// it, the outcome is in doubt.
[[nodiscard]] Result<RingCalibration, RingFailure> calibrate_rings(const ImageView& image,
                                                                   const RingRules& guess);

}  // namespace teamsight::vision
