// vision/ball_images.hpp: one ball that several parts of a mirror show.
#pragma once

#include <vector>

#include "vision/ball_detector.hpp"

namespace teamsight::vision {

/// Whether two parts of the mirror show one ball: both rays pass a place within a ball's radius and
/// their uncertainty, and from there a ball looks as large as it does in both.
[[nodiscard]] bool are_images_of_one(const BallCandidate& a,
                                     const BallCandidate& b,
                                     double ball_radius);

/// Of a ball's images in several parts keeps the one with the surer direction; it is as probably a
/// ball as the more probable of them.
void join_images(std::vector<BallCandidate>& found, double ball_radius);

}  // namespace teamsight::vision
