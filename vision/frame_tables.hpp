// vision/frame_tables.hpp: what the detectors look at.
#pragma once

#include "vision/carpet_hull.hpp"
#include "vision/colour_classes.hpp"
#include "vision/pixel_reader.hpp"
#include "vision/radial_scan.hpp"
#include "vision/ray_table.hpp"
#include "vision/scan_lines.hpp"

namespace teamsight::vision {

/// One frame, and the tables of its camera.
struct FrameTables {
  const PixelReader& pixels;
  const ColourClasses& colours;
  const ScanLines& lines;
  const RayTable& rays;
  const RadialScan& scan;  ///< of the same frame
  const CarpetHull& hull;  ///< of that
};

}  // namespace teamsight::vision
