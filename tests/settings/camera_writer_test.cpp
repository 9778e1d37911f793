// tests/settings/camera_writer_test.cpp: what a tool saves is what an agent loads.
#include <fstream>
#include <numbers>
#include <variant>

#include <gmock/gmock.h>

#include "settings/load.hpp"
#include "tests/settings/camera_text.hpp"
#include "tests/settings/temporary_files.hpp"

namespace teamsight::settings {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

vision::CameraParameters radial_camera(const TemporaryFolder& folder) {
  return load_camera(folder.write("eye.textproto", kRadialCamera));
}

vision::CameraParameters profile_camera(const TemporaryFolder& folder) {
  std::ignore = folder.write("eye.csv", kProfileCsv);
  return load_camera(folder.write("eye.textproto", kProfileCamera));
}

TEST(LoadCamera, TurnsDegreesIntoWrappedRadians) {
  const TemporaryFolder folder;

  const vision::CameraParameters camera = radial_camera(folder);

  EXPECT_NEAR(camera.forward, 90.0 * kDegree, 1e-12);
  ASSERT_EQ(camera.mask.sectors.size(), 1U);
  EXPECT_NEAR(camera.mask.sectors[0].from, -10.0 * kDegree, 1e-12);
  EXPECT_NEAR(camera.mask.sectors[0].to, 10.0 * kDegree, 1e-12);
}

TEST(LoadCamera, ReadsTheRowsAndTheirDefaults) {
  const TemporaryFolder folder;

  const auto table = std::get<vision::RadialTable>(radial_camera(folder).mirror);

  EXPECT_THAT(table.rows,
              testing::ElementsAre(vision::RingMark{100, 1, 0.5},
                                   vision::RingMark{150, 2, 1.5},
                                   vision::RingMark{180, 4, 0.5}));
}

TEST(LoadCamera, ReadsTheProfileBesideTheFile) {
  const TemporaryFolder folder;

  const auto mirror = std::get<vision::ProfileMirror>(profile_camera(folder).mirror);

  EXPECT_EQ(mirror.profile.size(), 3U);
  EXPECT_EQ(mirror.profile[1], (vision::ProfilePoint{0.02, 0.21}));
  EXPECT_NEAR(mirror.tilt_C[0], 2.0 * kDegree, 1e-12);
}

TEST(SaveCamera, KeepsARadialTable) {
  const TemporaryFolder folder;
  const vision::CameraParameters camera = radial_camera(folder);

  save_camera(folder.path() / "saved.textproto", camera, "measured\nby hand");
  vision::CameraParameters again = load_camera(folder.path() / "saved.textproto");

  EXPECT_NEAR(again.forward, camera.forward, 1e-12);
  EXPECT_NEAR(again.mask.sectors.at(0).from, camera.mask.sectors.at(0).from, 1e-12);
  EXPECT_NEAR(again.mask.sectors.at(0).to, camera.mask.sectors.at(0).to, 1e-12);
  again.forward = camera.forward;
  again.mask.sectors = camera.mask.sectors;
  EXPECT_EQ(again, camera);
}

TEST(SaveCamera, KeepsThePatternOfABall) {
  const TemporaryFolder folder;
  vision::CameraParameters camera = radial_camera(folder);
  camera.colours.pattern = {vision::ColourClass::kWhite, vision::ColourClass::kBall};

  save_camera(folder.path() / "saved.textproto", camera);

  EXPECT_EQ(load_camera(folder.path() / "saved.textproto").colours, camera.colours);
}

TEST(SaveCamera, KeepsAProfile) {
  const TemporaryFolder folder;
  const vision::CameraParameters camera = profile_camera(folder);
  const auto& before = std::get<vision::ProfileMirror>(camera.mirror);

  save_camera(folder.path() / "saved.textproto", camera);
  const vision::CameraParameters again = load_camera(folder.path() / "saved.textproto");

  const auto& after = std::get<vision::ProfileMirror>(again.mirror);
  EXPECT_EQ(after.profile, before.profile);
  EXPECT_EQ(after.pinhole_height, before.pinhole_height);
  EXPECT_NEAR(after.tilt_C[0], before.tilt_C[0], 1e-12);
  EXPECT_EQ(again.mirrored, camera.mirrored);
  EXPECT_EQ(again.mask, camera.mask);
}

TEST(SaveCamera, KeepsHowWellTheCameraIsKnown) {
  const TemporaryFolder folder;
  vision::CameraParameters camera = profile_camera(folder);
  vision::CalibrationRecord record;
  record.knobs = {vision::CameraKnob::kCentreU, vision::CameraKnob::kTiltX};
  record.cov = {0.04, -1e-4, -1e-4, 1e-6};
  record.residual_px = 0.25;
  record.views = 12;
  camera.calibration = record;

  save_camera(folder.path() / "saved.textproto", camera);
  const auto again = load_camera(folder.path() / "saved.textproto").calibration;

  ASSERT_TRUE(again);
  EXPECT_EQ(again->knobs, record.knobs);
  EXPECT_THAT(again->cov, testing::Pointwise(testing::DoubleNear(1e-15), record.cov));
  EXPECT_EQ(again->residual_px, 0.25);
  EXPECT_EQ(again->views, 12U);
}

TEST(SaveCamera, KeepsTheTiltOfATablesHead) {
  const TemporaryFolder folder;
  vision::CameraParameters camera = radial_camera(folder);
  std::get<vision::RadialTable>(camera.mirror).head_roll = 0.01;

  save_camera(folder.path() / "saved.textproto", camera);
  const auto again = load_camera(folder.path() / "saved.textproto");

  EXPECT_NEAR(std::get<vision::RadialTable>(again.mirror).head_roll, 0.01, 1e-12);
}

TEST(SaveCamera, WritesTheCommentAndLeavesNoDraft) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "saved.textproto";
  const vision::CameraParameters camera = radial_camera(folder);

  save_camera(path, camera, "measured\nby hand");

  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_THAT(text, testing::HasSubstr("\n# measured\n# by hand\n"));
  const auto files = std::distance(std::filesystem::directory_iterator(folder.path()), {});
  EXPECT_EQ(files, 2);  // what radial_camera wrote, and the saved one
}

TEST(SaveCamera, SaysThatAPlaceCannotBeWritten) {
  const std::string complaint =
      complaint_of([] { save_camera("/nowhere/eye.textproto", vision::CameraParameters{}); });

  EXPECT_THAT(complaint, testing::StartsWith("/nowhere/eye.textproto:1:1: found a place that"));
}

TEST(SaveCamera, KeepsTheColourCube) {
  const TemporaryFolder folder;
  vision::CameraParameters camera = radial_camera(folder);
  vision::CubeParameters cube;
  cube.planes = {{{1.0, -0.25, 0.0, 30.5}, {0.0, 1.0, 0.0, 90.0}, {0.0, -0.5, 1.0, 20.0}}};
  cube.classes = {vision::ColourClass::kBlack,
                  vision::ColourClass::kRed,
                  vision::ColourClass::kGreen,
                  vision::ColourClass::kBall,
                  vision::ColourClass::kBlue,
                  vision::ColourClass::kMagenta,
                  vision::ColourClass::kNone,
                  vision::ColourClass::kWhite};
  camera.colours.cube = cube;
  camera.colours.method = vision::ColourMethod::kCube;

  save_camera(folder.path() / "saved.textproto", camera);
  const vision::CameraParameters again = load_camera(folder.path() / "saved.textproto");

  EXPECT_EQ(again.colours, camera.colours);
}

TEST(SaveCamera, KeepsTheLightAndTheTrainedClasses) {
  const TemporaryFolder folder;
  vision::CameraParameters camera = radial_camera(folder);
  camera.colours.light = vision::FieldColours{{87, 101, 94}, {200, 127, 129}};
  camera.colours.table.assign(vision::kClassCells, vision::ColourClass::kNone);
  camera.colours.table[vision::class_cell({87, 101, 94})] = vision::ColourClass::kGreen;
  camera.colours.table.back() = vision::ColourClass::kBlack;

  save_camera(folder.path() / "saved.textproto", camera);
  const vision::CameraParameters again = load_camera(folder.path() / "saved.textproto");

  EXPECT_EQ(again.colours, camera.colours);
}

}  // namespace
}  // namespace teamsight::settings
