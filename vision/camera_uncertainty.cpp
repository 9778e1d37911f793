// vision/camera_uncertainty.cpp: central differences over pixels, points and knobs.
#include "vision/camera_uncertainty.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "geometry/angle.hpp"
#include "vision/camera_knobs.hpp"

namespace teamsight::vision {

namespace {

constexpr double kPixelNudge = 0.05;  // px
constexpr double kPointNudge = 1e-3;  // m

using Vector2 = std::optional<Eigen::Vector2d>;

// Half the difference; nothing if one of the two is missing.
Vector2 half_difference(const Vector2& ahead, const Vector2& behind) {
  if (!ahead || !behind) return std::nullopt;
  return Eigen::Vector2d(0.5 * (*ahead - *behind));
}

std::optional<CameraModel> turned_model(const CameraParameters& camera,
                                        std::span<const CameraKnob> knobs,
                                        std::size_t k,
                                        double by) {
  Eigen::VectorXd turn = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(knobs.size()));
  turn[static_cast<Eigen::Index>(k)] = by;
  const auto parameters = turned(camera, knobs, turn);
  return parameters ? std::optional(CameraModel(*parameters)) : std::nullopt;
}

// The covariance that an isotropic error of the pixel gives to what `look` sees there.
template <class Look>
std::optional<Eigen::Matrix2d> pixel_cov(const Look& look, const Pixel& pixel, double sigma_px) {
  const auto du = half_difference(look(Pixel{pixel.u + kPixelNudge, pixel.v}),
                                  look(Pixel{pixel.u - kPixelNudge, pixel.v}));
  const auto dv = half_difference(look(Pixel{pixel.u, pixel.v + kPixelNudge}),
                                  look(Pixel{pixel.u, pixel.v - kPixelNudge}));
  if (!du || !dv) return std::nullopt;
  const double scale = sigma_px / kPixelNudge;
  return Eigen::Matrix2d(scale * scale * (*du * du->transpose() + *dv * dv->transpose()));
}

// How a direction differs from `middle`: up, and to the left.
Eigen::Vector2d turn_between(const Eigen::Vector3d& middle, const Eigen::Vector3d& direction) {
  const auto elevation = [](const Eigen::Vector3d& d) {
    return std::atan2(d.z(), d.head<2>().norm());
  };
  const auto azimuth = [](const Eigen::Vector3d& d) {
    return std::atan2(d.y(), d.x());
  };
  return {elevation(direction) - elevation(middle),
          middle.head<2>().norm() * angle_difference(azimuth(direction), azimuth(middle))};
}

}  // namespace

CameraUncertainty::CameraUncertainty(const CameraParameters& parameters) : model_(parameters) {
  if (!parameters.calibration) return;
  const std::vector<CameraKnob>& knobs = parameters.calibration->knobs;
  const auto size = static_cast<Eigen::Index>(knobs.size());
  cov_nudges_ = Eigen::Map<const Eigen::MatrixXd>(parameters.calibration->cov.data(), size, size);
  for (std::size_t k = 0; k < knobs.size(); ++k) {
    const double nudge = nudge_of(knobs[k]);
    auto ahead = turned_model(parameters, knobs, k, nudge);
    auto behind = turned_model(parameters, knobs, k, -nudge);
    // Rows of a table that lie closer together than a nudge: nothing can be said then.
    if (!ahead || !behind) ahead = behind = model_;
    nudged_.emplace_back(std::move(*ahead), std::move(*behind));
    cov_nudges_.row(static_cast<Eigen::Index>(k)) /= nudge;
    cov_nudges_.col(static_cast<Eigen::Index>(k)) /= nudge;
  }
}

// The covariance of look(model) that comes from the knobs; zero without a calibration record.
template <class Look>
std::optional<Eigen::Matrix2d> CameraUncertainty::calibration_cov(const Look& look) const {
  Eigen::Matrix2Xd slope(2, static_cast<Eigen::Index>(nudged_.size()));
  Eigen::Index column = 0;
  for (const auto& [ahead, behind] : nudged_) {
    const auto change = half_difference(look(ahead), look(behind));
    if (!change) return std::nullopt;
    slope.col(column++) = *change;
  }
  if (column == 0) return Eigen::Matrix2d(Eigen::Matrix2d::Zero());
  return Eigen::Matrix2d(slope * cov_nudges_ * slope.transpose());
}

std::optional<UncertainRay> CameraUncertainty::ray(const Pixel& pixel, double sigma_px) const {
  const auto seen = model_.ray(pixel);
  if (!seen) return std::nullopt;
  const auto look_through = [&](const CameraModel& model, const Pixel& at) -> Vector2 {
    const auto other = model.ray(at);
    if (!other) return std::nullopt;
    return turn_between(seen->direction, other->direction);
  };
  const auto noise =
      pixel_cov([&](const Pixel& at) { return look_through(model_, at); }, pixel, sigma_px);
  const auto common =
      calibration_cov([&](const CameraModel& model) { return look_through(model, pixel); });
  if (!noise || !common) return std::nullopt;
  return UncertainRay{*seen, *noise + *common};
}

std::optional<UncertainPlace> CameraUncertainty::on_plane(const Pixel& pixel,
                                                          double height,
                                                          double sigma_px) const {
  const auto place = model_.on_plane(pixel, height);
  if (!place) return std::nullopt;
  const auto look_through = [&](const CameraModel& model, const Pixel& at) -> Vector2 {
    const auto other = model.on_plane(at, height);
    return other ? Vector2(other->vector()) : std::nullopt;
  };
  const auto noise =
      pixel_cov([&](const Pixel& at) { return look_through(model_, at); }, pixel, sigma_px);
  const auto common =
      calibration_cov([&](const CameraModel& model) { return look_through(model, pixel); });
  if (!noise || !common) return std::nullopt;
  return UncertainPlace{*place, *noise + *common};
}

std::optional<UncertainPixel> CameraUncertainty::project(const Point3<Robot>& p_R,
                                                         const Eigen::Matrix3d& cov_R) const {
  const auto pixel = model_.project(p_R);
  if (!pixel) return std::nullopt;
  const auto look_through = [](const CameraModel& model, const Point3<Robot>& at) -> Vector2 {
    const auto other = model.project(at);
    return other ? Vector2(Eigen::Vector2d(other->u, other->v)) : std::nullopt;
  };
  Eigen::Matrix<double, 2, 3> slope;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d nudge = kPointNudge * Eigen::Vector3d::Unit(axis);
    const auto change =
        half_difference(look_through(model_, Point3<Robot>::from(p_R.vector() + nudge)),
                        look_through(model_, Point3<Robot>::from(p_R.vector() - nudge)));
    if (!change) return std::nullopt;
    slope.col(axis) = *change / kPointNudge;
  }
  const auto common =
      calibration_cov([&](const CameraModel& model) { return look_through(model, p_R); });
  if (!common) return std::nullopt;
  return UncertainPixel{*pixel, slope * cov_R * slope.transpose() + *common};
}

}  // namespace teamsight::vision
