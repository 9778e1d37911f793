// bench/locate_rivals/monte_carlo.cpp: move, weigh, draw again.
#include "bench/locate_rivals/monte_carlo.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/angle.hpp"

namespace teamsight::locate_rivals {

namespace {

constexpr double kAround = 0.4;       // m around the best particle that the mean is taken of
constexpr double kAroundTurn = 0.35;  // rad
constexpr std::size_t kPoints = 100;  // weighed per frame

}  // namespace

MonteCarlo::MonteCarlo(const FieldModel& field,
                       const MonteCarloParameters& parameters,
                       std::uint32_t seed)
    : field_(field),
      parameters_(parameters),
      random_(seed) {
  scatter();
}

Pose<Field, Robot> MonteCarlo::draw() {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  return {field_.centre.x + 0.5 * field_.length * unit(random_),
          field_.centre.y + 0.5 * field_.width * unit(random_),
          std::numbers::pi * unit(random_)};
}

void MonteCarlo::scatter() {
  particles_.clear();
  for (std::size_t i = 0; i < parameters_.particles; ++i) particles_.push_back(draw());
}

void MonteCarlo::gather(const Pose<Field, Robot>& X_FR, const Eigen::Vector3d& sigma) {
  std::normal_distribution<double> normal;
  particles_.clear();
  for (std::size_t i = 0; i < parameters_.particles; ++i) {
    particles_.emplace_back(X_FR.x() + sigma.x() * normal(random_),
                            X_FR.y() + sigma.y() * normal(random_),
                            X_FR.theta() + sigma.z() * normal(random_));
  }
}

void MonteCarlo::move(const Pose<Robot, Robot>& step) {
  std::normal_distribution<double> normal;
  for (Pose<Field, Robot>& particle : particles_) {
    particle =
        particle * Pose<Robot, Robot>(step.x() + parameters_.sigma_place * normal(random_),
                                      step.y() + parameters_.sigma_place * normal(random_),
                                      step.theta() + parameters_.sigma_turn * normal(random_));
  }
}

void MonteCarlo::weigh(const DistanceTable& table, std::span<const vision::LinePoint> points) {
  const std::size_t stride = 1 + points.size() / kPoints;
  const double precision = 0.5 / (parameters_.sigma_point * parameters_.sigma_point);
  log_weights_.clear();
  for (const Pose<Field, Robot>& particle : particles_) {
    const Eigen::Matrix2d R_FR = particle.rotation();
    double sum = 0.0;
    for (std::size_t i = 0; i < points.size(); i += stride) {
      const double d = table.distance(particle.origin().vector() + R_FR * points[i].p_R.vector());
      sum += std::log((1.0 - parameters_.fails) * std::exp(-precision * d * d) + parameters_.fails);
    }
    log_weights_.push_back(parameters_.independent * sum);
  }
  const auto heaviest = std::ranges::max_element(log_weights_);
  if (heaviest == log_weights_.end()) return;
  best_ = particles_[static_cast<std::size_t>(heaviest - log_weights_.begin())];
  double total = 0.0;
  for (double& weight : log_weights_) {
    weight = std::exp(weight - *heaviest);
    total += weight;
  }
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double step = total / static_cast<double>(particles_.size());
  double target = step * unit(random_);
  double reached = log_weights_.front();
  std::size_t at = 0;
  next_.clear();
  for (std::size_t i = 0; i < particles_.size(); ++i, target += step) {
    while (reached < target && at + 1 < particles_.size()) reached += log_weights_[++at];
    next_.push_back(unit(random_) < parameters_.anywhere ? draw() : particles_[at]);
  }
  particles_.swap(next_);
}

Pose<Field, Robot> MonteCarlo::estimate() const {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  double turn = 0.0;
  double count = 0.0;
  for (const Pose<Field, Robot>& particle : particles_) {
    const double gap = angle_difference(particle.theta(), best_.theta());
    const bool is_near = (particle.origin().vector() - best_.origin().vector()).norm() < kAround &&
                         std::abs(gap) < kAroundTurn;
    if (!is_near) continue;
    place += particle.origin().vector();
    turn += gap;
    count += 1.0;
  }
  if (count == 0.0) return best_;
  place /= count;
  return {place.x(), place.y(), best_.theta() + turn / count};
}

}  // namespace teamsight::locate_rivals
