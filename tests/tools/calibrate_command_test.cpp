// tests/tools/calibrate_command_test.cpp: `teamsight calibrate` as another program sees it.
#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "settings/load.hpp"
#include "tests/support/process.hpp"
#include "tests/vision/calibration/bent_camera.hpp"

namespace teamsight::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

struct Outcome {
  int exit_code{-1};
  std::string out;
  std::string err;
};

Outcome run(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {program("teamsight").string(), "calibrate"});
  ChildProcess child(arguments);
  const auto code = child.wait_exit(std::chrono::seconds(50));
  return {code.value_or(-1), child.out(), child.err()};
}

std::string config(const std::string& name) {
  return source_path("config/" + name + ".textproto").string();
}

void expect_bad_input(const Outcome& outcome, const std::string& text) {
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, HasSubstr(text));
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

/// A bent robot's line pixels as lists, and the camera file it started with.
class BentRobot {
 public:
  explicit BentRobot(int views) {
    std::mt19937 random(42);
    const vision::BentCamera camera(vision::random_defects(random));
    const FieldModel field = settings::load_field(config("fields/nubot-18x8"));
    vision::CameraParameters drawn = vision::drawn_camera();
    drawn.name = "drawn";
    drawn.scan.max_distance = 7.0;
    settings::save_camera(base(), drawn);
    for (int i = 0; i < views; ++i) {
      std::uniform_real_distribution<double> share(-0.45, 0.45);
      const Pose<Field, Robot> X_FR(
          share(random) * field.length, share(random) * field.width, 6.0 * share(random));
      std::string text;
      for (const vision::Pixel& pixel : vision::see_lines(camera, field, X_FR, {}, random)) {
        text += std::to_string(pixel.u) + " " + std::to_string(pixel.v) + "\n";
      }
      lists_.push_back(folder_.write("view" + std::to_string(i) + ".txt", text));
    }
  }

  [[nodiscard]] fs::path path(const std::string& name) const { return folder_.path() / name; }

  [[nodiscard]] fs::path base() const { return path("drawn.textproto"); }

  [[nodiscard]] Outcome calibrate(std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{"lines",
                                       "--base",
                                       base(),
                                       "--field",
                                       config("fields/nubot-18x8"),
                                       "--out",
                                       path("out/camera.textproto")};
    fs::create_directories(path("out"));
    arguments.insert(arguments.end(), more.begin(), more.end());
    arguments.insert(arguments.end(), lists_.begin(), lists_.end());
    return run(arguments);
  }

 private:
  TempDirectory folder_;
  std::vector<std::string> lists_;
};

TEST(CalibrateLines, WritesACameraFileThatKnowsHowWellItIsKnown) {
  const BentRobot robot(8);

  const Outcome outcome = robot.calibrate({"--report", robot.path("report")});

  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string last = outcome.out.substr(outcome.out.rfind('\n', outcome.out.size() - 2) + 1);
  const json summary = json::parse(last);
  EXPECT_EQ(summary["views_used"], 8);
  EXPECT_GT(summary["before"]["median_m"], 2.0 * summary["after"]["median_m"].get<double>());
  const auto camera = settings::load_camera(robot.path("out/camera.textproto"));
  ASSERT_TRUE(camera.calibration);
  EXPECT_EQ(camera.calibration->views, 8U);
  EXPECT_TRUE(fs::exists(robot.path("report/residuals.svg")));
}

TEST(CalibrateLines, WritesNothingWhenTheViewsDoNotDetermineTheCamera) {
  const BentRobot robot(1);

  const Outcome outcome = robot.calibrate({"--max-ground-sigma-m", "0.002"});

  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("the views do not determine the camera"));
  EXPECT_TRUE(fs::is_empty(robot.path("out")));
}

TEST(CalibrateLines, NamesTheLineOfAListThatIsNoPixel) {
  const TempDirectory folder;
  const fs::path list = folder.write("a.txt", "100 200\n700 20\n");

  expect_bad_input(
      run({"lines",
           "--base",
           config("cameras/sim-640"),
           "--field",
           config("fields/msl-2024"),
           list}),
      "a.txt:2: found \"700 20\", expected the column and row of a pixel in the image");
}

TEST(CalibrateLines, RefusesAFieldWithoutLines) {
  const TempDirectory folder;
  const fs::path field =
      folder.write("f.textproto", "name: \"f\" length_m: 9 width_m: 6 line_width_m: 0.1");

  expect_bad_input(run({"lines", "--base", config("cameras/sim-640"), "--field", field, "a.raw"}),
                   "found neither lines nor arcs");
}

TEST(CalibrateLines, RefusesAnImageOfAnotherSizeAndWritesNothing) {
  const TempDirectory folder;
  const fs::path image = folder.write("a.raw", std::string(1000, 'x'));
  const fs::path out = folder.path() / "out";
  const fs::path report = folder.path() / "report";

  expect_bad_input(run({"lines",
                        "--base",
                        config("cameras/sim-640"),
                        "--field",
                        config("fields/msl-2024"),
                        "--out",
                        out,
                        "--report",
                        report,
                        image}),
                   "a.raw: found 1000 bytes, expected 614400");
  EXPECT_FALSE(fs::exists(out));
  EXPECT_FALSE(fs::exists(report));
}

Outcome calibrate_from(const std::string& picture, const std::string& name) {
  const TempDirectory folder;
  const fs::path out = folder.path() / "out";
  Outcome outcome = run({"lines",
                         "--base",
                         config("cameras/sim-640"),
                         "--field",
                         config("fields/msl-2024"),
                         "--out",
                         out,
                         folder.write(name, picture)});
  EXPECT_FALSE(fs::exists(out));
  return outcome;
}

TEST(CalibrateLines, SaysInOneLineThatAPictureIsCutShort) {
  std::ifstream file(source_path("docs/pictures/station.png"), std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(file), {}};

  expect_bad_input(calibrate_from(whole.substr(0, whole.size() / 2), "a.png"),
                   "bytes of a picture that is cut short; copy it again");
}

TEST(CalibrateLines, TellsTheEndOfAPictureFromThatOfItsThumbnailAndFromWhatFollows) {
  const std::string thumbnail = "\xFF\xD8\xFF\xDA\xFF\xD9";
  const std::string header = std::string("\xFF\xE1\x00\x08", 4) + thumbnail;
  const std::string cut = "\xFF\xD8" + header + std::string("\xFF\xDA\x00\x02scan", 8);

  expect_bad_input(calibrate_from(cut, "a.jpg"), "picture that is cut short");
  EXPECT_THAT(calibrate_from(cut + "\xFF\xD9" + std::string(5000, 'x'), "a.jpg").err,
              testing::Not(HasSubstr("cut short")));
}

TEST(CalibrateRings, RefusesRingsOutOfOrderOrTooFewOfThem) {
  for (const std::string distances : {"1,3,2", "1,2,2", "0,1,2", "1,2"}) {
    expect_bad_input(
        run({"rings", "--base", config("cameras/kassel-nase"), "--distances", distances, "a.png"}),
        "--distances: found \"" + distances + "\", expected three or more growing distances");
  }
}

TEST(CalibrateColours, RefusesAnUnknownClass) {
  expect_bad_input(run({"colours",
                        "--base",
                        config("cameras/sim-640"),
                        "--image",
                        "a.raw",
                        "--sample",
                        "PURPLE:3,4"}),
                   "found class \"PURPLE\"");
}

TEST(CalibrateMask, SaysThatTenFramesAreNeeded) {
  const TempDirectory folder;
  const fs::path image = folder.write("a.raw", std::string(std::size_t{640} * 480 * 2, '\x50'));

  const Outcome outcome = run({"mask", "--base", config("cameras/sim-640"), image});

  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("fewer than ten frames"));
}

}  // namespace
}  // namespace teamsight::test
