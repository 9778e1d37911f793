// vision/calibration/ground.cpp: what a calibration is worth on the floor.
#include <cmath>
#include <numbers>

#include "geometry/expect.hpp"
#include "vision/calibration/line_calibration.hpp"
#include "vision/camera_uncertainty.hpp"

namespace teamsight::vision {

namespace {

constexpr int kDirections = 36;
constexpr double kNearest = 1.0;  // m
constexpr double kStride = 0.5;   // m

// Calls use(p_R) for places all around, from 1 m to `reach`.
template <class Use>
void over_floor(double reach, const Use& use) {
  const auto rings = static_cast<int>((reach - kNearest) / kStride + 1e-9);
  for (int ring = 0; ring <= rings; ++ring) {
    const double distance = kNearest + kStride * ring;
    for (int i = 0; i < kDirections; ++i) {
      const double azimuth = 2.0 * std::numbers::pi * i / kDirections;
      use(Point3<Robot>{distance * std::cos(azimuth), distance * std::sin(azimuth), 0.0});
    }
  }
}

}  // namespace

double ground_sigma_of(const CameraParameters& camera, double reach) {
  TEAMSIGHT_EXPECT(camera.calibration.has_value());
  const CameraUncertainty uncertainty(camera);
  double sum = 0.0;
  int count = 0;
  over_floor(reach, [&](const Point3<Robot>& p_R) {
    const auto pixel = uncertainty.model().project(p_R);
    const auto place = pixel ? uncertainty.on_plane(*pixel, 0.0, 0.0) : std::nullopt;
    if (!place) return;
    sum += place->cov_R.trace();
    ++count;
  });
  return count > 0 ? std::sqrt(sum / count) : HUGE_VAL;
}

std::optional<double> ground_difference(const CameraModel& truth,
                                        const CameraModel& other,
                                        double reach) {
  double sum = 0.0;
  int count = 0;
  over_floor(reach, [&](const Point3<Robot>& p_R) {
    const auto pixel = truth.project(p_R);
    const auto place = pixel ? other.on_plane(*pixel, 0.0) : std::nullopt;
    if (!place) return;
    sum += (place->vector() - p_R.on_floor().vector()).squaredNorm();
    ++count;
  });
  return count > 0 ? std::optional(std::sqrt(sum / count)) : std::nullopt;
}

}  // namespace teamsight::vision
