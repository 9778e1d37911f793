// vision/calibration/floor_look.cpp: central differences through neighbouring cameras.
#include "vision/calibration/floor_look.hpp"

#include <algorithm>

namespace teamsight::vision {

std::optional<FloorLooker> FloorLooker::make(const CameraParameters& camera,
                                             std::span<const CameraKnob> knobs,
                                             const Eigen::VectorXd& turn,
                                             bool with_slopes) {
  const auto here = turned(camera, knobs, turn);
  if (!here) return std::nullopt;
  FloorLooker looker{CameraModel(*here)};
  for (std::size_t k = 0; with_slopes && k < knobs.size(); ++k) {
    const double nudge = nudge_of(knobs[k]);
    Eigen::VectorXd beside = turn;
    beside[static_cast<Eigen::Index>(k)] += nudge;
    const auto ahead = turned(camera, knobs, beside);
    beside[static_cast<Eigen::Index>(k)] -= 2.0 * nudge;
    const auto behind = turned(camera, knobs, beside);
    if (!ahead || !behind) return std::nullopt;
    looker.neighbours_.push_back({CameraModel(*ahead), CameraModel(*behind), 2.0 * nudge});
  }
  return looker;
}

std::optional<FloorLook> FloorLooker::look(const Pixel& pixel) const {
  const auto floor = model_.on_plane(pixel, 0.0);
  const auto per_px = model_.floor_jacobian(pixel);
  if (!floor || !per_px) return std::nullopt;
  FloorLook seen;
  seen.pixel = pixel;
  seen.p_R = floor->vector();
  seen.per_px = *per_px;
  seen.per_knob.resize(2, static_cast<Eigen::Index>(neighbours_.size()));
  Eigen::Index column = 0;
  for (const Neighbours& knob : neighbours_) {
    const auto ahead = knob.ahead.on_plane(pixel, 0.0);
    const auto behind = knob.behind.on_plane(pixel, 0.0);
    if (!ahead || !behind) return std::nullopt;
    seen.per_knob.col(column++) = (ahead->vector() - behind->vector()) / knob.step;
  }
  return seen;
}

FloorMiss miss_of(const LineMap& map,
                  const Pose<Field, Robot>& X_FR,
                  const FloorLook& seen,
                  double sigma_px) {
  constexpr double kLeastVar = 1e-6;  // m^2: paint is not straighter than a millimetre
  const Eigen::Matrix2d R_FR = X_FR.rotation();
  const Eigen::Vector2d p_RL_F = R_FR * seen.p_R;
  const NearestLine nearest = map.nearest(X_FR.origin().vector() + p_RL_F);
  const Eigen::Vector2d& n = nearest.normal_F;
  const Eigen::Vector2d n_R = R_FR.transpose() * n;
  FloorMiss miss;
  miss.distance = nearest.distance;
  miss.by_posture = {n.x(), n.y(), n.dot(Eigen::Vector2d(-p_RL_F.y(), p_RL_F.x()))};
  miss.by_knob = seen.per_knob.transpose() * n_R;
  miss.by_pixel = seen.per_px.transpose() * n_R;
  miss.var = kLeastVar + sigma_px * sigma_px * miss.by_pixel.squaredNorm();
  return miss;
}

}  // namespace teamsight::vision
