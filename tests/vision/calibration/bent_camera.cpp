// tests/vision/calibration/bent_camera.cpp: implicit surface, bisection, numerical normals.
#include "tests/vision/calibration/bent_camera.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace teamsight::vision {

namespace {

// The mirror: y = kApex + kRise (sqrt(kRound^2 + x^2) - kRound), x up to kRim; m.
constexpr double kApex = 0.1314;
constexpr double kRise = 0.78;
constexpr double kRound = 0.05;
constexpr double kRim = 0.078;
constexpr double kHeight = 0.6286;
constexpr double kFocal = 480.0;  // px
constexpr double kMiddleU = 319.5;
constexpr double kMiddleV = 239.5;

double mirror_height(double x) {
  return kApex + kRise * (std::hypot(kRound, x) - kRound);
}

Eigen::Matrix3d turn_x(double a) {
  Eigen::Matrix3d m;
  m << 1, 0, 0, 0, std::cos(a), -std::sin(a), 0, std::sin(a), std::cos(a);
  return m;
}

Eigen::Matrix3d turn_y(double a) {
  Eigen::Matrix3d m;
  m << std::cos(a), 0, std::sin(a), 0, 1, 0, -std::sin(a), 0, std::cos(a);
  return m;
}

}  // namespace

Defects random_defects(std::mt19937& random) {
  std::uniform_real_distribution<double> either(-1.0, 1.0);
  const double tilt = 0.3 * std::numbers::pi / 180.0;
  Defects defects;
  defects.focal_ratio = 0.01 * either(random);
  defects.offset_m = 0.0005 * Eigen::Vector3d(either(random), either(random), either(random));
  defects.tilt_rad = tilt * Eigen::Vector2d(either(random), either(random));
  defects.head_rad = tilt * Eigen::Vector2d(either(random), either(random));
  return defects;
}

CameraParameters drawn_camera() {
  CameraParameters camera;
  camera.width_px = 640;
  camera.height_px = 480;
  camera.forward = 0.0;  // C's x axis is R's
  camera.mirrored = true;
  ProfileMirror mirror;
  mirror.focal_x_px = mirror.focal_y_px = kFocal;
  mirror.centre_u_px = kMiddleU;
  mirror.centre_v_px = kMiddleV;
  mirror.pinhole_height = kHeight;
  constexpr int kPoints = 120;
  for (int i = 0; i <= kPoints; ++i) {
    const double x = kRim * i / kPoints;
    mirror.profile.push_back({x, mirror_height(x)});
  }
  camera.mirror = mirror;
  return camera;
}

BentCamera::BentCamera(const Defects& defects)
    : focal_(kFocal * (1.0 + defects.focal_ratio)),
      centre_(Eigen::Vector2d(kMiddleU, kMiddleV) + defects.centre_px),
      axes_C_(turn_y(defects.head_rad.y()) * turn_x(defects.head_rad.x())),
      pinhole_(0.0, 0.0, kHeight + defects.height_m),
      axes_M_(axes_C_ * turn_y(defects.tilt_rad.y()) * turn_x(defects.tilt_rad.x())),
      apex_(pinhole_ + axes_C_ * (Eigen::Vector3d(0.0, 0.0, kApex) + defects.offset_m)) {}

double BentCamera::above_mirror(const Eigen::Vector3d& p_R) const {
  const Eigen::Vector3d q = axes_M_.transpose() * (p_R - apex_);
  return q.z() + kApex - mirror_height(std::sqrt(q.x() * q.x() + q.y() * q.y()));
}

std::optional<Eigen::Vector2d> BentCamera::floor_at(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d off = (pixel - centre_) / focal_;
  const Eigen::Vector3d sight = (axes_C_ * Eigen::Vector3d(off.x(), off.y(), 1.0)).normalized();
  double low = 0.0;
  double high = 0.4;
  if (above_mirror(pinhole_ + high * sight) < 0.0) return std::nullopt;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (above_mirror(pinhole_ + middle * sight) < 0.0 ? low : high) = middle;
  }
  const Eigen::Vector3d p = pinhole_ + low * sight;
  if ((axes_M_.transpose() * (p - apex_)).head<2>().norm() > kRim) return std::nullopt;
  Eigen::Vector3d normal;
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d nudge = 1e-6 * Eigen::Vector3d::Unit(axis);
    normal[axis] = above_mirror(p + nudge) - above_mirror(p - nudge);
  }
  // Householder: the component along the normal changes its sign.
  const Eigen::Vector3d away = sight - 2.0 * normal * normal.dot(sight) / normal.squaredNorm();
  if (away.z() > -1e-6) return std::nullopt;
  const Eigen::Vector3d floor = p - away * p.z() / away.z();
  return Eigen::Vector2d(floor.head<2>());
}

std::optional<Eigen::Vector2d> BentCamera::pixel_of(const Eigen::Vector2d& p_R) const {
  const Eigen::Vector2d out = p_R.normalized();
  double low = 1.0;
  double high = 300.0;
  for (int i = 0; i < 12; ++i) {
    const double middle = 0.5 * (low + high);
    const auto floor = floor_at(centre_ + middle * out);
    (floor && floor->norm() < p_R.norm() ? low : high) = middle;
  }
  Eigen::Vector2d pixel = centre_ + low * out;
  for (int i = 0; i < 6; ++i) {
    const auto here = floor_at(pixel);
    const auto right = floor_at(pixel + Eigen::Vector2d(0.01, 0.0));
    const auto below = floor_at(pixel + Eigen::Vector2d(0.0, 0.01));
    if (!here || !right || !below) return std::nullopt;
    Eigen::Matrix2d slope;
    slope << (*right - *here), (*below - *here);
    const Eigen::Vector2d change = 0.01 * (slope.inverse() * (p_R - *here));
    pixel += change;
    if (change.norm() < 1e-7) return pixel;
  }
  return std::nullopt;
}

std::vector<Pixel> see_lines(const BentCamera& camera,
                             const FieldModel& field,
                             const Pose<Field, Robot>& X_FR,
                             const LineSight& sight,
                             std::mt19937& random) {
  std::vector<Eigen::Vector2d> paint;
  for (const FieldLine& line : field.lines) {
    const Eigen::Vector2d along = line.to.vector() - line.from.vector();
    for (double s = 0.5 * sight.spacing; s < along.norm(); s += sight.spacing) {
      paint.emplace_back(line.from.vector() + s * along.normalized());
    }
  }
  for (const FieldArc& arc : field.arcs) {
    for (double s = 0.0; s < arc.sweep * arc.radius; s += sight.spacing) {
      const double a = arc.start + s / arc.radius;
      paint.emplace_back(arc.centre.vector() +
                         arc.radius * Eigen::Vector2d(std::cos(a), std::sin(a)));
    }
  }
  std::normal_distribution<double> noise(0.0, sight.sigma_px);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const double hidden = 2.0 * std::numbers::pi * share(random);
  std::vector<Pixel> pixels;
  for (const Eigen::Vector2d& p : paint) {
    const Point<Robot> p_R = X_FR.inverse() * Point<Field>::from(p);
    const double range = p_R.vector().norm();
    if (range > sight.range || range < 0.5) continue;
    if (std::abs(angle_difference(std::atan2(p_R.y, p_R.x), hidden)) < 0.3) continue;
    const auto pixel = camera.pixel_of(p_R.vector());
    if (!pixel) continue;
    if (share(random) < sight.outliers) {
      pixels.push_back({100.0 + 440.0 * share(random), 20.0 + 440.0 * share(random)});
    } else {
      pixels.push_back({pixel->x() + noise(random), pixel->y() + noise(random)});
    }
  }
  return pixels;
}

double ground_error(const BentCamera& camera, const CameraModel& model) {
  double sum = 0.0;
  int count = 0;
  for (int ring = 2; ring <= 12; ++ring) {
    for (int i = 0; i < 36; ++i) {
      const double azimuth = 2.0 * std::numbers::pi * i / 36;
      const Eigen::Vector2d p_R =
          0.5 * ring * Eigen::Vector2d(std::cos(azimuth), std::sin(azimuth));
      const auto pixel = camera.pixel_of(p_R);
      if (!pixel) continue;
      const auto place = model.on_plane({pixel->x(), pixel->y()}, 0.0);
      if (!place) continue;
      sum += (place->vector() - p_R).squaredNorm();
      ++count;
    }
  }
  return count > 0 ? std::sqrt(sum / count) : HUGE_VAL;
}

}  // namespace teamsight::vision
