// agent/translate.cpp: see translate.hpp.
#include "agent/translate.hpp"

#include <algorithm>
#include <cmath>

namespace teamsight::agent {
namespace {

constexpr std::size_t kMaxLinePointsSent = 200;
constexpr double kFarthestLinePoint = 32.0;  // m, what the topic can say

bus::Light light_of(vision::Light light) {
  switch (light) {
    case vision::Light::kUnknown:
      return bus::Light::kUnknown;
    case vision::Light::kGood:
      return bus::Light::kGood;
    case vision::Light::kDark:
      return bus::Light::kDark;
    case vision::Light::kGlare:
      return bus::Light::kGlare;
    case vision::Light::kCovered:
      return bus::Light::kCovered;
  }
  return bus::Light::kUnknown;
}

bool is_sendable(const vision::LinePoint& point) {
  return std::abs(point.p_R.x) < kFarthestLinePoint && std::abs(point.p_R.y) < kFarthestLinePoint;
}

}  // namespace

bus::Sightings sightings_of(const vision::FrameObservation& seen, const Stamps& stamps) {
  bus::Sightings message;
  message.id = stamps.id;
  message.exposure = stamp_of(stamps.exposure);
  message.published = stamp_of(stamps.published);
  message.posture = seen.posture;
  message.light = light_of(seen.light);
  message.balls.assign(
      seen.balls.begin(),
      seen.balls.begin() + static_cast<std::ptrdiff_t>(std::min(seen.balls.size(), kMaxBallRays)));
  message.obstacles.assign(
      seen.obstacles.begin(),
      seen.obstacles.begin() +
          static_cast<std::ptrdiff_t>(std::min(seen.obstacles.size(), kMaxObstacleSightings)));
  return message;
}

bus::VirtualSensors sensors_of(const vision::FrameObservation& seen, const Stamps& stamps) {
  bus::VirtualSensors message;
  message.id = stamps.id;
  message.exposure = stamp_of(stamps.exposure);
  for (const vision::SensorValue& sensor : seen.sensors) {
    message.readings.push_back({sensor.name, sensor.value, sensor.triggered});
  }
  return message;
}

bus::LinePoints line_points_of(const vision::FrameObservation& seen, const Stamps& stamps) {
  bus::LinePoints message;
  message.id = stamps.id;
  message.exposure = stamp_of(stamps.exposure);
  const std::size_t step = std::max<std::size_t>(
      1, (seen.line_points.size() + kMaxLinePointsSent - 1) / kMaxLinePointsSent);
  for (std::size_t i = 0; i < seen.line_points.size(); i += step) {
    const vision::LinePoint& point = seen.line_points[i];
    if (is_sendable(point)) {
      const bool is_inlier = i < seen.line_fits.size() && seen.line_fits[i];
      message.points.push_back({point.p_R, is_inlier});
    }
  }
  return message;
}

bool sees_ball(const vision::FrameObservation& seen) {
  return std::any_of(seen.balls.begin(), seen.balls.end(), [](const BallRay& ball) {
    return ball.confidence > 0.5;
  });
}

}  // namespace teamsight::agent
