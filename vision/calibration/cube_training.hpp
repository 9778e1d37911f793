// vision/calibration/cube_training.hpp: the RGB cube's three planes, learnt from labelled pixels.
#pragma once

#include <optional>
#include <vector>

#include "vision/calibration/colour_samples.hpp"
#include "vision/camera_parameters.hpp"
#include "vision/image.hpp"

namespace teamsight::vision {

/// Puts each class at a vertex of the RGB cube and each of the cube's three planes between the
/// vertices on its two sides, by logistic regression on red, green and blue; all classes count
/// alike.
///
/// A class's vertex is its own colour; the ball's is the one of those that are left whose hue is
/// most like its pixels'. Vertices without pixels show nothing.
///
/// @param places  several of a class are welcome
/// @pre none is empty
/// @return nothing unless there are kGreen, kWhite and kBlack, and for the ball a vertex is left
[[nodiscard]] std::optional<CubeParameters> train_cube(const std::vector<LabelledColours>& places);

/// What a camera's classes say of an image: one place for each class that shows, with all its
/// pixels between the mask's radii and outside its polygons.
///
/// @pre the image has the camera's size
[[nodiscard]] std::vector<LabelledColours> labelled_by_classes(const ImageView& image,
                                                               const CameraParameters& camera);

}  // namespace teamsight::vision
