// vision/calibration/colour_samples.hpp: colour classes from clicked pixels, and from the field's
// own white and green.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/result.hpp"
#include "vision/camera_model.hpp"
#include "vision/camera_parameters.hpp"
#include "vision/image.hpp"

namespace teamsight::vision {

/// Pixels of one place that somebody says show this class; kWhite and kBlack are allowed.
struct LabelledColours {
  ColourClass colour{ColourClass::kNone};
  std::vector<SampledColour> pixels;
};

/// Reads the pixels within `radius_px` of a place.
///
/// @return nothing if none of them is in the image
[[nodiscard]] std::vector<SampledColour> colours_around(const ImageView& image,
                                                        const Pixel& place,
                                                        double radius_px);

/// Which two classes look the same.
struct ColourConflict {
  ColourClass a{ColourClass::kNone};
  ColourClass b{ColourClass::kNone};
  double distance{0.0};  ///< of their samples in the chroma plane
};

/// Makes the classes of a camera from labelled pixels.
///
/// Every place counts alike, however many pixels it has: a near ball says no more than a far one.
/// Each class that was labelled gets one sector of hues: nine tenths of its pixels and 15 degrees
/// on either side, as pale as half of its palest tenth; where two of them meet, the border is half
/// way. A class that is mostly grey gets a disc: the median chroma, as wide as nine tenths of its
/// pixels scatter and a half more. Classes that were not labelled stay, asked after the labelled
/// ones, and their discs leave out what was labelled. White and black set the luminance borders,
/// half way to the carpet's. Two classes whose medians are nearer than the noise cannot be told
/// apart.
///
/// @param places  several of a class are welcome
/// @pre none is empty
/// @return the classes, or the first two that look the same
[[nodiscard]] Result<ColourParameters, ColourConflict> colours_from(
    const ColourParameters& before, const std::vector<LabelledColours>& places);

/// Finds the carpet as the most frequent chroma of the floor, and the paint as what is much
/// brighter and not saturated, without asking any class.
///
/// @param inner_px, outer_px  radii between which the image shows floor
/// @return nothing if no chroma stands out, nothing is brighter than it, or the paint is saturated
[[nodiscard]] std::optional<FieldColours> field_colours(const ImageView& image,
                                                        const Pixel& centre,
                                                        double inner_px,
                                                        double outer_px);

/// Carries classes over to another light: the gains of red, green and blue that take grey to the
/// white that is seen now; the green that is seen now replaces the carpet's sample.
///
/// @param before  for a light in which white is grey (u = v = 128)
[[nodiscard]] ColourParameters balanced(const ColourParameters& before, const FieldColours& now);

}  // namespace teamsight::vision
