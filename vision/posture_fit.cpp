// vision/posture_fit.cpp: residuals, annealed Gauss-Newton steps, covariance.
#include "vision/posture_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "geometry/expect.hpp"

namespace teamsight::vision {

namespace {

constexpr double kWidest = 0.25;     // m; farther from the paint a point says nothing
constexpr double kLastWidth = 0.02;  // m, or 3 sigma
constexpr double kShrink = 0.7;      // of the kernel, per step
constexpr double kIdle = 0.05;       // of the kernel; one that moves points less has done its work
constexpr double kShrinkIdle = 0.3;  // of such a kernel: about three steps at once
constexpr double kSigmas = 3.0;
constexpr int kMaxSteps = 24;
constexpr double kStill = 0.25;         // sigma of the answer; a shorter step is none
constexpr double kStillPlace = 2e-5;    // m, of line points; the same
constexpr double kMostBend = 1.9;       // of weights over slope; below 2 a step still descends
constexpr double kMostFollowed = 0.01;  // m; moved so far by derivatives, a point is off by 20 um
constexpr double kUnseen = 1e9;         // m, the same, of points that were never looked at
constexpr double kVoteWidth = 0.08;     // m, of the soft votes that rank candidates
constexpr double kInlierFloor = 0.05;   // m
constexpr double kObservable = 0.5;     // m or rad: beyond this a direction counts as open
constexpr double kMadToSigma = 1.4826;  // of a normal distribution
constexpr double kPriorPoints = 10.0;   // how many points the claimed sigma is worth: kernel width
constexpr double kClaimPoints = 2.0;    // the same for the covariance
constexpr double kMostLift = 0.5;       // of a ray's way to the horizon
constexpr double kKnownTilt = 1e-6;     // rad; a smaller sigma means a tilt that is known
constexpr std::size_t kLeaders = 150;   // points that lead the way
constexpr std::size_t kSharedSample = 60;  // points that tell what all share
constexpr std::size_t kScaleSample = 160;  // points from which a step measures its scale
constexpr double kSectorDoubt = 6.0;       // sectors that the hypothesis "no correlation" is worth
// How probably a stretch of few points lies on other paint, or is none, and with how many points
// more that falls to 1/e. Measured on 500 rendered frames: 22 % of 219 stretches of one point, 7.6
// % of 354 of four to six, 2.6 % of 705 of seven to twelve, 0.3 % of 1,178 of up to 25.
constexpr double kWrongStretch = 0.25;
constexpr double kWrongFalls = 4.0;
constexpr double kTypicalRange = 3.0;  // m, of a line point

using Row = Eigen::Matrix<double, 5, 1>;

// (distance / kernel's width)^2; the kernel is as wide as asked for, but at least kLastWidth and
// kSigmas sigma.
double squared_ratio(const LineResidual& residual, double width, double scale) {
  const double least = std::max(width, kLastWidth);
  const double square_sigmas = kSigmas * kSigmas * scale * scale * residual.var;
  return residual.distance * residual.distance / std::max(least * least, square_sigmas);
}

Row row_of(const LineResidual& residual) {
  return {residual.jacobian.x(),
          residual.jacobian.y(),
          residual.jacobian.z(),
          residual.tilt_jacobian.x(),
          residual.tilt_jacobian.y()};
}

// The derivatives and below them the distance: of the products of its entries some are information,
// some the gradient.
using Column = Eigen::Matrix<double, 6, 1>;
using Squares = Eigen::Matrix<double, 6, 6>;

Column column_of(const LineResidual& r) {
  return {r.jacobian.x(),
          r.jacobian.y(),
          r.jacobian.z(),
          r.tilt_jacobian.x(),
          r.tilt_jacobian.y(),
          r.distance};
}

// Adds a column's products to the lower half of a sum; columns in pairs, as registers take them.
void add_square(const Column& column, double weight, Squares& sum) {
  const Column weighted = weight * column;
  sum.col(0) += weighted.x() * column;
  sum.col(1) += weighted.y() * column;
  sum.col(2).tail<4>() += weighted.z() * column.tail<4>();
  sum.col(3).tail<4>() += weighted.w() * column.tail<4>();
  sum.col(4).tail<2>() += weighted(4) * column.tail<2>();
  sum.col(5).tail<2>() += weighted(5) * column.tail<2>();
}

// Which eighth of the floor around the robot; in no order.
std::size_t octant_of(const Point<Robot>& p_R) {
  const bool is_wide = std::abs(p_R.x) > std::abs(p_R.y);
  return (p_R.x < 0.0 ? 1U : 0U) + (p_R.y < 0.0 ? 2U : 0U) + (is_wide ? 4U : 0U);
}

// What a point is displaced by, in R, when the picture errs by one claimed sigma in each of six
// ways: aside along two axes, larger, out of round along two axes, turned.
Eigen::Matrix<double, 2, 6> shared_displacements(const LinePoint& point) {
  const Eigen::Vector2d p = point.p_R.vector();
  const Eigen::Vector2d away = p / std::max(p.norm(), 1e-6);
  const Eigen::Vector2d across{-away.y(), away.x()};
  const Eigen::Vector2d radial = std::sqrt(away.dot(point.cov_R * away)) * away;
  const Eigen::Vector2d tangential = std::sqrt(across.dot(point.cov_R * across)) * across;
  const double c = away.x();
  const double s = away.y();
  Eigen::Matrix<double, 2, 6> ways;
  ways << c * radial - s * tangential, s * radial + c * tangential, radial,
      (c * c - s * s) * radial, 2.0 * c * s * radial, tangential;
  return ways;
}

Eigen::Vector2d tilt_info(const HeadTilt& tilt) {
  return tilt.sigma.cwiseMax(kKnownTilt).cwiseAbs2().cwiseInverse();
}

}  // namespace

Eigen::Matrix3d shared_part(const PostureFit& fit, const SharedError& error) {
  Eigen::Matrix3d cov = error.share * error.share * fit.cov_shared;
  const double place = error.sigma_place * error.sigma_place;
  cov.diagonal() += Eigen::Vector3d(place, place, error.sigma_heading * error.sigma_heading);
  return cov;
}

bool is_inlier(const LineResidual& residual, double scale) {
  const double gate = std::max(kInlierFloor, kSigmas * scale * std::sqrt(residual.var));
  return std::abs(residual.distance) < std::min(gate, kWidest);
}

LineResidual PostureResiduals::of(const LinePoint& point) const {
  const Eigen::Vector2d p_R = point.p_R.vector();
  const double lift = (tilt_.x() * p_R.y() - tilt_.y() * p_R.x()) / eye_height_;
  // No ray that met the floor rises to the horizon.
  const double stretch = 1.0 / (1.0 - std::min(lift, kMostLift));
  const Eigen::Vector2d seen_F = R_FR_ * p_R;
  const Eigen::Vector2d p_RL_F = stretch * seen_F;
  const NearestLine nearest = map_->nearest(p_FR_ + p_RL_F);
  const Eigen::Vector2d& n = nearest.normal_F;
  const Eigen::Vector2d n_R = R_FR_.transpose() * n;
  LineResidual result;
  result.distance = nearest.distance;
  result.jacobian = {n.x(), n.y(), n.dot(Eigen::Vector2d(-p_RL_F.y(), p_RL_F.x()))};
  result.tilt_jacobian =
      stretch * stretch * n.dot(seen_F) / eye_height_ * Eigen::Vector2d(p_R.y(), -p_R.x());
  result.var = n_R.dot(point.cov_R * n_R);
  return result;
}

LineResidual line_residual(const LineMap& map,
                           const Pose<Field, Robot>& X_FR,
                           const LinePoint& point,
                           const Eigen::Vector2d& tilt,
                           double eye_height) {
  return PostureResiduals(map, X_FR, tilt, eye_height).of(point);
}

void PostureFitter::look(const LineMap& map,
                         std::span<const LinePoint> points,
                         std::size_t stride,
                         const PostureFit& fit) {
  residuals_.clear();
  const PostureResiduals residuals(map, fit.X_FR, fit.tilt, tilt_.eye_height);
  for (std::size_t i = 0; i < points.size(); i += stride) {
    residuals_.push_back(residuals.of(points[i]));
  }
}

double PostureFitter::measure_scale() {
  squares_.clear();
  const std::size_t stride = 1 + residuals_.size() / kScaleSample;
  for (std::size_t i = 0; i < residuals_.size(); i += stride) {
    const LineResidual& r = residuals_[i];
    const double square = r.distance * r.distance;
    if (square < kWidest * kWidest) squares_.push_back(square / r.var);
  }
  if (squares_.size() < 5) return 1.0;
  const auto middle = squares_.begin() + static_cast<std::ptrdiff_t>(squares_.size() / 2);
  std::nth_element(squares_.begin(), middle, squares_.end());
  const auto count = static_cast<double>(squares_.size());
  const double measured = kMadToSigma * kMadToSigma * *middle;
  return std::sqrt((kPriorPoints + count * measured) / (kPriorPoints + count));
}

PostureFitter::Step PostureFitter::next_step(const PostureFit& fit, double width) const {
  Squares sum = Squares::Zero();
  const double precision = 1.0 / (fit.scale * fit.scale);
  double sum_weight = 0.0;
  double sum_slope = 0.0;
  for (const LineResidual& r : residuals_) {
    const double u2 = squared_ratio(r, width, fit.scale);
    const double near = 1.0 / (1.0 + u2);
    const double weight = near * near;
    sum_weight += weight;
    sum_slope += (1.0 - 3.0 * u2) * near * weight;
    add_square(column_of(r), precision * weight / r.var, sum);
  }
  Information info = sum.topLeftCorner<5, 5>();
  Row gradient = sum.bottomLeftCorner<1, 5>().transpose();
  const Eigen::Vector2d held = tilt_info(tilt_);
  info.diagonal().tail<2>() += held;
  gradient.tail<2>() += held.cwiseProduct(fit.tilt - tilt_.mean);
  // A little damping keeps an open direction where it is instead of throwing the robot off.
  info.diagonal().head<3>() += Eigen::Vector3d::Constant(1.0);
  Step step;
  step.change = info.selfadjointView<Eigen::Lower>().ldlt().solve(-gradient);
  if (!step.change.allFinite()) return {};
  step.is_less_than_noise = -step.change.dot(gradient) < kStill * kStill;
  // Where a kernel bends, its weights promise a pull that falls more slowly than it does: with
  // the points' mean bend the step is about Newton's.
  if (width < kLastWidth) {
    step.change *= std::clamp(sum_weight / std::max(sum_slope, 1e-12), 1.0, kMostBend);
  }
  const double way = step.change.head<2>().norm();
  const double limit = std::min(1.0, 0.5 / std::max(way, 1e-12));
  step.change *= limit;
  step.change(2) = std::clamp(step.change(2), -0.5, 0.5);
  step.way = std::max(way, kTypicalRange * std::abs(step.change(2)));
  return step;
}

double PostureFitter::take(const Step& step, PostureFit& fit) {
  fit.X_FR = {fit.X_FR.x() + step.change(0),
              fit.X_FR.y() + step.change(1),
              fit.X_FR.theta() + step.change(2)};
  fit.tilt += step.change.tail<2>();
  double farthest = 0.0;
  for (LineResidual& r : residuals_) {
    const double shift =
        r.jacobian.dot(step.change.head<3>()) + r.tilt_jacobian.dot(step.change.tail<2>());
    r.distance += shift;
    farthest = std::max(farthest, std::abs(shift));
  }
  return farthest;
}

double PostureFitter::measure_correlation(const PostureFit& fit) const {
  std::array<Eigen::Vector3d, kSectors> sums{};
  sums.fill(Eigen::Vector3d::Zero());
  Eigen::Matrix3d single = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < residuals_.size(); ++i) {
    const LineResidual& r = residuals_[i];
    const double u2 = squared_ratio(r, 0.0, fit.scale);
    const double psi = r.distance / std::pow(1.0 + u2, 2);
    const Eigen::Vector3d pull = psi / r.var * r.jacobian;
    single += pull * pull.transpose();
    sums[stretch_of_[i] / 2] += pull;
  }
  Eigen::Matrix3d grouped = Eigen::Matrix3d::Zero();
  double sectors = 0.0;
  for (const Eigen::Vector3d& sum : sums) {
    grouped += sum * sum.transpose();
    if (sum.squaredNorm() > 0.0) sectors += 1.0;
  }
  if (sectors < 4.0) return 1.0;
  // The fit made the pulls sum up to zero: one sector's worth of freedom is gone.
  return sectors / (sectors - 1.0) * (fit.cov * grouped).trace() /
         std::max((fit.cov * single).trace(), 1e-12);
}

PostureFitter::Pulls PostureFitter::measure_pulls(std::span<const LinePoint> points,
                                                  const PostureFit& fit) const {
  // Errors that all share are smooth: some of the points tell them as well as all.
  const std::size_t stride = 1 + residuals_.size() / kSharedSample;
  const Eigen::Matrix2d R_RF = fit.X_FR.rotation().transpose();
  Pulls pulls = Pulls::Zero();
  for (std::size_t i = 0; i < residuals_.size(); i += stride) {
    const LineResidual& r = residuals_[i];
    const double u2 = squared_ratio(r, 0.0, fit.scale);
    const double weight = static_cast<double>(stride) / ((1.0 + u2) * (1.0 + u2) * r.var);
    const Eigen::Vector2d n_R = R_RF * r.jacobian.head<2>();
    pulls += weight * row_of(r) * (n_R.transpose() * shared_displacements(points[i]));
  }
  return pulls;
}

void PostureFitter::spread(const Information& info, double variance, PostureFit& fit) const {
  Information total = info / variance;
  total.diagonal().head<3>() += Eigen::Vector3d::Constant(1.0 / (kOpenSigma * kOpenSigma));
  total.diagonal().tail<2>() += tilt_info(tilt_);
  const Information cov = total.llt().solve(Information::Identity());
  fit.cov = cov.topLeftCorner<3, 3>();
  fit.cov = 0.5 * (fit.cov + fit.cov.transpose()).eval();
  fit.var_tilt = cov.diagonal().tail<2>();
  // One sigma for the radius and one for the turn of each point: three ways share the first.
  const Eigen::Matrix<double, 3, 6> moved = (cov * pulls_ / variance).topRows<3>();
  fit.cov_shared = moved * moved.transpose() / 3.0;
}

void PostureFitter::doubt_stretches(const Information& info,
                                    double variance,
                                    PostureFit& fit) const {
  // Farther off than a kernel is wide, a wrong stretch would not have been taken for paint.
  const double place = 1.0 / (kWidest * kWidest);
  Eigen::Matrix<double, 5, 1> held;
  held << place, place, kTypicalRange * kTypicalRange * place, tilt_info(tilt_);
  const auto cov_of = [&](const Information& some) -> Eigen::Matrix3d {
    Information total = some / variance;
    total.diagonal() += held;
    const Eigen::LLT<Information> root(total);
    Eigen::Matrix3d cov;
    for (int i = 0; i < 3; ++i) cov.col(i) = root.solve(Row::Unit(i)).head<3>();
    return cov;
  };
  const Eigen::Matrix3d whole = cov_of(info);
  fit.cov_doubtful.setZero();
  for (const Stretch& stretch : stretches_) {
    if (stretch.weight <= 0.0) continue;
    const double wrong = kWrongStretch * std::exp(-stretch.weight / kWrongFalls);
    // If it is wrong, the robot is only as surely where it seems as the others say.
    fit.cov_doubtful += wrong * (cov_of(info - stretch.squares.topLeftCorner<5, 5>()) - whole);
  }
  fit.cov_doubtful = 0.5 * (fit.cov_doubtful + fit.cov_doubtful.transpose()).eval();
  fit.cov += fit.cov_doubtful;
}

void PostureFitter::judge(std::span<const LinePoint> points, PostureFit& fit) {
  stretches_.fill({});
  stretch_of_.clear();
  double sum_square = 0.0;
  double sum_slope = 0.0;
  double sum_weight = 0.0;
  std::size_t inliers = 0;
  const auto count = static_cast<double>(residuals_.size());
  for (std::size_t i = 0; i < residuals_.size(); ++i) {
    const LineResidual& r = residuals_[i];
    const bool runs_along_y = std::abs(r.jacobian.x()) > std::abs(r.jacobian.y());
    stretch_of_.push_back(2 * octant_of(points[i].p_R) + (runs_along_y ? 1 : 0));
    const double u2 = squared_ratio(r, 0.0, fit.scale);
    // psi and its slope of the kernel, of residuals in units of the claimed sigma.
    const double weight = 1.0 / ((1.0 + u2) * (1.0 + u2));
    const double psi = r.distance * weight;
    sum_square += psi * psi / r.var;
    sum_slope += (1.0 - 3.0 * u2) * weight / (1.0 + u2);
    sum_weight += weight;
    Stretch& stretch = stretches_[stretch_of_[i]];
    stretch.weight += weight;
    add_square(column_of(r), weight / r.var, stretch.squares);
    if (is_inlier(r, fit.scale)) ++inliers;
    fit.support += 1.0 / (1.0 + std::pow(r.distance / kVoteWidth, 2));
  }
  fit.inlier_ratio = static_cast<double>(inliers) / count;
  if (sum_slope < 3.5) return;
  Information info = Information::Zero();
  for (const Stretch& stretch : stretches_) info += stretch.squares.topLeftCorner<5, 5>();
  // Sandwich of the M-estimator over the weighted points (an outlier far out has a long lever, but
  // no weight), with the three degrees of freedom that the fit used up.
  const double slope = sum_slope / sum_weight;
  const double measured = sum_square / (std::max(sum_weight - 3.0, 1.0) * slope * slope);
  const double variance = (sum_weight * measured + kClaimPoints) / (sum_weight + kClaimPoints);
  pulls_ = measure_pulls(points, fit);
  spread(info, variance, fit);
  fit.correlation = measure_correlation(fit);
  // A ratio from so few sectors is uncertain: drawn towards "no correlation".
  const double alone = (kSectors * fit.correlation + kSectorDoubt) / (kSectors + kSectorDoubt);
  const double known = known_correlation_ > 0.0 ? known_correlation_ : alone;
  spread(info, variance * std::max(1.0, known), fit);
  doubt_stretches(info, variance * std::max(1.0, known), fit);
  fit.observable = fit.cov.diagonal().maxCoeff() < kObservable * kObservable;
}

PostureFit PostureFitter::fit(const LineMap& map,
                              std::span<const LinePoint> points,
                              const FitStart& start) {
  TEAMSIGHT_EXPECT(!points.empty());
  tilt_ = start.tilt;
  known_correlation_ = start.correlation;
  PostureFit fit;
  fit.X_FR = start.X_FR;
  fit.tilt = tilt_.mean + start.lean;
  double width = std::min(start.width, kWidest);
  // While the kernel is wide, some of the points lead as well as all of them.
  std::size_t stride = 1 + points.size() / kLeaders;
  double followed = kUnseen;
  bool is_settled = false;
  for (int i = 0; i < kMaxSteps && !is_settled; ++i) {
    if (followed > kMostFollowed) {
      look(map, points, stride, fit);
      followed = 0.0;
    }
    fit.scale = measure_scale();
    const Step step = next_step(fit, width);
    followed += take(step, fit);
    const bool is_narrow = width < kLastWidth;
    is_settled = is_narrow && stride == 1 && (step.is_less_than_noise || step.way < kStillPlace);
    if (is_narrow && stride > 1) {
      stride = 1;
      followed = kUnseen;
    }
    width *= step.way > kIdle * width && !step.is_less_than_noise ? kShrink : kShrinkIdle;
  }
  if (!is_settled || followed > kMostFollowed) {
    look(map, points, 1, fit);
    fit.scale = measure_scale();
  }
  judge(points, fit);
  return fit;
}

}  // namespace teamsight::vision
