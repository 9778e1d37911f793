// vision/localisation/half_odds.cpp: likelihood ratios of directions.
#include "vision/localisation/half_odds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/LU>

#include "geometry/angle.hpp"
#include "geometry/expect.hpp"
#include "geometry/uncertainty.hpp"

namespace teamsight::vision {

namespace {

constexpr double kCompassFails = 0.05;
constexpr double kGoalIsOther = 0.1;
constexpr double kLeastSigma = 0.05;  // rad; nothing that tells halves apart needs to be better

// Log-likelihood of an angular gap: normal, or with probability `fails` from anywhere.
double log_likelihood(double gap, double sigma, double fails) {
  const double s = std::max(sigma, kLeastSigma);
  const double normal =
      std::exp(-0.5 * gap * gap / (s * s)) / (s * std::sqrt(2.0 * std::numbers::pi));
  return std::log((1.0 - fails) * normal + fails / (2.0 * std::numbers::pi));
}

// How far a goal of that colour is from where it was seen, in rad; pi if the field has none.
double gap_to_goal(const Pose<Field, Robot>& X_FR,
                   const FieldModel& field,
                   const GoalBearing& seen) {
  double least = std::numbers::pi;
  for (const Goal& goal : field.goals) {
    if (goal.colour != seen.colour) continue;
    const Eigen::Vector2d middle = 0.5 * (goal.left_post.vector() + goal.right_post.vector());
    const Point<Robot> p_R = X_FR.inverse() * Point<Field>::from(middle);
    const double gap = std::abs(angle_difference(std::atan2(p_R.y, p_R.x), seen.azimuth));
    least = std::min(least, gap);
  }
  return least;
}

GoalColour colour_of(ColourClass colour) {
  switch (colour) {
    case ColourClass::kBlue:
      return GoalColour::kBlue;
    case ColourClass::kYellow:
      return GoalColour::kYellow;
    case ColourClass::kWhite:
      return GoalColour::kWhite;
    default:
      return GoalColour::kNone;
  }
}

// Normal density of a posture; 1/(m^2 rad).
double density(const Pose<Field, Robot>& X_FR,
               const Pose<Field, Robot>& mean,
               const Eigen::Matrix3d& cov) {
  Eigen::Vector3d gap = X_FR.vector() - mean.vector();
  gap.z() = wrap_angle(gap.z());
  const double volume = std::sqrt(std::pow(2.0 * std::numbers::pi, 3) * cov.determinant());
  return std::exp(-0.5 * squared_mahalanobis(gap, cov)) / volume;
}

}  // namespace

GoalBearing bearing_of(const SeenGoal& goal) {
  constexpr double kShareOfWidth = 0.3;  // an even spread over a width has this sigma
  const double width = std::abs(angle_difference(goal.left, goal.right));
  return {colour_of(goal.colour), goal.azimuth, kLeastSigma + kShareOfWidth * width};
}

double half_log_odds_from_compass(const Pose<Field, Robot>& X_FR, const CompassReading& compass) {
  const double gap = angle_difference(X_FR.theta(), compass.heading);
  return log_likelihood(gap, compass.sigma, kCompassFails) -
         log_likelihood(wrap_angle(gap + std::numbers::pi), compass.sigma, kCompassFails);
}

double half_log_odds_from_goals(const Pose<Field, Robot>& X_FR,
                                const FieldModel& field,
                                std::span<const GoalBearing> goals) {
  const Pose<Field, Robot> image = mirrored(X_FR, field.centre);
  double odds = 0.0;
  for (const GoalBearing& goal : goals) {
    const bool tells = goal.colour == GoalColour::kBlue || goal.colour == GoalColour::kYellow;
    if (!tells || !std::isfinite(goal.azimuth) || !std::isfinite(goal.sigma)) continue;
    odds += log_likelihood(gap_to_goal(X_FR, field, goal), goal.sigma, kGoalIsOther) -
            log_likelihood(gap_to_goal(image, field, goal), goal.sigma, kGoalIsOther);
  }
  return odds;
}

double half_log_odds_after_jump(const Pose<Field, Robot>& X_FR,
                                const MotionPrior& expected,
                                double reach,
                                const FieldModel& field) {
  TEAMSIGHT_EXPECT(expected.X_FR && reach > 0.0);
  const double sigma_pushed = reach / 3.0;  // as far as it can have come is three sigma
  const Eigen::Matrix3d cov_pushed =
      expected.cov + sigma_pushed * sigma_pushed * Eigen::Matrix3d::Identity();
  const auto near = [&](const Pose<Field, Robot>& place) {
    return density(place, *expected.X_FR, expected.cov) +
           density(place, *expected.X_FR, cov_pushed);
  };
  const double carpet =
      (field.length + 2.0 * field.surround) * (field.width + 2.0 * field.surround);
  const double carried = 1.0 / (carpet * 2.0 * std::numbers::pi);
  const double here = near(X_FR);
  const double there = near(mirrored(X_FR, field.centre));
  const double p = 1.0 / (1.0 + std::exp(-expected.half_log_odds));
  const double odds = std::log(p * here + (1.0 - p) * there + carried) -
                      std::log(p * there + (1.0 - p) * here + carried);
  return std::clamp(odds, -kMaxHalfLogOdds, kMaxHalfLogOdds);
}

}  // namespace teamsight::vision
