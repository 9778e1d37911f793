// recording/scene_parts.hpp: the small parts that scenes are built of. For recording/ only.
#pragma once

#include <cstdint>
#include <string>

#include <Eigen/Core>

#include "foxglove.pb.h"

namespace teamsight::recording::parts {

/// Red, green, blue and opacity, each in [0, 1].
struct Paint {
  double r{0.0};
  double g{0.0};
  double b{0.0};
  double a{1.0};
};

/// The name of F as a frame of transforms and scenes.
inline constexpr const char* kFieldFrame = "field";

void set(std::int64_t ns, google::protobuf::Timestamp& to);
void set(const Eigen::Vector3d& from, foxglove::Vector3& to);
void set(const Paint& from, foxglove::Color& to);

/// A turn about z by `yaw`; rad.
void set_yaw(double yaw, foxglove::Quaternion& to);

/// @param position  of the primitive, m
/// @param yaw       about z, rad
void set(const Eigen::Vector3d& position, double yaw, foxglove::Pose& to);

/// A new entity in frame F that lives until it is replaced, or for `lifetime` seconds.
foxglove::SceneEntity& add_entity(foxglove::SceneUpdate& scene,
                                  const std::string& id,
                                  std::int64_t log_ns,
                                  double lifetime_s);

void add_fact(foxglove::SceneEntity& entity, const char* key, const std::string& value);

/// An upright cylinder around `centre`.
void add_disc(foxglove::SceneEntity& entity,
              const Eigen::Vector3d& centre,
              const Eigen::Vector3d& size,
              const Paint& paint);

/// The flat ellipse that holds a place on the floor with 95 %.
///
/// @param cov  of `centre`, m^2; nothing is drawn where it has no finite axes
void add_ellipse(foxglove::SceneEntity& entity,
                 const Eigen::Vector2d& centre,
                 const Eigen::Matrix2d& cov,
                 const Paint& paint);

/// An arrow that covers the way of a second; nothing is drawn of less than 5 cm.
void add_arrow(foxglove::SceneEntity& entity,
               const Eigen::Vector3d& tail,
               const Eigen::Vector3d& way,
               const Paint& paint);

/// A text that faces the viewer.
void add_text(foxglove::SceneEntity& entity,
              const Eigen::Vector3d& place,
              const std::string& text,
              const Paint& paint);

}  // namespace teamsight::recording::parts
