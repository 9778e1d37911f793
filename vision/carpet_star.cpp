// vision/carpet_star.cpp: see vision/carpet_star.hpp.
#include "vision/carpet_star.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>

namespace teamsight::vision {

namespace {

constexpr int kSteps = 6;               // of the fit: converged to hundredths of the radius
constexpr double kFirstScale = 0.5;     // of the expected radius: an end so far off counts half
constexpr double kLastScale = 0.12;     // the same at the end
constexpr double kRadiusSigma = 0.35;   // of the expected radius
constexpr double kEndSigma = 0.15;      // of the radius, about, of one end
constexpr double kAtEdge = 0.3;         // of the radius; farther off is no edge of the disc
constexpr std::size_t kFewestEnds = 6;  // a third of a circle's, and one to spare

using Normal = Eigen::Matrix3d;

// One step of Gauss-Newton on the ends' distances from the circle, each weighted by how well it
// fits (Cauchy).
void improve(const CarpetStar& star, double expected, double scale, StarDisc& disc) {
  Normal normal = Normal::Zero();
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < kStarDirections; ++i) {
    if (star.ends[i] != StarEnd::kCarpet) continue;
    const Eigen::Vector2d from = star.places[i] - disc.middle;
    const double distance = from.norm();
    if (distance <= 0.0) continue;
    const double off = distance - disc.radius;
    const double weight = 1.0 / (1.0 + off * off / (scale * scale));
    const Eigen::Vector3d slope(-from.x() / distance, -from.y() / distance, -1.0);
    normal += weight * slope * slope.transpose();
    gradient += weight * off * slope;
  }
  // How large such a thing is there is known a little.
  const double weight = std::pow(kEndSigma / kRadiusSigma, 2);
  normal(2, 2) += weight;
  gradient[2] += weight * (disc.radius - expected);
  normal.diagonal().array() += 1e-9;
  const Eigen::Vector3d step = normal.ldlt().solve(-gradient);
  disc.middle += step.head<2>();
  disc.radius += step[2];
}

}  // namespace

const Eigen::Vector2d& star_direction(std::size_t i) {
  static const std::array<Eigen::Vector2d, kStarDirections> directions = [] {
    std::array<Eigen::Vector2d, kStarDirections> all;
    for (std::size_t k = 0; k < kStarDirections; ++k) {
      const double turn = 2.0 * std::numbers::pi * static_cast<double>(k) / kStarDirections;
      all[k] = {std::cos(turn), std::sin(turn)};
    }
    return all;
  }();
  return directions[i];
}

std::optional<StarDisc> disc_in(const CarpetStar& star, double expected) {
  StarDisc disc;
  disc.radius = expected;
  for (int step = 0; step < kSteps; ++step) {
    const double done = static_cast<double>(step) / (kSteps - 1);
    const double scale = kFirstScale * std::pow(kLastScale / kFirstScale, done);
    improve(star, expected, scale * expected, disc);
    if (!(disc.radius > 0.0) || !disc.middle.allFinite()) return std::nullopt;
  }
  double squares = 0.0;
  for (std::size_t i = 0; i < kStarDirections; ++i) {
    if (star.ends[i] != StarEnd::kCarpet) continue;
    const double off = (star.places[i] - disc.middle).norm() - disc.radius;
    if (std::abs(off) > kAtEdge * disc.radius) continue;
    squares += off * off;
    ++disc.ends;
  }
  if (disc.ends < kFewestEnds) return std::nullopt;
  disc.scatter = std::sqrt(squares / static_cast<double>(disc.ends)) / disc.radius;
  return disc;
}

}  // namespace teamsight::vision
