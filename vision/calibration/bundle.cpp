// vision/calibration/bundle.cpp: the iteration over knobs and postures.
#include "vision/calibration/bundle.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "geometry/expect.hpp"
#include "vision/calibration/floor_look.hpp"

namespace teamsight::vision {

namespace {

constexpr std::array kWidths{0.3, 0.2, 0.12, 0.08, 0.05, 0.0};  // m, of the kernel
constexpr double kLastWidth = 0.02;                             // m, or 3 sigma
constexpr int kStepsPerWidth = 4;
constexpr int kLastSteps = 12;
constexpr double kRing = 10.0;          // px, of the pixels that share an error
constexpr double kGate = 0.25;          // m: farther points say nothing about the scale
constexpr double kMadToSigma = 1.4826;  // of a normal distribution
constexpr double kSmallStep = 1e-3;     // sigma of the priors, for all knobs together

/// The unknowns.
struct State {
  Eigen::VectorXd turn;
  std::vector<Pose<Field, Robot>> X_FR;
};

/// Normal equations after the postures are eliminated, and what brings these back.
struct Normals {
  Eigen::MatrixXd info;      // of the knobs, without priors
  Eigen::VectorXd gradient;  // without priors
  std::vector<Eigen::Matrix3d> posture_cov;
  std::vector<Eigen::Vector3d> posture_gradient;
  std::vector<Eigen::MatrixXd> cross;  // knobs by posture
};

double width_of(const FloorMiss& miss, double width, double scale) {
  return std::max({width, kLastWidth, 3.0 * scale * std::sqrt(miss.var)});
}

class Adjustment {
 public:
  Adjustment(const LineMap& map,
             const CameraParameters& camera,
             std::span<const KnobPrior> priors,
             BundleStart start,
             const BundleRules& rules)
      : map_(map),
        camera_(camera),
        views_(std::move(start.views)),
        rules_(rules),
        prior_info_(static_cast<Eigen::Index>(priors.size())) {
    for (const KnobPrior& prior : priors) {
      prior_info_[static_cast<Eigen::Index>(knobs_.size())] = 1.0 / (prior.sigma * prior.sigma);
      knobs_.push_back(prior.knob);
    }
    state_.turn = std::move(start.turn);
    if (state_.turn.size() == 0) state_.turn = Eigen::VectorXd::Zero(prior_info_.size());
    for (const CalibrationView& view : views_) state_.X_FR.push_back(view.X_FR);
  }

  Bundle run();

 private:
  /// Looks at all pixels through the camera of `state`; nothing if there is no such camera.
  bool look(const State& state, bool with_slopes);
  [[nodiscard]] double cost(const State& state, double width) const;
  [[nodiscard]] Normals normals(const State& state, double width) const;
  [[nodiscard]] double weight_of(const FloorMiss& miss, double width) const;
  [[nodiscard]] Eigen::MatrixXd shared(const State& state, const Normals& normals) const;
  [[nodiscard]] State step(const Normals& normals, double damping) const;
  void measure_scale(const State& state);
  [[nodiscard]] double correlation(const State& state) const;
  /// One step with growing damping until it leads down. @return how far it went, in sigma of the
  /// priors; 0 if no step leads down
  double go_down(double width);
  bool descend(double width, int steps);

  /// Calls use(miss) for every pixel that shows floor, view by view, in the order given.
  template <class Use>
  void over_misses(const State& state, const Use& use) const {
    for (std::size_t v = 0; v < views_.size(); ++v) {
      for (const FloorLook& seen : looks_[v]) {
        use(miss_of(map_, state.X_FR[v], seen, rules_.sigma_px));
      }
    }
  }

  const LineMap& map_;
  const CameraParameters& camera_;
  std::vector<CalibrationView> views_;
  BundleRules rules_;
  std::vector<CameraKnob> knobs_;
  Eigen::VectorXd prior_info_;
  State state_;
  double scale_{1.0};
  std::vector<std::vector<FloorLook>> looks_;  // of each view
};

bool Adjustment::look(const State& state, bool with_slopes) {
  const auto looker = FloorLooker::make(camera_, knobs_, state.turn, with_slopes);
  if (!looker) return false;
  looks_.resize(views_.size());
  for (std::size_t v = 0; v < views_.size(); ++v) {
    looks_[v].clear();
    for (const Pixel& pixel : views_[v].pixels) {
      const auto seen = looker->look(pixel);
      if (seen && seen->p_R.norm() < rules_.max_distance) looks_[v].push_back(*seen);
    }
  }
  return true;
}

double Adjustment::cost(const State& state, double width) const {
  double sum = 0.5 * state.turn.cwiseAbs2().dot(prior_info_);
  for (std::size_t v = 0; v < views_.size(); ++v) {
    // A pixel that sees no floor any more costs as much as one far from all paint.
    const auto blind = static_cast<double>(views_[v].pixels.size() - looks_[v].size());
    sum += 0.5 * blind * 9.0;
    for (const FloorLook& seen : looks_[v]) {
      const FloorMiss miss = miss_of(map_, state.X_FR[v], seen, rules_.sigma_px);
      const double c2 = std::pow(width_of(miss, width, scale_), 2);
      const double d2 = miss.distance * miss.distance;
      sum += 0.5 * c2 / miss.var * d2 / (c2 + d2) / (scale_ * scale_);
    }
  }
  return sum;
}

double Adjustment::weight_of(const FloorMiss& miss, double width) const {
  const double u = miss.distance / width_of(miss, width, scale_);
  return 1.0 / (std::pow(1.0 + u * u, 2) * miss.var * scale_ * scale_);
}

Normals Adjustment::normals(const State& state, double width) const {
  const Eigen::Index size = prior_info_.size();
  Normals result;
  result.info = Eigen::MatrixXd::Zero(size, size);
  result.gradient = Eigen::VectorXd::Zero(size);
  for (std::size_t v = 0; v < views_.size(); ++v) {
    Eigen::Matrix3d posture = Eigen::Matrix3d::Zero();
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    Eigen::MatrixXd cross = Eigen::MatrixXd::Zero(size, 3);
    for (const FloorLook& seen : looks_[v]) {
      const FloorMiss miss = miss_of(map_, state.X_FR[v], seen, rules_.sigma_px);
      const double weight = weight_of(miss, width);
      posture += weight * miss.by_posture * miss.by_posture.transpose();
      gradient += weight * miss.distance * miss.by_posture;
      cross += weight * miss.by_knob * miss.by_posture.transpose();
      result.info += weight * miss.by_knob * miss.by_knob.transpose();
      result.gradient += weight * miss.distance * miss.by_knob;
    }
    posture.diagonal().array() += 1.0;  // an open direction stays where it is
    const Eigen::Matrix3d cov = posture.inverse();
    result.info -= cross * cov * cross.transpose();
    result.gradient -= cross * (cov * gradient);
    result.posture_cov.push_back(cov);
    result.posture_gradient.push_back(gradient);
    result.cross.push_back(std::move(cross));
  }
  return result;
}

// What moving all pixels of one ring outwards together does to the gradient, for every ring.
Eigen::MatrixXd Adjustment::shared(const State& state, const Normals& normals) const {
  const Pixel middle = CameraModel(*turned(camera_, knobs_, state.turn)).centre();
  const Eigen::Vector2d centre{middle.u, middle.v};
  const auto rings =
      static_cast<Eigen::Index>(std::hypot(camera_.width_px, camera_.height_px) / kRing + 1.0);
  Eigen::MatrixXd by_knob = Eigen::MatrixXd::Zero(prior_info_.size(), rings);
  for (std::size_t v = 0; v < views_.size(); ++v) {
    Eigen::MatrixXd by_posture = Eigen::MatrixXd::Zero(3, rings);
    for (const FloorLook& seen : looks_[v]) {
      const FloorMiss miss = miss_of(map_, state.X_FR[v], seen, rules_.sigma_px);
      const Eigen::Vector2d out = Eigen::Vector2d{seen.pixel.u, seen.pixel.v} - centre;
      const double radius = std::max(out.norm(), 1.0);
      const auto ring = std::min(static_cast<Eigen::Index>(radius / kRing), rings - 1);
      const double push = weight_of(miss, 0.0) * miss.by_pixel.dot(out) / radius;
      by_knob.col(ring) += push * miss.by_knob;
      by_posture.col(ring) += push * miss.by_posture;
    }
    by_knob -= normals.cross[v] * (normals.posture_cov[v] * by_posture);
  }
  return rules_.shared_px * rules_.shared_px * by_knob * by_knob.transpose();
}

State Adjustment::step(const Normals& normals, double damping) const {
  Eigen::MatrixXd info = normals.info;
  info.diagonal() += (1.0 + damping) * prior_info_;
  info.diagonal() *= 1.0 + 0.01 * damping;
  const Eigen::VectorXd gradient = normals.gradient + prior_info_.cwiseProduct(state_.turn);
  const Eigen::VectorXd change = info.ldlt().solve(-gradient);
  State next = state_;
  next.turn += change;
  for (std::size_t v = 0; v < views_.size(); ++v) {
    const Eigen::Vector3d move = -normals.posture_cov[v] * (normals.posture_gradient[v] +
                                                            normals.cross[v].transpose() * change);
    const double limit = std::min(1.0, 0.5 / std::max(move.head<2>().norm(), 1e-12));
    const Pose<Field, Robot>& X_FR = state_.X_FR[v];
    next.X_FR[v] = {X_FR.x() + limit * move.x(),
                    X_FR.y() + limit * move.y(),
                    X_FR.theta() + std::clamp(limit * move.z(), -0.3, 0.3)};
  }
  return next;
}

void Adjustment::measure_scale(const State& state) {
  std::vector<double> sizes;
  over_misses(state, [&](const FloorMiss& miss) {
    const double size = std::abs(miss.distance);
    if (size < kGate) sizes.push_back(size / std::sqrt(miss.var));
  });
  if (sizes.size() < 10) return;
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  scale_ = std::max(0.2, kMadToSigma * *middle);
}

// Neighbours on one line share their errors: N / N_eff of a first order autoregression.
double Adjustment::correlation(const State& state) const {
  double product = 0.0;
  double square = 0.0;
  std::optional<double> last;
  over_misses(state, [&](const FloorMiss& miss) {
    const double z = miss.distance / std::sqrt(miss.var) / scale_;
    const bool is_inlier = std::abs(z) < 3.0;
    if (is_inlier && last) product += z * *last;
    if (is_inlier) square += z * z;
    last = is_inlier ? std::optional(z) : std::nullopt;
  });
  const double rho = square > 0.0 ? std::clamp(product / square, 0.0, 0.95) : 0.0;
  return (1.0 + rho) / (1.0 - rho);
}

double Adjustment::go_down(double width) {
  const Normals here = normals(state_, width);
  const double before = cost(state_, width);
  for (const double damping : {0.0, 1.0, 10.0, 100.0, 1000.0}) {
    const State next = step(here, damping);
    if (!look(next, false) || cost(next, width) > before + 1e-9) continue;
    const double moved = std::sqrt((next.turn - state_.turn).cwiseAbs2().dot(prior_info_));
    state_ = next;
    return moved;
  }
  return 0.0;
}

// Whether it came to rest.
bool Adjustment::descend(double width, int steps) {
  for (int i = 0; i < steps; ++i) {
    if (!look(state_, true)) return false;
    if (width < kLastWidth) measure_scale(state_);
    if (go_down(width) < kSmallStep) return true;
  }
  return false;
}

Bundle Adjustment::run() {
  for (const double width : kWidths) {
    if (width >= kLastWidth) descend(width, kStepsPerWidth);
  }
  Bundle bundle;
  bundle.converged = descend(0.0, kLastSteps);
  bundle.camera = *turned(camera_, knobs_, state_.turn);  // every accepted state is possible
  bundle.turn = state_.turn;
  for (std::size_t v = 0; v < views_.size(); ++v) views_[v].X_FR = state_.X_FR[v];
  // A camera at the edge of what can be, a row of the table about to overtake the next, is no
  // answer.
  if (look(state_, true)) {
    measure_scale(state_);
    bundle.scale = scale_;
    bundle.cost = cost(state_, 0.0);
    bundle.correlation = correlation(state_);
    const Normals last = normals(state_, 0.0);
    bundle.info = last.info / bundle.correlation;
    bundle.shared = shared(state_, last);
  }
  bundle.views = std::move(views_);
  return bundle;
}

}  // namespace

Bundle adjust(const LineMap& map,
              const CameraParameters& camera,
              std::span<const KnobPrior> priors,
              BundleStart start,
              const BundleRules& rules) {
  TEAMSIGHT_EXPECT(!start.views.empty() && !priors.empty());
  return Adjustment(map, camera, priors, std::move(start), rules).run();
}

std::vector<PaintMiss> misses_of(const LineMap& map,
                                 const CameraModel& model,
                                 const CalibrationView& view,
                                 const BundleRules& rules) {
  std::vector<PaintMiss> misses;
  for (const Pixel& pixel : view.pixels) {
    const auto floor = model.on_plane(pixel, 0.0);
    const auto per_px = model.floor_jacobian(pixel);
    if (!floor || !per_px || floor->vector().norm() > rules.max_distance) continue;
    const Eigen::Matrix2d R_FR = view.X_FR.rotation();
    const NearestLine nearest = map.nearest((view.X_FR * *floor).vector());
    // How the distance grows with the pixel.
    const Eigen::Vector2d slope = per_px->transpose() * (R_FR.transpose() * nearest.normal_F);
    const double steepness = std::max(slope.norm(), 1e-9);
    const Eigen::Vector2d out{pixel.u - model.centre().u, pixel.v - model.centre().v};
    PaintMiss miss;
    miss.distance = nearest.distance;
    miss.distance_px = nearest.distance / steepness;
    miss.radius_px = out.norm();
    miss.radial_px = miss.distance_px * slope.dot(out) / (steepness * std::max(out.norm(), 1.0));
    miss.direction = std::atan2(-out.y(), out.x());
    misses.push_back(miss);
  }
  return misses;
}

}  // namespace teamsight::vision
