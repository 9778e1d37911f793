// vision/localisation/wide_fit.cpp: votes around a hypothesis, fits from the best places.
#include "vision/localisation/wide_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Cholesky>

#include "geometry/angle.hpp"

namespace teamsight::vision {

namespace {

constexpr double kNarrowest = 0.06;         // m, of a fit's first kernel
constexpr double kWidest = 0.25;            // m
constexpr double kTypicalRange = 3.0;       // m, of a line point
constexpr double kExplained = 0.95;         // votes per point of a frame that leaves nothing open
constexpr std::size_t kSample = 90;         // points that vote
constexpr double kSquareWidth = 0.1 * 0.1;  // m^2, of a vote
constexpr int kSteps = 3;                   // of the ellipsoid's radius, to each side
constexpr double kOut = 2.7;                // sigma, of that radius
constexpr double kVoteWeight = 1.0;         // log-probability of one vote of the sample
constexpr double kKnownTilt = 1e-6;         // rad; a smaller sigma means a tilt that is known
constexpr int kLeans = 8;                   // sides to which the head is tried leaning
constexpr double kLean = 2.5;               // sigma, how far
constexpr double kUnexpected = 16.3;        // 99.9 % of chi square with 3 degrees of freedom
constexpr double kSamePlace = 0.02;         // m
constexpr double kSameHeading = 0.01;       // rad

double reach_of(const Hypothesis& hypothesis) {
  const double turn = kTypicalRange * std::sqrt(hypothesis.cov(2, 2));
  return 3.0 * std::hypot(hypothesis.sigma_position(), turn);
}

Eigen::Vector3d gap_between(const Pose<Field, Robot>& from, const Pose<Field, Robot>& to) {
  Eigen::Vector3d gap = to.vector() - from.vector();
  gap.z() = wrap_angle(gap.z());
  return gap;
}

bool is_same(const Eigen::Vector3d& gap) {
  return gap.head<2>().norm() < kSamePlace && std::abs(gap.z()) < kSameHeading;
}

// How far the lean that a fit found is from the expected one; in sigmas, squared.
double squared_lean(const PostureFit& fit, const HeadTilt& tilt) {
  return (fit.tilt - tilt.mean).cwiseQuotient(tilt.sigma.cwiseMax(kKnownTilt)).squaredNorm();
}

// Whether a fit leaves no reason to look for another one.
bool is_plain(const PostureFit& fit,
              std::size_t points,
              const Hypothesis& hypothesis,
              const HeadTilt& tilt) {
  return fit.support >= kExplained * static_cast<double>(points) &&
         innovation_of(hypothesis, fit.X_FR, fit.cov).nis < kUnexpected &&
         squared_lean(fit, tilt) < kUnexpected;
}

}  // namespace

WideFitter::WideFitter() {
  sample_.reserve(kSample);
  endings_.reserve(1 + kTried + kLeans);
}

void WideFitter::take_sample(std::span<const LinePoint> points) {
  sample_.clear();
  const std::size_t count = std::min(points.size(), kSample);
  for (std::size_t i = 0; i < count; ++i) sample_.push_back(points[i * points.size() / count]);
}

double WideFitter::votes_at(const LineMap& map, const Pose<Field, Robot>& X_FR) const {
  const Eigen::Matrix2d R_FR = X_FR.rotation();
  double votes = 0.0;
  for (const LinePoint& point : sample_) {
    const double d = map.nearest(X_FR.origin().vector() + R_FR * point.p_R.vector()).distance;
    votes += kSquareWidth / (kSquareWidth + d * d);
  }
  return votes;
}

void WideFitter::look_around(const LineMap& map, const Hypothesis& hypothesis) {
  places_.fill({});
  const Eigen::Matrix3d root = hypothesis.cov_pose().llt().matrixL();
  constexpr int kSide = 2 * kSteps + 1;
  for (int i = 0; i < kSide * kSide * kSide; ++i) {
    const Eigen::Vector3i steps(i % kSide, i / kSide % kSide, i / kSide / kSide);
    const Eigen::Vector3d sigmas = kOut / kSteps * (steps.array() - kSteps).cast<double>().matrix();
    if (sigmas.norm() > kOut + 1e-9) continue;
    const Eigen::Vector3d step = root * sigmas;
    Place place{{hypothesis.X_FR.x() + step.x(),
                 hypothesis.X_FR.y() + step.y(),
                 hypothesis.X_FR.theta() + step.z()}};
    place.log_weight = kVoteWeight * votes_at(map, place.X_FR) - 0.5 * sigmas.squaredNorm();
    // Sorted by weight, as few as they are.
    for (Place& known : places_) {
      if (place.log_weight > known.log_weight) std::swap(place, known);
    }
  }
}

void WideFitter::try_from(const LineMap& map, const FitStart& start, const Hypothesis& hypothesis) {
  Ending ending{fitter_.fit(map, sample_, start), 0.0};
  const bool is_known = std::ranges::any_of(endings_, [&](const Ending& other) {
    return is_same(gap_between(ending.fit.X_FR, other.fit.X_FR));
  });
  if (is_known) return;
  const Eigen::Vector3d gap = gap_between(hypothesis.X_FR, ending.fit.X_FR);
  const double distance = gap.dot(hypothesis.cov_pose().llt().solve(gap));
  ending.log_weight =
      kVoteWeight * ending.fit.support - 0.5 * (distance + squared_lean(ending.fit, start.tilt));
  endings_.push_back(ending);
}

void WideFitter::try_leaning(const LineMap& map,
                             const FitStart& start,
                             const Hypothesis& hypothesis) {
  FitStart leaning = start;
  for (int i = 0; i < kLeans; ++i) {
    const double side = 2.0 * std::numbers::pi * i / kLeans;
    leaning.lean =
        kLean * start.tilt.sigma.cwiseProduct(Eigen::Vector2d(std::cos(side), std::sin(side)));
    try_from(map, leaning, hypothesis);
  }
}

const WideFitter::Ending& WideFitter::best() const {
  return *std::ranges::max_element(endings_, {}, &Ending::log_weight);
}

PostureFit WideFitter::fit(const LineMap& map,
                           std::span<const LinePoint> points,
                           const Hypothesis& hypothesis,
                           const HeadTilt& tilt,
                           double correlation) {
  const double reach = reach_of(hypothesis);
  const FitStart start{hypothesis.X_FR, std::clamp(reach, kNarrowest, kWidest), tilt, correlation};
  PostureFit answer = fitter_.fit(map, points, start);
  if (reach <= kWidest || is_plain(answer, points.size(), hypothesis, tilt)) return answer;

  take_sample(points);
  look_around(map, hypothesis);
  endings_.clear();
  try_from(map, {answer.X_FR, kNarrowest, tilt, correlation, answer.tilt - tilt.mean}, hypothesis);
  for (const Place& place : places_) {
    try_from(map, {place.X_FR, kWidest, tilt, correlation}, hypothesis);
  }
  if (!is_plain(best().fit, sample_.size(), hypothesis, tilt)) {
    try_leaning(map, start, hypothesis);
  }
  const Ending& found = best();
  if (!is_same(gap_between(answer.X_FR, found.fit.X_FR))) {
    const Eigen::Vector2d lean = found.fit.tilt - tilt.mean;
    answer = fitter_.fit(map, points, {found.fit.X_FR, kNarrowest, tilt, correlation, lean});
  }
  double total = 0.0;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Ending& ending : endings_) {
    const double weight = std::exp(ending.log_weight - found.log_weight);
    total += weight;
    if (&ending == &found) continue;
    const Eigen::Vector3d gap = gap_between(answer.X_FR, ending.fit.X_FR);
    spread += weight * gap * gap.transpose();
  }
  answer.cov += spread / total;
  return answer;
}

}  // namespace teamsight::vision
