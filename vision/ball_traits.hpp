// vision/ball_traits.hpp: what tells a ball from other things of its colour.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "vision/ball_blob.hpp"
#include "vision/camera_model.hpp"
#include "vision/frame_tables.hpp"
#include "vision/mirror_parts.hpp"

namespace teamsight::vision {

/// In the order of BallTraits.
inline constexpr std::array<std::string_view, 6> kBallTraitNames{
    "too_small",      // square of the logarithm of its radius over a ball's on the floor there
    "too_large",      // the same where it is larger: it may be in the air
    "roundness",      // smaller over larger spread of its directions
    "ground",         // share of carpet, and half of that of paint, around it
    "inside_carpet",  // from its middle outwards to the carpet's convex hull; 20 px, at most 2
    "contrast",       // logarithm of the distance in chroma from what is around it
};

inline constexpr std::size_t kBallTraits = kBallTraitNames.size();
inline constexpr std::size_t kInsideCarpet = 4;
static_assert(kBallTraitNames[kInsideCarpet] == "inside_carpet");
using BallTraits = std::array<double, kBallTraits>;

/// One frame as the traits need it.
struct BallTraitSource {
  const FrameTables& frame;
  /// Of each pixel; 0 where own body and mirror hide the world.
  std::span<const float> solid_angle;
  const MirrorParts& parts;
  Pixel centre;             ///< of the mirror in the image
  double near_px{0.0};      ///< from there, to where a ball may touch the own body
  double ball_radius{0.0};  ///< m
};

/// A blob that its mirror's part cuts has the size and the roundness of the cone through the rest
/// of its outline. In a further part of the mirror, where the carpet ends is asked of the inner
/// one.
///
/// @pre the blob has pixels
[[nodiscard]] BallTraits traits_of(const BallBlob& blob, const BallTraitSource& source);

/// Of a ball on the floor whose middle is seen there, hidden or not; px. 0 where none can be seen.
[[nodiscard]] double expected_radius(const RayTable& rays, double ball_radius, const Pixel& middle);

}  // namespace teamsight::vision
