// vision/calibration/class_training.hpp: a table of colour classes, learnt from labelled pixels.
#pragma once

#include <vector>

#include "vision/calibration/colour_samples.hpp"
#include "vision/camera_parameters.hpp"

namespace teamsight::vision {

/// How far a sample speaks.
struct ClassTrainingRules {
  double reach{6.0};   ///< sigma of a sample's neighbourhood in y, u and v; grey levels
  double least{0.01};  ///< of the density that samples of one colour have: fewer say nothing
};

/// Gives each colour to the class whose samples lie densest around it (Parzen windows, all classes
/// equally probable). Where there are hardly any the colour keeps the class that `before` gives
/// it. Samples of kWhite and kBlack make a colour no class, as luminance tells those two.
///
/// Takes some 0.1 s per class.
///
/// @param before  its table, if it has one, is trained further
/// @param places  several of a class are welcome, and count alike
/// @pre none is empty
[[nodiscard]] ClassTable train_classes(const ColourParameters& before,
                                       const std::vector<LabelledColours>& places,
                                       const ClassTrainingRules& rules = {});

}  // namespace teamsight::vision
