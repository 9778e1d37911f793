// tools/calibration_report.cpp: quantiles, knobs, and the residual map.
#include "tools/calibration_report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace teamsight::tools {

namespace {

using nlohmann::ordered_json;
using vision::LineCalibration;
using vision::PaintMiss;
using vision::ViewResult;

using Misses = std::vector<PaintMiss>;

double quantile(std::vector<double> values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

ordered_json sizes_of(const Misses& misses) {
  if (misses.empty()) return nullptr;
  std::vector<double> metres;
  std::vector<double> pixels;
  for (const PaintMiss& miss : misses) {
    metres.push_back(std::abs(miss.distance));
    pixels.push_back(std::abs(miss.distance_px));
  }
  return {{"points", misses.size()},
          {"median_m", quantile(metres, 0.5)},
          {"p90_m", quantile(metres, 0.9)},
          {"median_px", quantile(pixels, 0.5)},
          {"p90_px", quantile(pixels, 0.9)}};
}

Misses all_of(const LineCalibration& result, Misses ViewResult::*which) {
  Misses all;
  for (const ViewResult& view : result.views) {
    if (view.used) all.insert(all.end(), (view.*which).begin(), (view.*which).end());
  }
  return all;
}

const char* refusal_name(vision::LineRefusal refusal) {
  switch (refusal) {
    case vision::LineRefusal::kNoPosture:
      return "no_posture";
    case vision::LineRefusal::kDoesNotFit:
      return "does_not_fit";
    case vision::LineRefusal::kNotDetermined:
      break;
  }
  return "not_determined";
}

// ---- the residual map --------------------------------------------------------------------------

constexpr double kShown = 6.0;           // px; what lies farther off is no error of the camera
constexpr std::size_t kFewestInBin = 4;  // less says nothing
constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();

/// How misses are sorted into bins along the x axis of a panel.
struct Bins {
  double low{0.0};
  double high{1.0};
  std::size_t count{36};
  double (*place)(const PaintMiss&){nullptr};
};

std::vector<std::vector<double>> sorted_in(const Misses& misses, const Bins& bins) {
  std::vector<std::vector<double>> sorted(bins.count);
  for (const PaintMiss& miss : misses) {
    if (std::abs(miss.radial_px) > kShown) continue;
    const double share = (bins.place(miss) - bins.low) / (bins.high - bins.low);
    const auto bin = static_cast<std::ptrdiff_t>(share * static_cast<double>(bins.count));
    if (bin < 0 || bin >= static_cast<std::ptrdiff_t>(bins.count)) continue;
    sorted[static_cast<std::size_t>(bin)].push_back(miss.radial_px);
  }
  return sorted;
}

void draw(const Misses& misses,
          const Bins& bins,
          const std::string& label,
          const std::string& colour,
          plot::Panel& panel) {
  plot::Line middle{.label = label, .colour = colour, .points = {}, .width_px = 2.4};
  plot::Line lower{.label = "", .colour = colour, .points = {}, .width_px = 1.0, .opacity = 0.6};
  plot::Line upper = lower;
  const auto sorted = sorted_in(misses, bins);
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double width = (bins.high - bins.low) / static_cast<double>(bins.count);
    const double x = bins.low + (static_cast<double>(i) + 0.5) * width;
    const bool enough = sorted[i].size() >= kFewestInBin;
    middle.points.push_back({x, enough ? quantile(sorted[i], 0.5) : kNowhere});
    lower.points.push_back({x, enough ? quantile(sorted[i], 0.1) : kNowhere});
    upper.points.push_back({x, enough ? quantile(sorted[i], 0.9) : kNowhere});
  }
  for (plot::Line* line : {&lower, &upper, &middle}) panel.lines.push_back(std::move(*line));
}

plot::Panel panel_of(const LineCalibration& result,
                     const Bins& bins,
                     const std::string& title,
                     const std::string& axis) {
  plot::Panel panel;
  panel.title = title;
  panel.x = {axis, bins.low, bins.high};
  panel.y = {"line point beyond the paint, radially (px)", -4.0, 4.0};
  panel.lines.push_back({.label = "",
                         .colour = "#999999",
                         .points = {{bins.low, 0.0}, {bins.high, 0.0}},
                         .width_px = 1.0});
  draw(all_of(result, &ViewResult::before), bins, "before", plot::series_colour(1), panel);
  draw(all_of(result, &ViewResult::after), bins, "after", plot::series_colour(0), panel);
  return panel;
}

std::string knobs_left_open(const LineCalibration& result) {
  std::string names;
  for (const vision::KnobResult& knob : result.knobs) {
    if (knob.share_of_views() > 0.5) continue;
    names += (names.empty() ? "" : ", ") + std::string(vision::name_of(knob.prior.knob));
  }
  return names.empty() ? "none alone" : names;
}

}  // namespace

ordered_json view_report(const std::string& file, const ViewResult& view) {
  ordered_json line;
  line["image"] = file;
  line["used"] = view.used;
  line["x_m"] = view.used ? ordered_json(view.X_FR.x()) : ordered_json();
  line["y_m"] = view.used ? ordered_json(view.X_FR.y()) : ordered_json();
  line["theta_rad"] = view.used ? ordered_json(view.X_FR.theta()) : ordered_json();
  line["inlier_ratio"] = view.inlier_ratio;
  line["before"] = sizes_of(view.before);
  line["after"] = sizes_of(view.after);
  return line;
}

ordered_json calibration_report(const LineCalibration& result, double reach) {
  ordered_json line;
  const auto used = std::ranges::count(result.views, true, &ViewResult::used);
  line["views"] = result.views.size();
  line["views_used"] = used;
  line["refused"] = result.refusal ? ordered_json(refusal_name(*result.refusal)) : ordered_json();
  line["before"] = sizes_of(all_of(result, &ViewResult::before));
  line["after"] = sizes_of(all_of(result, &ViewResult::after));
  line["reach_m"] = reach;
  line["ground_sigma_m"] =
      result.knobs.empty() ? ordered_json() : ordered_json(result.ground_sigma);
  line["parameters"] = ordered_json::array();
  for (const vision::KnobResult& knob : result.knobs) {
    line["parameters"].push_back({{"name", vision::name_of(knob.prior.knob)},
                                  {"change", knob.turn},
                                  {"sigma", knob.sigma},
                                  {"sigma_before", knob.prior.sigma},
                                  {"share_of_views", knob.share_of_views()}});
  }
  line["cov"] = nullptr;
  if (result.camera.calibration) line["cov"] = result.camera.calibration->cov;
  return line;
}

plot::Figure residual_figure(const LineCalibration& result) {
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  double farthest = 1.0;
  for (const PaintMiss& miss : all_of(result, &ViewResult::after)) {
    farthest = std::max(farthest, miss.radius_px);
  }
  const Bins around{-180.0, 180.0, 36, [](const PaintMiss& miss) {
                      return kDegrees * miss.direction;
                    }};
  const Bins outwards{0.0, 10.0 * std::ceil(0.1 * farthest), 24, [](const PaintMiss& miss) {
                        return miss.radius_px;
                      }};
  plot::Figure figure;
  figure.title = "Line points against the paint";
  figure.subtitle =
      "thick: median; thin: 10 % and 90 %. A calibrated camera stays at zero all around";
  figure.panels.push_back(panel_of(
      result, around, "by direction", "direction in the picture (deg, counter-clockwise)"));
  figure.panels.push_back(panel_of(result, outwards, "by radius", "radius in the picture (px)"));
  return figure;
}

std::string refusal_text(const LineCalibration& result, const vision::LineCalibrationRules& rules) {
  switch (result.refusal.value_or(vision::LineRefusal::kNotDetermined)) {
    case vision::LineRefusal::kNoPosture:
      return "no view's line points lie like the lines of this field: check the field file, the "
             "camera file's centre and mounting, and the light";
    case vision::LineRefusal::kDoesNotFit:
      return "no turn of this camera puts the line points on the paint: another mirror or another "
             "field than the files say";
    case vision::LineRefusal::kNotDetermined:
      break;
  }
  return fmt::format(
      "the views do not determine the camera: the floor up to {:.1f} m would be known to {:.0f} mm "
      "(wanted: {:.0f} mm); open: {}; add views from other places, with lines all around",
      rules.reach,
      1e3 * result.ground_sigma,
      1e3 * rules.max_ground_sigma,
      knobs_left_open(result));
}

}  // namespace teamsight::tools
