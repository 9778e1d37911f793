// tests/vision/camera_uncertainty_test.cpp: covariances against many random pixels and cameras.
#include "vision/camera_uncertainty.hpp"

#include <cmath>
#include <random>
#include <vector>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "vision/camera_knobs.hpp"

namespace teamsight::vision {
namespace {

CameraParameters profile_camera() {
  CameraParameters camera;
  camera.width_px = 640;
  camera.height_px = 480;
  camera.mirrored = true;
  ProfileMirror mirror;
  mirror.focal_x_px = mirror.focal_y_px = 480.0;
  mirror.centre_u_px = 320.0;
  mirror.centre_v_px = 240.0;
  mirror.pinhole_height = 0.63;
  for (int i = 0; i <= 60; ++i) {
    const double x = 0.0013 * i;
    mirror.profile.push_back({x, 0.131 + 0.78 * (std::hypot(0.05, x) - 0.05)});
  }
  camera.mirror = mirror;
  return camera;
}

CameraParameters table_camera() {
  CameraParameters camera;
  camera.width_px = 640;
  camera.height_px = 480;
  RadialTable table;
  table.centre_u_px = 320.0;
  table.centre_v_px = 240.0;
  table.mirror_height = 0.8;
  for (int radius = 10; radius <= 220; radius += 10) {
    table.rows.push_back({1.0 * radius, 0.8 * std::tan(0.0065 * radius), 0.5});
  }
  camera.mirror = table;
  return camera;
}

// With sigmas of a good calibration, and one correlation.
CameraParameters calibrated(CameraParameters camera) {
  CalibrationRecord record;
  const auto knobs = knobs_of(camera);
  const auto size = static_cast<Eigen::Index>(knobs.size());
  Eigen::MatrixXd cov = Eigen::MatrixXd::Zero(size, size);
  for (Eigen::Index k = 0; k < size; ++k) {
    record.knobs.push_back(knobs[static_cast<std::size_t>(k)].knob);
    cov(k, k) = std::pow(0.1 * knobs[static_cast<std::size_t>(k)].sigma, 2);
  }
  cov(0, 3) = cov(3, 0) = -0.6 * std::sqrt(cov(0, 0) * cov(3, 3));
  record.cov.assign(cov.data(), cov.data() + cov.size());
  camera.calibration = record;
  return camera;
}

/// Draws cameras from a calibration record.
class CameraDraw {
 public:
  explicit CameraDraw(const CameraParameters& camera) : camera_(camera) {
    const auto size = static_cast<Eigen::Index>(camera.calibration->knobs.size());
    const Eigen::MatrixXd cov =
        Eigen::Map<const Eigen::MatrixXd>(camera.calibration->cov.data(), size, size);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(cov);
    root_ = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
  }

  CameraModel operator()(std::mt19937& random) const {
    std::normal_distribution<double> normal;
    const Eigen::VectorXd z =
        Eigen::VectorXd::NullaryExpr(root_.cols(), [&] { return normal(random); });
    return CameraModel(*turned(camera_, camera_.calibration->knobs, root_ * z));
  }

 private:
  const CameraParameters& camera_;
  Eigen::MatrixXd root_;
};

// Both covariances as the lengths and products they mean, within the scatter of 4,000 draws.
void expect_alike(const Eigen::Matrix2d& claimed, const Eigen::Matrix2d& drawn) {
  const Eigen::Matrix2d whitened = claimed.inverse() * drawn;  // the identity where they agree
  EXPECT_NEAR(whitened(0, 0), 1.0, 0.1);
  EXPECT_NEAR(whitened(1, 1), 1.0, 0.1);
}

constexpr int kDraws = 4000;
constexpr double kSigmaPx = 0.2;

class EachKindOfMirror : public testing::TestWithParam<CameraParameters (*)()> {};

TEST_P(EachKindOfMirror, ClaimsTheScatterOfThePlaneOfTheBall) {
  const CameraParameters camera = calibrated(GetParam()());
  const CameraUncertainty uncertainty(camera);
  const CameraDraw draw(camera);
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0.0, kSigmaPx);
  const Pixel pixel{430.0, 150.0};

  const auto claimed = uncertainty.on_plane(pixel, 0.11, kSigmaPx);
  Eigen::Matrix2d drawn = Eigen::Matrix2d::Zero();
  for (int i = 0; i < kDraws; ++i) {
    const auto place =
        draw(random).on_plane({pixel.u + noise(random), pixel.v + noise(random)}, 0.11);
    const Eigen::Vector2d off = place->vector() - claimed->p_R.vector();
    drawn += off * off.transpose() / kDraws;
  }

  expect_alike(claimed->cov_R, drawn);
}

TEST_P(EachKindOfMirror, ClaimsTheScatterOfAPointInThePicture) {
  const CameraParameters camera = calibrated(GetParam()());
  const CameraUncertainty uncertainty(camera);
  const CameraDraw draw(camera);
  std::mt19937 random(8);
  std::normal_distribution<double> noise(0.0, 0.02);
  const Point3<Robot> p_R{-1.5, 0.8, 0.3};

  const auto claimed = uncertainty.project(p_R, 4e-4 * Eigen::Matrix3d::Identity());
  Eigen::Matrix2d drawn = Eigen::Matrix2d::Zero();
  for (int i = 0; i < kDraws; ++i) {
    const auto pixel =
        draw(random).project({p_R.x + noise(random), p_R.y + noise(random), p_R.z + noise(random)});
    const Eigen::Vector2d off{pixel->u - claimed->pixel.u, pixel->v - claimed->pixel.v};
    drawn += off * off.transpose() / kDraws;
  }

  expect_alike(claimed->cov_px, drawn);
}

TEST_P(EachKindOfMirror, ClaimsTheScatterOfARay) {
  const CameraParameters camera = calibrated(GetParam()());
  const CameraUncertainty uncertainty(camera);
  const CameraDraw draw(camera);
  std::mt19937 random(9);
  std::normal_distribution<double> noise(0.0, kSigmaPx);
  const Pixel pixel{250.0, 330.0};

  const auto claimed = uncertainty.ray(pixel, kSigmaPx);
  const Eigen::Vector3d& middle = claimed->ray.direction;
  const Eigen::Vector3d left = Eigen::Vector3d(-middle.y(), middle.x(), 0.0).normalized();
  const Eigen::Vector3d up = middle.cross(left);
  Eigen::Matrix2d drawn = Eigen::Matrix2d::Zero();
  for (int i = 0; i < kDraws; ++i) {
    const auto ray = draw(random).ray({pixel.u + noise(random), pixel.v + noise(random)});
    const Eigen::Vector2d off{ray->direction.dot(up), ray->direction.dot(left)};
    drawn += off * off.transpose() / kDraws;
  }

  expect_alike(claimed->cov, drawn);
}

INSTANTIATE_TEST_SUITE_P(Both, EachKindOfMirror, testing::Values(&profile_camera, &table_camera));

TEST(CameraUncertainty, KnowsOnlyThePixelWithoutACalibration) {
  const CameraUncertainty uncertainty(table_camera());

  EXPECT_EQ(uncertainty.on_plane({400.0, 200.0}, 0.0, 0.0)->cov_R.norm(), 0.0);
  EXPECT_GT(uncertainty.on_plane({400.0, 200.0}, 0.0, 0.1)->cov_R.norm(), 0.0);
}

TEST(CameraUncertainty, SaysNothingBesideTheMirror) {
  const CameraUncertainty uncertainty(calibrated(profile_camera()));

  EXPECT_FALSE(uncertainty.on_plane({639.0, 479.0}, 0.0, 0.1));
  EXPECT_FALSE(uncertainty.project({0.0, 0.0, 5.0}, Eigen::Matrix3d::Identity()));
}

TEST(CameraKnobs, RefusesATableThatNoLongerGrows) {
  const CameraParameters camera = table_camera();
  const std::vector knobs{CameraKnob::kRadial4};

  EXPECT_FALSE(turned(camera, knobs, Eigen::VectorXd::Constant(1, 0.9)));
  EXPECT_TRUE(turned(camera, knobs, Eigen::VectorXd::Constant(1, 0.001)));
}

TEST(CameraModel, TiltsTheHeadOfATableAsThatOfAMirror) {
  CameraParameters camera = table_camera();
  std::get<RadialTable>(camera.mirror).head_pitch = 0.01;
  const CameraModel level(table_camera());
  const CameraModel tilted(camera);
  // Nose down: what is ahead comes nearer by (D^2 + h^2) / h per radian.
  const Pixel ahead{320.0 + 150.0, 240.0};

  const auto before = level.on_plane(ahead, 0.0);
  const auto after = tilted.on_plane(ahead, 0.0);

  const double d = before->x;
  EXPECT_NEAR(before->x - after->x, 0.01 * (d * d + 0.64) / 0.8, 0.002);
  const auto back = tilted.project({after->x, after->y, 0.0});
  EXPECT_NEAR(back->u, ahead.u, 1e-6);
  EXPECT_NEAR(back->v, ahead.v, 1e-6);
}

}  // namespace
}  // namespace teamsight::vision
