// sim/render/optics.cpp: see optics.hpp.
#include "sim/render/optics.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "geometry/expect.hpp"

namespace teamsight::sim {
namespace {

// Turns about x, then y, then z.
Eigen::Matrix3d turned(double about_x, double about_y, double about_z) {
  const Eigen::Quaterniond q = Eigen::AngleAxisd(about_z, Eigen::Vector3d::UnitZ()) *
                               Eigen::AngleAxisd(about_y, Eigen::Vector3d::UnitY()) *
                               Eigen::AngleAxisd(about_x, Eigen::Vector3d::UnitX());
  return q.toRotationMatrix();
}

// Steffen's monotone cubic: the slope at a row from the secants on both sides, never so steep that
// the curve would turn back.
std::vector<double> steffen(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size();
  std::vector<double> secant(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    secant[i] = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
  }
  std::vector<double> slope(n);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double left = x[i] - x[i - 1];
    const double right = x[i + 1] - x[i];
    const double parabola = (secant[i - 1] * right + secant[i] * left) / (left + right);
    const double least = std::min(std::abs(secant[i - 1]), std::abs(secant[i]));
    const bool turns = secant[i - 1] * secant[i] <= 0.0;
    slope[i] = turns ? 0.0 : std::copysign(std::min(std::abs(parabola), 2.0 * least), secant[i]);
  }
  const auto at_end = [&](double near_secant, double inner_slope) {
    const double free = 1.5 * near_secant - 0.5 * inner_slope;
    return std::clamp(free, 0.0, 2.0 * std::max(near_secant, 0.0));
  };
  slope.front() = n > 2 ? at_end(secant.front(), slope[1]) : secant.front();
  slope.back() = n > 2 ? at_end(secant.back(), slope[n - 2]) : secant.back();
  return slope;
}

}  // namespace

Optics::Optics(const vision::CameraParameters& camera)
    : width_px_(camera.width_px),
      height_px_(camera.height_px),
      forward_(camera.forward),
      mirrored_(camera.mirrored),
      eye_(make_eye(camera)) {
  std::visit(
      [this](const auto& mirror) {
        centre_ = {mirror.centre_u_px, mirror.centre_v_px};
      },
      camera.mirror);
}

std::variant<Optics::Table, Optics::Mirror> Optics::make_eye(
    const vision::CameraParameters& camera) {
  if (const auto* table = std::get_if<vision::RadialTable>(&camera.mirror)) {
    return make_table(*table);
  }
  return make_mirror(
      std::get<vision::ProfileMirror>(camera.mirror), camera.forward, camera.mirrored);
}

Optics::Table Optics::make_table(const vision::RadialTable& table) {
  TEAMSIGHT_EXPECT(table.rows.size() >= 2);
  Table made;
  made.height = table.mirror_height;
  for (const vision::RingMark& row : table.rows) {
    made.radius_px.push_back(row.radius_px);
    made.angle.push_back(std::atan2(row.distance, table.mirror_height));
  }
  made.steepness = steffen(made.radius_px, made.angle);
  return made;
}

// A camera that looks up sees the world as in a mirror: x to image right, y to image bottom. One
// whose picture is not mirrored was turned over top to bottom.
Optics::Mirror Optics::make_mirror(const vision::ProfileMirror& mirror,
                                   double forward,
                                   bool mirrored) {
  Mirror made{Meridian(mirror.profile),
              mirror.focal_x_px,
              mirror.focal_y_px,
              !mirrored,
              {},
              {},
              {},
              mirror.pinhole_height};
  made.R_CM = turned(mirror.tilt_C[0], mirror.tilt_C[1], 0.0);
  made.R_RC = turned(mirror.head_roll, mirror.head_pitch, 0.0) *
              turned(0.0, 0.0, mirrored ? forward : -forward);
  // p_C = R_CM (p_M - apex) + apex + offset, solved for the pinhole, which is C's origin.
  const Eigen::Vector3d apex(0.0, 0.0, made.meridian.at(0.0).height);
  const Eigen::Vector3d offset(mirror.offset_C[0], mirror.offset_C[1], mirror.offset_C[2]);
  made.pinhole_M = apex - made.R_CM.transpose() * (apex + offset);
  return made;
}

std::optional<Ray<Robot>> Optics::look(const ImagePlace& place) const {
  const double du = place.u - centre_.u;
  const double dv = place.v - centre_.v;
  if (const auto* table = std::get_if<Table>(&eye_)) {
    return look(*table, du, dv);
  }
  return look(std::get<Mirror>(eye_), du, dv);
}

std::optional<Ray<Robot>> Optics::look(const Table& table, double du, double dv) const {
  const double radius = std::sqrt(du * du + dv * dv);
  if (radius < table.radius_px.front() || radius > table.radius_px.back()) {
    return std::nullopt;
  }
  const auto above =
      std::upper_bound(table.radius_px.begin() + 1, table.radius_px.end() - 1, radius);
  const auto i = static_cast<std::size_t>(above - table.radius_px.begin()) - 1;
  const double width = table.radius_px[i + 1] - table.radius_px[i];
  const double secant = (table.angle[i + 1] - table.angle[i]) / width;
  const double t = radius - table.radius_px[i];
  const double a = (table.steepness[i] + table.steepness[i + 1] - 2.0 * secant) / (width * width);
  const double b = (3.0 * secant - 2.0 * table.steepness[i] - table.steepness[i + 1]) / width;
  const double angle = table.angle[i] + t * (table.steepness[i] + t * (b + t * a));
  const double in_picture = std::atan2(-dv, du);
  const double heading = mirrored_ ? forward_ - in_picture : in_picture - forward_;
  return Ray<Robot>{
      {0.0, 0.0, table.height},
      {std::sin(angle) * std::cos(heading), std::sin(angle) * std::sin(heading), -std::cos(angle)}};
}

// Marches up between the mirror's lowest and highest point until the line of sight has come through
// the surface, then closes in on where (Illinois' rule).
std::optional<Eigen::Vector3d> Optics::first_hit(const Mirror& mirror,
                                                 const Eigen::Vector3d& sight_M) {
  if (sight_M.z() <= 1e-9) {
    return std::nullopt;
  }
  const Meridian& meridian = mirror.meridian;
  const auto place = [&](double t) -> Eigen::Vector3d {
    return mirror.pinhole_M + t * sight_M;
  };
  const auto above = [&](double t) {
    const Eigen::Vector3d p = place(t);
    return p.z() - meridian.at(std::sqrt(p.x() * p.x() + p.y() * p.y())).height;
  };
  constexpr int kSteps = 12;
  constexpr double kMargin = 1e-6;  // m
  double low = (meridian.lowest() - kMargin - mirror.pinhole_M.z()) / sight_M.z();
  const double end = (meridian.highest() + kMargin - mirror.pinhole_M.z()) / sight_M.z();
  const double step = (end - low) / kSteps;
  double f_low = above(low);
  double high = low + step;
  double f_high = above(high);
  for (int i = 1; i < kSteps && f_high < 0.0; ++i) {
    low = high;
    f_low = f_high;
    high = low + step;
    f_high = above(high);
  }
  if (f_low > 0.0 || f_high < 0.0) {
    return std::nullopt;
  }
  double t = high;
  for (int i = 0; i < 60 && high - low > 1e-13; ++i) {
    t = (low * f_high - high * f_low) / (f_high - f_low);
    const double f = above(t);
    if (std::abs(f) < 1e-14) {
      break;
    }
    if (f > 0.0) {
      high = t;
      f_high = f;
      f_low *= 0.5;
    } else {
      low = t;
      f_low = f;
      f_high *= 0.5;
    }
  }
  return place(t);
}

std::optional<Ray<Robot>> Optics::look(const Mirror& mirror, double du, double dv) {
  const double down = mirror.turned_over ? -dv : dv;
  const Eigen::Vector3d sight_C =
      Eigen::Vector3d(du / mirror.focal_x_px, down / mirror.focal_y_px, 1.0).normalized();
  const Eigen::Vector3d sight_M = mirror.R_CM.transpose() * sight_C;
  const auto hit = first_hit(mirror, sight_M);
  if (!hit.has_value()) {
    return std::nullopt;
  }
  const double x = std::sqrt(hit->x() * hit->x() + hit->y() * hit->y());
  if (x < mirror.meridian.inner() || x > mirror.meridian.outer()) {
    return std::nullopt;
  }
  // The surface's tangents along and around the meridian; their product is its normal.
  const double slope = mirror.meridian.at(x).slope;
  const double c = x > 1e-12 ? hit->x() / x : 1.0;
  const double s = x > 1e-12 ? hit->y() / x : 0.0;
  const bool is_tip = x <= 1e-12;
  const Eigen::Vector3d along(c, s, is_tip ? 0.0 : slope);
  const Eigen::Vector3d around(-s, c, 0.0);
  const Eigen::Vector3d normal = along.cross(around).normalized();
  const Eigen::Matrix3d reflection =
      Eigen::Matrix3d::Identity() - 2.0 * normal * normal.transpose();
  const Eigen::Vector3d away_C = mirror.R_CM * (reflection * sight_M);
  const Eigen::Vector3d hit_C = mirror.R_CM * (*hit - mirror.pinhole_M);
  const Eigen::Vector3d hit_R =
      mirror.R_RC * hit_C + Eigen::Vector3d(0.0, 0.0, mirror.pinhole_height);
  return Ray<Robot>{Point3<Robot>::from(hit_R), (mirror.R_RC * away_C).normalized()};
}

std::optional<ImagePlace> Optics::nearest_look(const Point3<Robot>& p_R) const {
  constexpr std::uint32_t kStride = 6;  // px
  std::optional<ImagePlace> best;
  double closest = 0.9;  // cosine of the angle between line of sight and point
  const std::uint32_t columns = width_px_ / kStride;
  for (std::uint32_t i = 0; i < columns * (height_px_ / kStride); ++i) {
    const std::uint32_t column = i % columns;
    const std::uint32_t row = i / columns;
    const ImagePlace place{static_cast<double>(kStride * column),
                           static_cast<double>(kStride * row)};
    const auto seen = look(place);
    const double near =
        seen.has_value() ? (p_R.vector() - seen->origin.vector()).normalized().dot(seen->direction)
                         : -1.0;
    if (near > closest) {
      closest = near;
      best = place;
    }
  }
  return best;
}

std::optional<ImagePlace> Optics::find(const Point3<Robot>& p_R) const {
  std::optional<ImagePlace> place = nearest_look(p_R);
  const auto miss = [&](const ImagePlace& at) -> std::optional<Eigen::Vector2d> {
    const auto seen = look(at);
    if (!seen.has_value()) {
      return std::nullopt;
    }
    const Eigen::Vector3d way = p_R.vector() - seen->origin.vector();
    const Eigen::Vector3d side = Eigen::Vector3d::UnitZ().cross(seen->direction).normalized();
    const Eigen::Vector3d up = seen->direction.cross(side);
    return Eigen::Vector2d(way.dot(side), way.dot(up)) / way.norm();
  };
  for (int i = 0; i < 20 && place.has_value(); ++i) {
    constexpr double kNudge = 0.05;  // px
    const auto here = miss(*place);
    const auto right = miss({place->u + kNudge, place->v});
    const auto below = miss({place->u, place->v + kNudge});
    if (!here.has_value() || !right.has_value() || !below.has_value()) {
      return std::nullopt;
    }
    Eigen::Matrix2d jacobian;
    jacobian << (*right - *here) / kNudge, (*below - *here) / kNudge;
    Eigen::Vector2d step = -jacobian.fullPivLu().solve(*here);
    if (step.norm() > 10.0) {
      step *= 10.0 / step.norm();
    }
    place = ImagePlace{place->u + step.x(), place->v + step.y()};
    if (step.norm() < 1e-4) {
      return place;
    }
  }
  return std::nullopt;
}

}  // namespace teamsight::sim
