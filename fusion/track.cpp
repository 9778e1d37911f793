// fusion/track.cpp: see fusion/track.hpp.
#include "fusion/track.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

#include "fusion/turn.hpp"

namespace teamsight::fusion {
namespace {

using PlaceView = ConsideredView<4, 2>;

// Errors are taken for Student's t around a Gaussian track, with so many degrees of freedom.
constexpr double kFreedom = 5.0;

PlanarMotion motion_of(const TrackParameters& parameters) {
  return {parameters.acceleration_psd, parameters.velocity_decay};
}

/// What is special about obstacles.
class ObstacleKind {
 public:
  using Track = fusion::Track;

  ObstacleKind(const Scene& scene, const TrackParameters& parameters)
      : scene_(scene),
        glance_(scene.glance),
        errors_(scene.errors),
        parameters_(parameters),
        observer_(scene.errors.place_of(scene.glance.robot)) {}

  void predict(Track& track, double dt) const {
    const PlanarStep step = planar_step(dt, motion_of(parameters_));
    track.state.predict(step.transition, step.transition * track.state.mean, step.disturbance);
  }

  [[nodiscard]] Eigen::Vector2d place(const Track& track) const {
    return track.state.mean.head<2>();
  }

  /// No two bodies stand in one place.
  static bool may_be_one(const Track& /*a*/, const Track& /*b*/) { return true; }

  /// No gate reaches further than this.
  [[nodiscard]] double farthest(const Track& track) const {
    return 2.5 + 4.0 * std::sqrt(track.state.cov(0, 0) + track.state.cov(1, 1));
  }

  [[nodiscard]] Gap gap(const Track& track, const Candidate& candidate) const {
    const PlaceView view = view_of(track, candidate);
    return gap_of(view, gap_covariance(track.state, view, errors_));
  }

  Gap hit(Track& track, const Candidate& candidate) const {
    PlaceView view = view_of(track, candidate);
    Eigen::Matrix2d cov = gap_covariance(track.state, view, errors_);
    const Gap gap = gap_of(view, cov);
    const double tail = tail_factor(gap.squared_distance, 2);
    cov += (tail - 1.0) * view.cov;
    take_view(track.state, view, errors_, cov);
    // A running mean that never gets too slow to learn.
    track.radius += (candidate.radius - track.radius) / std::min(track.book.hits + 1U, 20U);
    return gap;
  }

  [[nodiscard]] double missed(const Track& track) const {
    return missed_probability(place(track), scene_, parameters_);
  }

  [[nodiscard]] std::optional<Track> begin(const Candidate& candidate) const {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(candidate.measurement.cov_F,
                                                              Eigen::EigenvaluesOnly);
    if (std::sqrt(axes.eigenvalues().maxCoeff()) > parameters_.max_sigma_at_birth) {
      return std::nullopt;
    }
    Track track;
    track.book = first_page(
        candidate.key, {glance_.robot, glance_.exposure, candidate.confidence}, parameters_);
    track.book.doubt = candidate.doubt;
    track.radius = candidate.radius;
    track.state.mean << candidate.measurement.p_F, 0.0, 0.0;
    track.state.cov.setZero();
    track.state.cov.topLeftCorner<2, 2>() = candidate.measurement.cov_F;
    track.state.cov.bottomRightCorner<2, 2>() =
        std::pow(parameters_.sigma_speed_at_birth, 2) * Eigen::Matrix2d::Identity();
    if (observer_ != kNoPlace) {
      const auto slope = place_slope(way_to(candidate));
      track.state.mean.head<2>() -= slope * errors_.mean(observer_);
      track.state.cov.topLeftCorner<2, 2>() =
          candidate.cov_own + slope * errors_.cov(observer_) * slope.transpose();
      track.state.cross.topRows<2>() = -slope * errors_.cov_with_all(observer_);
    }
    return track;
  }

 private:
  [[nodiscard]] Eigen::Vector2d way_to(const Candidate& candidate) const {
    return candidate.measurement.p_F - glance_.observer();
  }

  static Gap gap_of(const PlaceView& view, const Eigen::Matrix2d& cov) {
    return {view.gap.dot(cov.inverse() * view.gap), 2, std::log(cov.determinant()), 1.0};
  }

  [[nodiscard]] PlaceView view_of(const Track& track, const Candidate& candidate) const {
    PlaceView view;
    view.slope.setZero();
    view.slope.leftCols<2>().setIdentity();
    view.slope_errors = place_slope(way_to(candidate));
    view.observer = observer_;
    view.gap = candidate.measurement.p_F - track.state.mean.head<2>();
    view.cov = candidate.cov_own;
    if (observer_ != kNoPlace) view.gap -= view.slope_errors * errors_.mean(observer_);
    // An uncertain stamp moves a fast thing.
    const Eigen::Vector2d way = track.state.mean.tail<2>() * to_seconds(glance_.sigma_exposure);
    view.cov += way * way.transpose();
    return view;
  }

  const Scene& scene_;
  const Glance& glance_;
  const TeamErrors& errors_;
  const TrackParameters& parameters_;
  ErrorPlace observer_;
};

}  // namespace

double tail_factor(double squared_distance, int degrees) {
  return std::max(1.0, (kFreedom + squared_distance) / (kFreedom + degrees));
}

double tail_density(double squared_distance, const Eigen::Matrix2d& inverse_cov) {
  return std::pow(1.0 + squared_distance / kFreedom, -0.5 * (kFreedom + 2.0)) *
         std::sqrt(inverse_cov.determinant()) / (2.0 * std::numbers::pi);
}

std::uint32_t take_in(TrackList& tracks,
                      const CandidateList& candidates,
                      const Scene& scene,
                      const TrackParameters& parameters) {
  const ObstacleKind kind(scene, parameters);
  return Turn<ObstacleKind, TrackList>(kind, tracks, candidates, scene, parameters).take();
}

PlanarMoments moments_at(const Track& track, HostTime now, const TrackParameters& parameters) {
  return predicted({track.state.mean, track.state.cov},
                   to_seconds(now - track.book.time),
                   motion_of(parameters));
}

}  // namespace teamsight::fusion
