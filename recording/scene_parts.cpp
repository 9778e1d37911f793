// recording/scene_parts.cpp: see recording/scene_parts.hpp.
#include "recording/scene_parts.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace teamsight::recording::parts {
namespace {

constexpr std::int64_t kNsPerS = 1'000'000'000;
constexpr double kEllipseScale = 2.4477;  // sqrt of the 95 % quantile of chi-square, 2 degrees
constexpr double kFlat = 0.01;            // m
constexpr double kShortestArrow = 0.05;   // m

}  // namespace

void set(std::int64_t ns, google::protobuf::Timestamp& to) {
  to.set_seconds(ns / kNsPerS);
  to.set_nanos(static_cast<std::int32_t>(ns % kNsPerS));
}

void set(const Eigen::Vector3d& from, foxglove::Vector3& to) {
  to.set_x(from.x());
  to.set_y(from.y());
  to.set_z(from.z());
}

void set(const Paint& from, foxglove::Color& to) {
  to.set_r(from.r);
  to.set_g(from.g);
  to.set_b(from.b);
  to.set_a(from.a);
}

void set_yaw(double yaw, foxglove::Quaternion& to) {
  to.set_z(std::sin(yaw / 2));
  to.set_w(std::cos(yaw / 2));
}

void set(const Eigen::Vector3d& position, double yaw, foxglove::Pose& to) {
  set(position, *to.mutable_position());
  set_yaw(yaw, *to.mutable_orientation());
}

foxglove::SceneEntity& add_entity(foxglove::SceneUpdate& scene,
                                  const std::string& id,
                                  std::int64_t log_ns,
                                  double lifetime_s) {
  foxglove::SceneEntity& entity = *scene.add_entities();
  set(log_ns, *entity.mutable_timestamp());
  entity.set_frame_id(kFieldFrame);
  entity.set_id(id);
  const auto lifetime_ns = static_cast<std::int64_t>(lifetime_s * 1e9);
  entity.mutable_lifetime()->set_seconds(lifetime_ns / kNsPerS);
  entity.mutable_lifetime()->set_nanos(static_cast<std::int32_t>(lifetime_ns % kNsPerS));
  return entity;
}

void add_fact(foxglove::SceneEntity& entity, const char* key, const std::string& value) {
  foxglove::KeyValuePair& pair = *entity.add_metadata();
  pair.set_key(key);
  pair.set_value(value);
}

void add_disc(foxglove::SceneEntity& entity,
              const Eigen::Vector3d& centre,
              const Eigen::Vector3d& size,
              const Paint& paint) {
  foxglove::CylinderPrimitive& disc = *entity.add_cylinders();
  set(centre, 0.0, *disc.mutable_pose());
  set(size, *disc.mutable_size());
  disc.set_bottom_scale(1.0);
  disc.set_top_scale(1.0);
  set(paint, *disc.mutable_color());
}

void add_ellipse(foxglove::SceneEntity& entity,
                 const Eigen::Vector2d& centre,
                 const Eigen::Matrix2d& cov,
                 const Paint& paint) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(cov);
  if (!cov.allFinite() || axes.eigenvalues()(0) <= 0.0) return;
  const Eigen::Vector2d half = kEllipseScale * axes.eigenvalues().cwiseSqrt();
  const Eigen::Vector2d along = axes.eigenvectors().col(0);
  add_disc(entity, {centre.x(), centre.y(), kFlat / 2}, {2 * half.x(), 2 * half.y(), kFlat}, paint);
  set_yaw(std::atan2(along.y(), along.x()),
          *entity.mutable_cylinders(entity.cylinders_size() - 1)
               ->mutable_pose()
               ->mutable_orientation());
}

void add_arrow(foxglove::SceneEntity& entity,
               const Eigen::Vector3d& tail,
               const Eigen::Vector3d& way,
               const Paint& paint) {
  const double length = way.norm();
  if (!(length >= kShortestArrow)) return;
  foxglove::ArrowPrimitive& arrow = *entity.add_arrows();
  const auto turn = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), way);
  set(tail, *arrow.mutable_pose()->mutable_position());
  foxglove::Quaternion& orientation = *arrow.mutable_pose()->mutable_orientation();
  orientation.set_x(turn.x());
  orientation.set_y(turn.y());
  orientation.set_z(turn.z());
  orientation.set_w(turn.w());
  const double head = std::min(0.2, length / 2);
  arrow.set_shaft_length(length - head);
  arrow.set_shaft_diameter(0.05);
  arrow.set_head_length(head);
  arrow.set_head_diameter(0.14);
  set(paint, *arrow.mutable_color());
}

void add_text(foxglove::SceneEntity& entity,
              const Eigen::Vector3d& place,
              const std::string& text,
              const Paint& paint) {
  foxglove::TextPrimitive& label = *entity.add_texts();
  set(place, 0.0, *label.mutable_pose());
  label.set_billboard(true);
  label.set_font_size(0.35);
  label.set_text(text);
  set(paint, *label.mutable_color());
}

}  // namespace teamsight::recording::parts
