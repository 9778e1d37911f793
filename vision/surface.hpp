// vision/surface.hpp: what a sample shows, judged against the carpet beside it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "vision/camera_parameters.hpp"
#include "vision/pixel_reader.hpp"
#include "vision/scan_lines.hpp"

namespace teamsight::vision {

/// What one sample shows, judged against the carpet beside it: dark and bright mean darker and
/// brighter than that, so that a shaded corner or a vignetted rim changes nothing.
enum class Surface : std::uint8_t {
  kCarpet,
  kPaint,  ///< bright and without colour: lines, but also walls, nets and white shoes
  kDark,   ///< a robot's base, a shadowed leg, black furniture
  kShirt,  ///< a strong colour that neither carpet nor ball has
  kBall,   ///< the ball's colour
  kOther,  ///< wood, skin, grey walls
};

inline constexpr std::size_t kSurfaces = 6;

/// One sample, and the carpet it is judged against.
struct Look {
  ColourClass colour{ColourClass::kNone};
  float y{0.0F};           ///< luminance, grey levels
  float chroma{0.0F};      ///< distance from grey
  float carpet{0.0F};      ///< luminance of the carpet beside it
  float saturation{0.0F};  ///< of the frame's carpet: chroma over luminance
};

[[nodiscard]] Surface surface_of(const Look& look);

/// What was read of a row of samples, one of each for each of them.
struct ReadSamples {
  std::span<const ColourClass> classes;
  std::span<const std::uint8_t> luminance;
  std::span<const Chroma> chroma;
};

/// How far a chroma lies from grey, within 4 % of the Euclidean length.
[[nodiscard]] float distance_from_grey(Chroma chroma);

/// Of a CarpetLevel to a grey level.
inline constexpr int kLevelsPerGrey = 128;

/// Luminance of the carpet, up to 255 grey levels, in parts of one.
using CarpetLevel = std::int16_t;

/// How bright the carpet is beside each sample of each line.
///
/// A running level that begins with the frame's own and follows samples of carpet which are about
/// as bright as it already is.
///
/// @param lines   parts of the samples
/// @param start   luminance of the frame's carpet, grey levels
/// @param levels  one for each sample; only those of the lines are written
void follow_carpet(const ReadSamples& samples,
                   std::span<const ScanRange> lines,
                   float start,
                   std::span<CarpetLevel> levels);

/// surface_of for each sample.
///
/// @param levels      of the carpet beside each sample
/// @param saturation  of the frame's carpet
void judge_surfaces(const ReadSamples& samples,
                    std::span<const CarpetLevel> levels,
                    float saturation,
                    std::span<Surface> surfaces);

}  // namespace teamsight::vision
