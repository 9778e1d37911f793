// bench/locate_score/line_view.cpp: rays across the paint, faults, noise.
#include "bench/locate_score/line_view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace teamsight::locate_score {

namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kNearest = 0.3;  // m, of a point that the mirror shows

/// From a point along a direction of length one, both in F.
struct Ray {
  Eigen::Vector2d origin;
  Eigen::Vector2d direction;
};

void cross(const FieldLine& line, const Ray& ray, std::vector<double>& ranges) {
  const Eigen::Vector2d a = line.from.vector() - ray.origin;
  const Eigen::Vector2d along = line.to.vector() - line.from.vector();
  const double det = ray.direction.x() * -along.y() + along.x() * ray.direction.y();
  if (std::abs(det) < 1e-3 * along.norm()) return;
  const double t = (a.x() * -along.y() + along.x() * a.y()) / det;
  const double s = (ray.direction.x() * a.y() - ray.direction.y() * a.x()) / det;
  if (t > 0.0 && s >= 0.0 && s <= 1.0) ranges.push_back(t);
}

void cross(const FieldArc& arc, const Ray& ray, std::vector<double>& ranges) {
  const Eigen::Vector2d a = arc.centre.vector() - ray.origin;
  const double along = a.dot(ray.direction);
  const double half2 = arc.radius * arc.radius - (a.squaredNorm() - along * along);
  if (half2 <= 0.0) return;
  for (const double t : {along - std::sqrt(half2), along + std::sqrt(half2)}) {
    const Eigen::Vector2d p = t * ray.direction - a;
    double turn = std::fmod(std::atan2(p.y(), p.x()) - arc.start, kTurn);
    if (turn < 0.0) turn += kTurn;
    if (t > 0.0 && turn <= arc.sweep) ranges.push_back(t);
  }
}

// The ranges at which a ray crosses the paint, the nearest first.
std::vector<double> crossings(const FieldModel& field, const Ray& ray) {
  std::vector<double> ranges;
  for (const FieldLine& line : field.lines) cross(line, ray, ranges);
  for (const FieldArc& arc : field.arcs) cross(arc, ray, ranges);
  std::ranges::sort(ranges);
  return ranges;
}

// Sectors hidden by robots around: from, to, and beyond which range.
struct Shadow {
  double azimuth{0.0};
  double half{0.0};
  double range{0.0};
};

std::vector<Shadow> draw_shadows(int robots, double range, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Shadow> shadows;
  for (int i = 0; i < robots; ++i) {
    const double distance = 0.6 + unit(random) * (range - 0.6);
    shadows.push_back({kTurn * unit(random), std::atan(0.25 / distance), distance - 0.25});
  }
  return shadows;
}

bool is_shadowed(const std::vector<Shadow>& shadows, double azimuth, double range) {
  return std::ranges::any_of(shadows, [&](const Shadow& shadow) {
    return range > shadow.range &&
           std::abs(std::remainder(azimuth - shadow.azimuth, kTurn)) < shadow.half;
  });
}

// Whether a metre of paint is hidden in this look; the same for all points on it.
bool is_hidden(const Eigen::Vector2d& p_F, double share, unsigned salt) {
  if (share <= 0.0) return false;
  const auto cell = static_cast<long>(std::floor(p_F.x())) * 7919L +
                    static_cast<long>(std::floor(p_F.y())) * 104729L + static_cast<long>(salt);
  std::minstd_rand hash(static_cast<unsigned>(std::abs(cell) + 1));
  hash.discard(2);
  return static_cast<double>(hash()) / static_cast<double>(std::minstd_rand::max()) < share;
}

// Where a floor point is seen by a head that leans (the inverse of what the fit undoes), through a
// faulty map, with noise.
Point<Robot> seen_at(const Eigen::Vector2d& p_R,
                     const LineViewParameters& parameters,
                     const MapFault& fault,
                     std::mt19937& random) {
  std::normal_distribution<double> noise(0.0, parameters.sigma);
  const double lift =
      (parameters.roll * p_R.y() - parameters.pitch * p_R.x()) / parameters.eye_height;
  Point<Robot> seen = fault.seen(Point<Robot>::from(p_R / (1.0 + lift)), parameters.range);
  seen.x += noise(random);
  seen.y += noise(random);
  return seen;
}

Point<Robot> draw_outlier(double range, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double azimuth = kTurn * unit(random);
  const double distance = range * std::sqrt(unit(random));
  return {distance * std::cos(azimuth), distance * std::sin(azimuth)};
}

}  // namespace

Point<Robot> MapFault::seen(const Point<Robot>& p_R, double range) const {
  const Eigen::Vector2d p = p_R.vector();
  const double distance = p.norm();
  const double azimuth = std::atan2(p.y(), p.x());
  const double far = distance / range;
  const double radius = distance * (1.0 + scale) + bend * far * far * std::cos(2.0 * azimuth);
  return {radius * std::cos(azimuth + turn) + shift_x, radius * std::sin(azimuth + turn) + shift_y};
}

std::vector<vision::LinePoint> look_at_lines(const FieldModel& field,
                                             const Pose<Field, Robot>& X_FR,
                                             const LineViewParameters& parameters,
                                             const MapFault& fault,
                                             std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto shadows = draw_shadows(parameters.robots, parameters.range, random);
  const auto salt = static_cast<unsigned>(random());
  const double claimed =
      parameters.claimed_sigma > 0.0 ? parameters.claimed_sigma : parameters.sigma;
  std::vector<vision::LinePoint> points;
  for (int i = 0; i < parameters.rays; ++i) {
    const double azimuth = kTurn * i / parameters.rays - std::numbers::pi;
    const Eigen::Vector2d direction_R{std::cos(azimuth), std::sin(azimuth)};
    const Ray ray{X_FR.origin().vector(), X_FR.rotation() * direction_R};
    for (const double range : crossings(field, ray)) {
      const bool is_out_of_sight =
          range > parameters.range || range < kNearest || is_shadowed(shadows, azimuth, range) ||
          is_hidden(ray.origin + range * ray.direction, parameters.hidden, salt);
      if (is_out_of_sight) continue;
      vision::LinePoint point;
      point.p_R = seen_at(range * direction_R, parameters, fault, random);
      if (unit(random) < parameters.outliers) point.p_R = draw_outlier(parameters.range, random);
      point.cov_R = claimed * claimed * Eigen::Matrix2d::Identity();
      points.push_back(point);
    }
  }
  return points;
}

Pose<Field, Robot> draw_pose(const FieldModel& field, double margin, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const double x = unit(random) * std::max(0.0, 0.5 * field.length - margin);
  const double y = unit(random) * std::max(0.0, 0.5 * field.width - margin);
  return {field.centre.x + x, field.centre.y + y, std::numbers::pi * unit(random)};
}

}  // namespace teamsight::locate_score
