// tools/score_histogram.cpp: bins, bars, curves.
#include "tools/score_histogram.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

#include "tools/svg_plot.hpp"

namespace teamsight::tools {

namespace {

constexpr int kBins = 25;
constexpr double kDegrees = 180.0 / std::numbers::pi;

plot::Panel panel_of(const std::string& axis, const std::vector<double>& errors) {
  double mean = 0.0;
  for (const double error : errors) mean += error / static_cast<double>(errors.size());
  double square = 0.0;
  for (const double error : errors) square += (error - mean) * (error - mean);
  const double sigma =
      std::sqrt(square / static_cast<double>(std::max<std::size_t>(1, errors.size() - 1)));
  double reach = 3.5 * std::max(sigma, 1e-6) + std::abs(mean);
  for (const double error : errors) reach = std::max(reach, 1.02 * std::abs(error));
  const double width = 2.0 * reach / kBins;
  std::vector<int> counts(kBins, 0);
  for (const double error : errors) {
    const auto bin = static_cast<int>((error + reach) / width);
    ++counts[static_cast<std::size_t>(std::clamp(bin, 0, kBins - 1))];
  }
  plot::Panel panel;
  panel.title = fmt::format("mean {:.3g}, standard deviation {:.3g}", mean, sigma);
  panel.x = {axis, -reach, reach, false};
  const double top = static_cast<double>(*std::ranges::max_element(counts));
  const double height =
      static_cast<double>(errors.size()) * width / (sigma * std::sqrt(2.0 * std::numbers::pi));
  panel.y = {"images", 0.0, 1.1 * std::max(top, height), false};
  panel.width_px = 380.0;
  for (int bin = 0; bin < kBins; ++bin) {
    const double left = -reach + bin * width;
    const auto count = static_cast<double>(counts[static_cast<std::size_t>(bin)]);
    panel.areas.push_back(
        {"#9db8d2", {{left, 0.0}, {left, count}, {left + width, count}, {left + width, 0.0}}});
  }
  plot::Line curve;
  curve.label = "normal distribution";
  curve.colour = plot::series_colour(1);
  for (int i = 0; i <= 200; ++i) {
    const double x = -reach + 2.0 * reach * i / 200.0;
    const double z = (x - mean) / sigma;
    curve.points.push_back({x, height * std::exp(-0.5 * z * z)});
  }
  panel.lines.push_back(curve);
  return panel;
}

}  // namespace

std::string error_histogram(const std::string& method, const locate_score::Tally& tally) {
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> theta;
  for (const Eigen::Vector3d& error : tally.errors()) {
    x.push_back(1e3 * error.x());
    y.push_back(1e3 * error.y());
    theta.push_back(kDegrees * error.z());
  }
  plot::Figure figure;
  figure.title = "Errors of " + method + " in the paper's experiment";
  figure.subtitle = fmt::format(
      "{} of {} images; the paper's standard deviations are 100 mm, 92 mm and 1.8 degrees",
      tally.errors().size(),
      tally.count());
  figure.columns = 3;
  figure.panel_height_px = 260.0;
  figure.panels = {panel_of("error in x, mm", x),
                   panel_of("error in y, mm", y),
                   panel_of("error in theta, degrees", theta)};
  return plot::to_svg(figure);
}

}  // namespace teamsight::tools
