// tests/vision/camera_model_test.cpp: rays against closed forms, and there and back.
#include "vision/camera_model.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "vision/ray_table.hpp"

namespace teamsight::vision {
namespace {

constexpr double kPi = std::numbers::pi;

CameraParameters radial_camera(bool mirrored) {
  CameraParameters camera;
  camera.width_px = 320;
  camera.height_px = 240;
  camera.forward = 0.5 * kPi;
  camera.mirrored = mirrored;
  RadialTable table;
  table.centre_u_px = 160.0;
  table.centre_v_px = 120.0;
  table.mirror_height = 0.8;
  for (int radius = 10; radius <= 110; radius += 10) {
    table.rows.push_back({1.0 * radius, 0.7 * std::tan(0.0125 * radius), 0.5});
  }
  camera.mirror = table;
  return camera;
}

CameraParameters profile_camera(double slope) {
  CameraParameters camera;
  camera.width_px = 320;
  camera.height_px = 240;
  camera.forward = 0.0;
  camera.mirrored = true;
  ProfileMirror mirror;
  mirror.focal_x_px = mirror.focal_y_px = 400.0;
  mirror.centre_u_px = 160.0;
  mirror.centre_v_px = 120.0;
  mirror.pinhole_height = 0.5;
  for (int i = 0; i <= 12; ++i) mirror.profile.push_back({0.005 * i, 0.2 + slope * 0.005 * i});
  camera.mirror = mirror;
  return camera;
}

TEST(CameraModel, PutsForwardUpAndLeftOnTheRightOfAMirroredPicture) {
  const CameraModel model(radial_camera(true));

  const auto ahead = model.on_plane({160.0, 60.0}, 0.0);
  const auto right_of_picture = model.on_plane({220.0, 120.0}, 0.0);

  ASSERT_TRUE(ahead && right_of_picture);
  EXPECT_NEAR(ahead->y, 0.0, 1e-9);
  EXPECT_GT(ahead->x, 0.3);
  EXPECT_NEAR(right_of_picture->x, 0.0, 1e-9);
  EXPECT_GT(right_of_picture->y, 0.3);
}

TEST(CameraModel, SeesTheRingsWhereTheyWereMeasured) {
  const CameraModel model(radial_camera(false));

  const auto floor = model.on_plane({160.0 + 60.0, 120.0}, 0.0);

  ASSERT_TRUE(floor);
  EXPECT_NEAR(std::hypot(floor->x, floor->y), 0.7 * std::tan(0.75), 1e-9);
}

TEST(CameraModel, SeesNothingOutsideTheTable) {
  const CameraModel model(radial_camera(true));

  EXPECT_FALSE(model.ray({165.0, 120.0}));
  EXPECT_FALSE(model.ray({160.0 + 115.0, 120.0}));
}

TEST(CameraModel, ProjectsWhatItsRaysHit) {
  for (const bool mirrored : {false, true}) {
    const CameraModel model(radial_camera(mirrored));
    for (const Pixel pixel : {Pixel{200.3, 90.7}, Pixel{100.0, 150.0}, Pixel{160.0, 25.0}}) {
      const auto ray = model.ray(pixel);
      ASSERT_TRUE(ray);
      const Eigen::Vector3d p = ray->origin.vector() + 0.9 * ray->direction;

      const auto back = model.project(Point3<Robot>::from(p));

      ASSERT_TRUE(back);
      EXPECT_NEAR(back->u, pixel.u, 1e-6);
      EXPECT_NEAR(back->v, pixel.v, 1e-6);
    }
  }
}

TEST(CameraModel, ReflectsLikeAPlaneMirror) {
  // A level mirror 0.2 m above the pinhole shows the pinhole's mirror image at 0.5 + 0.4 m.
  const CameraModel model(profile_camera(0.0));

  const auto floor = model.on_plane({160.0 + 80.0, 120.0}, 0.0);

  ASSERT_TRUE(floor);
  EXPECT_NEAR(floor->x, 0.9 * 80.0 / 400.0, 1e-9);
  EXPECT_NEAR(floor->y, 0.0, 1e-9);
}

TEST(CameraModel, ReflectsLikeACone) {
  // Law of reflection in the meridian: from straight down, psi = alpha + 2 gamma.
  constexpr double kSlope = 0.5;
  const CameraModel model(profile_camera(kSlope));
  const double tan_alpha = 60.0 / 400.0;
  const double y = 0.2 / (1.0 - kSlope * tan_alpha);
  const double psi = std::atan(tan_alpha) + 2.0 * std::atan(kSlope);

  const auto floor = model.on_plane({160.0, 120.0 + 60.0}, 0.0);

  // The bottom of a mirrored picture is C's y axis: the robot's left when image right is forward.
  ASSERT_TRUE(floor);
  EXPECT_NEAR(floor->x, 0.0, 1e-9);
  EXPECT_NEAR(floor->y, y * tan_alpha + (y + 0.5) * std::tan(psi), 1e-6);
}

TEST(CameraModel, ReflectsLikeConeAndPlaneRightBesideTheKinkBetweenThem) {
  constexpr double kSlope = 0.5;
  CameraParameters camera = profile_camera(kSlope);
  auto& mirror = std::get<ProfileMirror>(camera.mirror);
  // A cone up to 20 mm from the axis, then a flat ring.
  mirror.profile.clear();
  for (int i = 0; i <= 20; ++i) mirror.profile.push_back({1e-3 * i, 0.19 + kSlope * 1e-3 * i});
  for (int i = 0; i <= 20; ++i) mirror.profile.push_back({0.02 + 1e-9 + 1e-3 * i, 0.2});
  const CameraModel model(camera);
  const double tan_alpha = 39.0 / 400.0;
  const double y = 0.19 / (1.0 - kSlope * tan_alpha);
  const double psi = std::atan(tan_alpha) + 2.0 * std::atan(kSlope);

  const auto by_cone = model.on_plane({160.0 + 39.0, 120.0}, 0.0);  // 0.5 mm before the kink
  const auto by_ring = model.on_plane({160.0 + 41.0, 120.0}, 0.0);  // 0.5 mm beyond

  ASSERT_TRUE(by_cone && by_ring);
  EXPECT_NEAR(by_cone->x, y * tan_alpha + (y + 0.5) * std::tan(psi), 1e-6);
  EXPECT_NEAR(by_ring->x, 0.9 * 41.0 / 400.0, 1e-6);
}

TEST(CameraModel, ProjectsThroughATiltedAndShiftedMirror) {
  CameraParameters camera = profile_camera(0.5);
  auto& mirror = std::get<ProfileMirror>(camera.mirror);
  // Rounded, so that its rays rise outwards as any real mirror's do.
  for (ProfilePoint& p : mirror.profile) p.y += 2.0 * p.x * p.x;
  mirror.offset_C = {0.001, -0.002, 0.001};
  mirror.tilt_C = {0.01, -0.005};
  mirror.head_roll = 0.01;
  const CameraModel model(camera);
  const Pixel pixel{200.0, 150.0};
  const auto ray = model.ray(pixel);
  ASSERT_TRUE(ray);

  const auto back = model.project(Point3<Robot>::from(ray->origin.vector() + 0.4 * ray->direction));

  ASSERT_TRUE(back);
  EXPECT_NEAR(back->u, pixel.u, 1e-4);
  EXPECT_NEAR(back->v, pixel.v, 1e-4);
}

TEST(RayTable, FootprintsAreTheSlopesOfTheRadialTable) {
  const CameraParameters camera = radial_camera(true);
  const CameraModel model(camera);
  const RayTable rays(model, camera.width_px, camera.height_px);

  const PixelRay& ray = rays.at(160 + 60, 120);

  const double distance = 0.7 * std::tan(0.75);
  EXPECT_NEAR(static_cast<double>(ray.tangential_footprint), distance / 60.0, 2e-4);
  EXPECT_NEAR(
      static_cast<double>(ray.radial_footprint), 0.7 * 0.0125 / std::pow(std::cos(0.75), 2), 4e-4);
  EXPECT_FALSE(rays.at(160, 120).sees_something());
  EXPECT_FALSE(rays.at(160, 120).sees_floor());
}

TEST(MonotoneCurve, GrowsBetweenItsKnotsAndInverts) {
  const MonotoneCurve curve({{0.0, 0.0}, {1.0, 0.1}, {2.0, 3.0}, {5.0, 3.1}});

  double last = -1.0;
  for (int i = 0; i <= 500; ++i) {
    const double x = 0.01 * i;
    EXPECT_GT(curve.at(x), last);
    last = curve.at(x);
    EXPECT_NEAR(curve.inverse(curve.at(x)), x, 1e-6);
    const double numeric = (curve.at(x + 1e-6) - curve.at(x - 1e-6)) / 2e-6;
    if (x > 0.01 && x < 4.99) {
      EXPECT_NEAR(curve.slope_at(x), numeric, 1e-4);
    }
  }
}

}  // namespace
}  // namespace teamsight::vision
