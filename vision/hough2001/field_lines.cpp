// vision/hough2001/field_lines.cpp: families of lines, their distances, relevance.
#include "vision/hough2001/field_lines.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teamsight::vision {

namespace {

constexpr double kSameLine = 0.02;  // m
constexpr double kAngleWidth = 3.0 * std::numbers::pi / 180.0;
constexpr double kDistanceWidth = 0.15;  // m
constexpr double kMostRelevant = 100.0;

void add(std::vector<double>& places, double place) {
  const bool is_known = std::ranges::any_of(
      places, [&](double known) { return std::abs(known - place) < kSameLine; });
  if (!is_known) places.push_back(place);
}

double triangle(double off, double width) {
  return kMostRelevant * std::max(0.0, 1.0 - off / width);
}

}  // namespace

FieldLines field_lines_of(const FieldModel& field) {
  FieldLines lines;
  for (const FieldLine& line : field.lines) {
    if (line.family == LineFamily::kVertical) add(lines.vertical, line.from.x - field.centre.x);
    if (line.family == LineFamily::kHorizontal) add(lines.horizontal, line.from.y - field.centre.y);
  }
  for (std::vector<double>* family : {&lines.vertical, &lines.horizontal}) {
    std::ranges::sort(*family);
    for (std::size_t i = 0; i < family->size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) add(lines.gaps, (*family)[i] - (*family)[j]);
    }
  }
  return lines;
}

double relevance_of_angle(double delta_phi) {
  return triangle(std::min(delta_phi, std::numbers::pi - delta_phi), kAngleWidth);
}

double relevance_of_distance(const FieldLines& lines, double delta_rho) {
  double nearest = 1e9;
  for (const double gap : lines.gaps) nearest = std::min(nearest, std::abs(gap - delta_rho));
  return triangle(nearest, kDistanceWidth);
}

}  // namespace teamsight::vision
