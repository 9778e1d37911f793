// tests/vision/calibration/line_drift_test.cpp: false alarms of a good camera, and bumped mirrors.
#include "vision/line_drift.hpp"

#include <algorithm>
#include <iostream>
#include <random>

#include <gtest/gtest.h>

#include "tests/vision/calibration/bent_camera.hpp"
#include "tests/vision/synthetic_points.hpp"
#include "vision/posture.hpp"

namespace teamsight::vision {
namespace {

/// A camera whose picture may be shifted and scaled against what the agent believes.
class DriftingRobot {
 public:
  DriftingRobot()
      : camera_(drawn_camera()),
        model_(camera_),
        rays_(model_, camera_.width_px, camera_.height_px),
        field_(test_field()),
        estimator_(field_) {}

  // Line points as the agent believes them when the real picture is moved by `shift` (right, up;
  // px) and larger by `size` px.
  std::vector<LinePoint> points_at(const Pose<Field, Robot>& X_FR,
                                   const Eigen::Vector3d& drift,
                                   std::mt19937& random) {
    const double kNoise = 0.3;  // px
    std::normal_distribution<double> noise(0.0, kNoise);
    std::vector<LinePoint> points;
    for (const LinePoint& ideal : line_points_from(field_, X_FR, 1e-4, 0.02, random)) {
      auto pixel = model_.project({ideal.p_R.x, ideal.p_R.y, 0.0});
      if (!pixel || ideal.p_R.vector().norm() < 0.5) continue;
      const Eigen::Vector2d out =
          Eigen::Vector2d(pixel->u - model_.centre().u, pixel->v - model_.centre().v).normalized();
      pixel->u += noise(random) + drift.y() + drift.x() * out.x();
      pixel->v += noise(random) - drift.z() + drift.x() * out.y();
      const auto floor = model_.on_plane(*pixel, 0.0);
      const auto per_px = model_.floor_jacobian(*pixel);
      if (!floor || !per_px) continue;
      points.push_back(
          {pixel->u, pixel->v, *floor, kNoise * kNoise * *per_px * per_px->transpose()});
    }
    return points;
  }

  // One frame at a random place.
  void see(DriftWatch& watch, const Eigen::Vector3d& drift, std::mt19937& random) {
    const Pose<Field, Robot> X_FR = random_pose(field_, random);
    const auto points = points_at(X_FR, drift, random);
    if (points.empty()) return;
    MotionPrior prior;
    prior.X_FR = X_FR;
    prior.cov = 0.04 * Eigen::Matrix3d::Identity();
    prior.half_log_odds = kMaxHalfLogOdds;
    const PostureResult found = estimator_.estimate(points, prior);
    if (found.estimate.status == PostureStatus::kLost) return;
    std::vector<bool> fits;
    for (const LinePoint& point : points) {
      fits.push_back(
          is_inlier(line_residual(estimator_.map(), found.estimate.X_FR, point), found.scale));
    }
    watch.take(drift_evidence(points,
                              fits,
                              estimator_.map(),
                              found.estimate.X_FR,
                              {&rays_, model_.centre(), camera_.mirrored}),
               found.estimate.X_FR);
  }

 private:
  CameraParameters camera_;
  CameraModel model_;
  RayTable rays_;
  FieldModel field_;
  PostureEstimator estimator_;
};

TEST(DriftWatch, RaisesNoAlarmWithAGoodCamera) {
  DriftingRobot robot;
  std::mt19937 random(11);
  int alarms = 0;
  double largest = 0.0;
  for (int drive = 0; drive < 10; ++drive) {
    DriftWatch watch;
    for (int frame = 0; frame < 60; ++frame) {
      robot.see(watch, Eigen::Vector3d::Zero(), random);
      if (frame > 15) largest = std::max(largest, watch.report().drift_px);
      if (watch.report().alarm) ++alarms;
    }
  }

  std::cout << "alarms in 600 frames: " << alarms << ", largest drift " << largest << " px\n";
  EXPECT_EQ(alarms, 0);
  EXPECT_LT(largest, 0.5);
}

TEST(DriftWatch, SaysHowFarAndWhereToAMirrorWasBumped) {
  DriftingRobot robot;
  std::mt19937 random(12);
  DriftWatch watch;
  int frames = 0;
  while (!watch.report().alarm && frames < 60) {
    robot.see(watch, {0.0, 2.0, -1.5}, random);
    ++frames;
  }

  std::cout << "alarm after " << frames << " frames: shift " << watch.report().shift_px.transpose()
            << " px, size " << watch.report().size_px << " px\n";
  ASSERT_TRUE(watch.report().alarm);
  EXPECT_LT(frames, 40);
  EXPECT_NEAR(watch.report().shift_px.x(), 2.0, 0.4);
  EXPECT_NEAR(watch.report().shift_px.y(), -1.5, 0.4);
  EXPECT_NEAR(watch.report().size_px, 0.0, 0.4);
}

TEST(DriftWatch, SeesAPictureThatIsTooLarge) {
  DriftingRobot robot;
  std::mt19937 random(13);
  DriftWatch watch;
  int frames = 0;
  while (!watch.report().alarm && frames < 60) {
    robot.see(watch, {2.0, 0.0, 0.0}, random);
    ++frames;
  }

  std::cout << "alarm after " << frames << " frames: size " << watch.report().size_px
            << " px, drift " << watch.report().drift_px << " px\n";
  EXPECT_TRUE(watch.report().alarm);
  EXPECT_NEAR(watch.report().size_px, 2.0, 0.5);
}

// A frame that knows these informations of (too large, right, up) and sees `drift`.
DriftEvidence frame_that_knows(const Eigen::Vector3d& info, const Eigen::Vector3d& drift) {
  DriftEvidence evidence;
  evidence.info = info.asDiagonal();
  evidence.vector = info.cwiseProduct(drift);
  evidence.points = 100;
  return evidence;
}

const Eigen::Vector3d kAll{100.0, 100.0, 100.0};   // 0.1 px each
const Eigen::Vector3d kNothing{0.01, 0.01, 0.01};  // 10 px each
const Eigen::Vector3d kSizeOnly{100.0, 0.01, 0.01};
const Eigen::Vector3d kTooLarge{3.0, 0.0, 0.0};

TEST(DriftWatch, LearnsNothingWhileTheRobotStands) {
  DriftWatch watch;

  for (int i = 0; i < 1000; ++i) watch.take(frame_that_knows(kAll, kTooLarge), {1.0, 2.0, 0.3});

  EXPECT_FALSE(watch.report().alarm);
}

TEST(DriftWatch, TakesAGoodFrameBesideOneThatToldNothing) {
  DriftWatch watch;
  for (int i = 0; i < 20; ++i) {
    const Pose<Field, Robot> X_FR(0.3 * i, 0.0, 0.0);
    watch.take(frame_that_knows(kNothing, kTooLarge), X_FR);
    watch.take(frame_that_knows(kAll, kTooLarge), X_FR);
  }

  EXPECT_TRUE(watch.report().alarm);
  EXPECT_NEAR(watch.report().drift_px, 3.0, 0.01);
}

TEST(DriftWatch, KeepsWhatItKnowsWhileFramesTellNothing) {
  DriftWatch watch;
  for (int i = 0; i < 20; ++i) watch.take(frame_that_knows(kAll, kTooLarge), {0.3 * i, 0.0, 0.0});
  const DriftReport before = watch.report();

  for (int i = 0; i < 500; ++i) {
    watch.take(frame_that_knows(kNothing, Eigen::Vector3d::Zero()), {0.3 * i, 1.0, 0.0});
  }

  EXPECT_TRUE(watch.report().alarm);
  EXPECT_DOUBLE_EQ(watch.report().drift_px, before.drift_px);
}

TEST(DriftWatch, CountsAFrameByWhatItKnows) {
  DriftWatch watch;
  // Three whole frames, and others that know one unknown of three; old ones fade.
  int looks = 0;
  const auto see = [&](const Eigen::Vector3d& info) {
    watch.take(frame_that_knows(info, kTooLarge), {0.3 * looks++, 0.0, 0.0});
  };
  for (int i = 0; i < 3; ++i) see(kAll);

  for (int i = 0; i < 20; ++i) see(kSizeOnly);
  EXPECT_FALSE(watch.report().alarm);

  for (int i = 0; i < 25; ++i) see(kSizeOnly);
  EXPECT_TRUE(watch.report().alarm);
}

}  // namespace
}  // namespace teamsight::vision
