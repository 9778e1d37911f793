// vision/ball_blob.cpp: see vision/ball_blob.hpp.
#include "vision/ball_blob.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace teamsight::vision {

BallBlob& BallBlob::operator+=(const BallBlob& other) {
  pixels += other.pixels;
  solid_angle += other.solid_angle;
  sum_u += other.sum_u;
  sum_v += other.sum_v;
  sum_uu += other.sum_uu;
  sum_uv += other.sum_uv;
  sum_vv += other.sum_vv;
  sum_u_chroma += other.sum_u_chroma;
  sum_v_chroma += other.sum_v_chroma;
  sum_direction += other.sum_direction;
  sum_origin += other.sum_origin;
  sum_square += other.sum_square;
  outline += other.outline;
  return *this;
}

bool is_cut(const BallBlob& blob) {
  constexpr double kLeastCut = 0.05;  // of the outline
  const auto cut = static_cast<double>(blob.outline.cut);
  return cut > kLeastCut * (cut + static_cast<double>(blob.outline.pixels));
}

BlobEllipse ellipse_of(const BallBlob& blob) {
  const auto count = static_cast<double>(blob.pixels);
  BlobEllipse ellipse;
  ellipse.u = blob.sum_u / count;
  ellipse.v = blob.sum_v / count;
  const double uu = blob.sum_uu / count - ellipse.u * ellipse.u;
  const double vv = blob.sum_vv / count - ellipse.v * ellipse.v;
  const double uv = blob.sum_uv / count - ellipse.u * ellipse.v;
  const double middle = 0.5 * (uu + vv);
  const double reach = std::hypot(0.5 * (uu - vv), uv);
  ellipse.major = 2.0 * std::sqrt(middle + reach);
  ellipse.minor = 2.0 * std::sqrt(std::max(0.0, middle - reach));
  ellipse.direction = 0.5 * std::atan2(2.0 * uv, uu - vv);
  return ellipse;
}

namespace {

/// Variances of a blob's directions along and across its larger axis.
struct Spread {
  double larger{0.0};
  double smaller{0.0};
};

Spread spread_of(const BallBlob& blob) {
  if (blob.solid_angle <= 0.0) return {};
  const Eigen::Vector3d mean = blob.sum_direction / blob.solid_angle;
  const Eigen::Matrix3d spread = blob.sum_square / blob.solid_angle - mean * mean.transpose();
  const Eigen::Vector3d a = mean.unitOrthogonal();
  const Eigen::Vector3d b = mean.normalized().cross(a);
  const double aa = a.dot(spread * a);
  const double bb = b.dot(spread * b);
  const double ab = a.dot(spread * b);
  const double middle = 0.5 * (aa + bb);
  const double reach = std::hypot(0.5 * (aa - bb), ab);
  return {std::max(0.0, middle + reach), std::max(0.0, middle - reach)};
}

}  // namespace

double angular_extent_of(const BallBlob& blob) {
  // A disc's variance along any axis is a quarter of its radius squared.
  return std::asin(std::min(1.0, 2.0 * std::sqrt(spread_of(blob).larger)));
}

double roundness_of(const BallBlob& blob) {
  const Spread spread = spread_of(blob);
  return spread.larger > 0.0 ? std::sqrt(spread.smaller / spread.larger) : 0.0;
}

}  // namespace teamsight::vision
