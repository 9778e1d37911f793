// bench/locate_rivals/markov_grid.cpp: every cell, every heading.
#include "bench/locate_rivals/markov_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/angle.hpp"

namespace teamsight::locate_rivals {

namespace {

constexpr std::size_t kPoints = 60;  // weighed
constexpr double kAround = 2.5;      // cells around the best that the mean is taken of

struct Cell {
  Pose<Field, Robot> X_FR;
  double log_weight{0.0};
};

// log of the points' mixture by its tangents at both ends: a third of the time, the same maxima.
double log_likelihood(const DistanceTable& table,
                      const Eigen::Vector2d& place,
                      std::span<const Eigen::Vector2d> turned,
                      const MarkovParameters& parameters) {
  const double precision = 0.5 / (parameters.sigma_point * parameters.sigma_point);
  const double most = -std::log(parameters.fails);
  double sum = 0.0;
  for (const Eigen::Vector2d& p : turned) {
    const double d = table.distance(place + p);
    sum -= std::min(precision * d * d, most);
  }
  return parameters.independent * sum;
}

std::vector<Eigen::Vector2d> places_of(const FieldModel& field, double cell) {
  const auto columns = static_cast<int>(field.length / cell);
  const auto rows = static_cast<int>(field.width / cell);
  const Eigen::Vector2d corner =
      field.centre.vector() - Eigen::Vector2d(0.5 * field.length, 0.5 * field.width);
  std::vector<Eigen::Vector2d> places;
  for (int column = 0; column <= columns; ++column) {
    for (int row = 0; row <= rows; ++row) {
      places.emplace_back(corner + Eigen::Vector2d(column * cell, row * cell));
    }
  }
  return places;
}

Pose<Field, Robot> mean_around(const Cell& best, std::span<const Cell> cells, double reach) {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  double turn = 0.0;
  double total = 0.0;
  for (const Cell& cell : cells) {
    const double gap = angle_difference(cell.X_FR.theta(), best.X_FR.theta());
    const double away = (cell.X_FR.origin().vector() - best.X_FR.origin().vector()).norm();
    if (away > reach || std::abs(gap) > 0.25) continue;
    const double weight = std::exp(cell.log_weight - best.log_weight);
    place += weight * cell.X_FR.origin().vector();
    turn += weight * gap;
    total += weight;
  }
  place /= total;
  return {place.x(), place.y(), best.X_FR.theta() + turn / total};
}

}  // namespace

Pose<Field, Robot> markov_localise(const DistanceTable& table,
                                   const FieldModel& field,
                                   std::span<const vision::LinePoint> points,
                                   const MarkovParameters& parameters) {
  const std::size_t stride = 1 + points.size() / kPoints;
  const std::vector<Eigen::Vector2d> places = places_of(field, parameters.cell);
  std::vector<Cell> cells;
  cells.reserve(places.size() * static_cast<std::size_t>(parameters.headings));
  std::vector<Eigen::Vector2d> turned;
  for (int heading = 0; heading < parameters.headings; ++heading) {
    const double theta = 2.0 * std::numbers::pi * heading / parameters.headings;
    const Eigen::Matrix2d R_FR = Pose<Field, Robot>(0.0, 0.0, theta).rotation();
    turned.clear();
    for (std::size_t i = 0; i < points.size(); i += stride) {
      turned.emplace_back(R_FR * points[i].p_R.vector());
    }
    for (const Eigen::Vector2d& place : places) {
      cells.push_back(
          {{place.x(), place.y(), theta}, log_likelihood(table, place, turned, parameters)});
    }
  }
  const auto best = std::ranges::max_element(cells, {}, &Cell::log_weight);
  if (best == cells.end()) return {};
  return mean_around(*best, cells, kAround * parameters.cell);
}

}  // namespace teamsight::locate_rivals
