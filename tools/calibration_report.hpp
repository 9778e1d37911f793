// tools/calibration_report.hpp: what a calibration from lines found, as JSON and as a drawing.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "tools/svg_plot.hpp"
#include "vision/calibration/line_calibration.hpp"

namespace teamsight::tools {

/// One view: where it was taken, and how its points lie before and after.
[[nodiscard]] nlohmann::ordered_json view_report(const std::string& file,
                                                 const vision::ViewResult& view);

/// All views together, the knobs and their covariance.
[[nodiscard]] nlohmann::ordered_json calibration_report(const vision::LineCalibration& result,
                                                        double reach);

/// The radial residuals over the direction and over the radius in the picture, before and after.
[[nodiscard]] plot::Figure residual_figure(const vision::LineCalibration& result);

/// Why there is no calibration and what to do about it; one line.
[[nodiscard]] std::string refusal_text(const vision::LineCalibration& result,
                                       const vision::LineCalibrationRules& rules);

}  // namespace teamsight::tools
