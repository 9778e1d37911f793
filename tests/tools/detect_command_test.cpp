// tests/tools/detect_command_test.cpp: `teamsight detect` over a folder of images, as scripts see
// it.
#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "settings/load.hpp"
#include "tests/support/process.hpp"
#include "tools/image_file.hpp"

namespace teamsight::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

struct Outcome {
  int exit_code{-1};
  std::string out;
  std::string err;
};

std::string camera_path() {
  return source_path("config/cameras/sim-640.textproto").string();
}

Outcome detect(std::vector<std::string> more) {
  std::vector<std::string> arguments{
      program("teamsight").string(), "detect", "--camera", camera_path()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  ChildProcess child(arguments);
  const auto code = child.wait_exit(std::chrono::seconds(30));
  return {code.value_or(-1), child.out(), child.err()};
}

/// A YUYV dump of the camera that shows one colour.
std::string plain_dump(const vision::CameraParameters& camera, char y, char u, char v) {
  std::string bytes;
  for (std::uint32_t pair = 0; pair < camera.width_px * camera.height_px / 2; ++pair) {
    bytes += {y, u, y, v};
  }
  return bytes;
}

TEST(DetectCommand, LooksAtAFolderOfImagesAndDrawsThemOnOneSheet) {
  const vision::CameraParameters camera = settings::load_camera(camera_path());
  const TempDirectory folder;
  fs::create_directory(folder.path() / "images");
  (void)folder.write("images/b.raw", plain_dump(camera, 90, 100, 100));
  (void)folder.write("images/a.raw", plain_dump(camera, 10, char(128), char(128)));
  (void)folder.write("images/notes.txt", "not an image");

  const Outcome outcome = detect({"--sheet",
                                  folder.path() / "sheets",
                                  "--draw",
                                  folder.path() / "drawn",
                                  "--classes",
                                  folder.path() / "classes",
                                  folder.path() / "images"});

  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 2);
  const auto first = nlohmann::json::parse(outcome.out.substr(0, outcome.out.find('\n')));
  EXPECT_THAT(first.at("image").get<std::string>(), HasSubstr("a.raw"));
  EXPECT_TRUE(fs::exists(folder.path() / "sheets/sheet-1.png"));
  EXPECT_FALSE(fs::exists(folder.path() / "sheets/sheet-2.png"));
  EXPECT_TRUE(fs::exists(folder.path() / "drawn/a-classes.png"));
  vision::CameraParameters both = camera;
  both.width_px *= 2;
  const auto classes = tools::read_image(folder.path() / "classes/b-classes.png", both);
  const std::size_t green = std::size_t{3} * (both.width_px - 10);  // of the first row
  EXPECT_EQ(classes.bytes[green], 0);
  EXPECT_EQ(classes.bytes[green + 1], 150);
  EXPECT_EQ(classes.bytes[green + 2], 0);
}

TEST(DetectCommand, RefusesAFolderWithoutImages) {
  const TempDirectory folder;

  const Outcome outcome = detect({folder.path()});

  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr("found a folder without images"));
}

}  // namespace
}  // namespace teamsight::test
