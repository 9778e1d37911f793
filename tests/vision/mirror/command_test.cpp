// tests/vision/mirror/command_test.cpp: `teamsight mirror` as another program sees it.
#include <chrono>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/support/process.hpp"

namespace teamsight::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

struct Outcome {
  int exit_code{-1};
  std::string out;
  std::string err;
};

Outcome run(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {program("teamsight").string(), "mirror"});
  ChildProcess child(arguments);
  const auto code = child.wait_exit(std::chrono::seconds(30));
  return {code.value_or(-1), child.out(), child.err()};
}

std::string config(const std::string& name) {
  return source_path("config/mirrors/" + name + ".textproto").string();
}

std::set<std::string> files_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

json read_json(const fs::path& path) {
  std::ifstream file(path);
  return json::parse(file);
}

void expect_one_line(const std::string& text) {
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
}

TEST(MirrorDesign, WritesProfileReportAndDrawings) {
  const TempDirectory place;

  const Outcome outcome =
      run({"design", "--config", config("multi_part"), "--out", place.path() / "m"});

  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(
      files_in(place.path() / "m"),
      ElementsAre(
          "ground_distance.svg", "pixel_error.svg", "profile.csv", "profile.svg", "report.json"));
  const json report = read_json(place.path() / "m" / "report.json");
  EXPECT_NEAR(report["points"]["A"]["x_m"], 0.0581649375, 1e-10);
  EXPECT_NEAR(report["points"]["C"]["image_radius_px"], 512.0, 1e-9);
  EXPECT_NEAR(report["isometric"]["mm_per_px"], 17.414, 1e-3);
  EXPECT_NEAR(report["arc"]["radius_m"], 0.348306217, 1e-8);
  EXPECT_NEAR(report["ray_of_B"]["height_m"], 0.6, 1e-9);
  EXPECT_NEAR(report["blind_zone_m"], 0.39, 1e-9);
  EXPECT_NEAR(report["lens_mm"], 4.68, 0.01);
  EXPECT_NEAR(report["integration"]["profile_difference_m"], 52.4e-6, 1e-6);
  EXPECT_TRUE(json::accept(outcome.out));
  expect_one_line(outcome.out);
}

TEST(MirrorDesign, DrawsSeveralMirrorsSideBySide) {
  const TempDirectory place;

  const Outcome outcome = run({"design",
                               "--config",
                               config("cone"),
                               "--config",
                               config("sphere"),
                               "--out",
                               place.path() / "m"});

  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(
      files_in(place.path() / "m"),
      ElementsAre("cone", "ground_distance.svg", "pixel_error.svg", "profile.svg", "sphere"));
  EXPECT_THAT(files_in(place.path() / "m" / "cone"), ElementsAre("profile.csv", "report.json"));
  EXPECT_TRUE(read_json(place.path() / "m" / "sphere" / "report.json")["points"].is_null());
}

TEST(MirrorDesign, ThatDoesNotCloseSaysWhyAndWritesNothing) {
  const TempDirectory place;
  const auto hidden = place.write(
      "hidden.textproto", "name: \"h\" multi_part {} body { height_m: 0.4 radius_m: 0.25 }");

  const Outcome outcome =
      run({"design", "--config", config("cone"), hidden, "--out", place.path() / "m"});

  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.out, "");
  expect_one_line(outcome.err);
  EXPECT_THAT(outcome.err, HasSubstr(hidden.string() + ": ring hidden by the body"));
  EXPECT_THAT(outcome.err, HasSubstr("0.0206 m too much"));
  EXPECT_THAT(files_in(place.path()), ElementsAre("hidden.textproto"));
}

TEST(MirrorDesign, OfABadFileIsBadInputAndWritesNothing) {
  const TempDirectory place;
  const auto bad = place.write("bad.textproto", "name: \"b\" cone { apex_m: -1 slope_deg: 20 }");

  const Outcome outcome = run({"design", "--config", bad, "--out", place.path() / "m"});

  EXPECT_EQ(outcome.exit_code, 2);
  expect_one_line(outcome.err);
  EXPECT_THAT(outcome.err, HasSubstr("apex_m"));
  EXPECT_THAT(files_in(place.path()), ElementsAre("bad.textproto"));
}

TEST(MirrorDesign, RefusesTwoFilesOfOneName) {
  const TempDirectory place;

  const Outcome outcome =
      run({"design", "--config", config("cone"), config("cone"), "--out", place.path() / "m"});

  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("two files named cone"));
  EXPECT_TRUE(files_in(place.path()).empty());
}

TEST(MirrorTrace, PrintsOneLinePerPixel) {
  const Outcome outcome = run({"trace",
                               "--config",
                               config("multi_part"),
                               "--pixel-radius",
                               "100",
                               "400",
                               "--distance-m",
                               "1"});

  std::istringstream lines(outcome.out);
  std::string first;
  std::string second;
  std::getline(lines, first);
  std::getline(lines, second);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NEAR(json::parse(first)["ground_distance_m"], 1.7414226, 1e-6);
  EXPECT_NEAR(json::parse(first)["heights"][0]["height_m"], 0.328496, 1e-6);
  EXPECT_EQ(json::parse(second)["part"], "ring");
  EXPECT_TRUE(json::parse(second)["heights"][0]["height_m"].is_null());
}

TEST(MirrorTrace, SaysNoBesideTheMirror) {
  const Outcome outcome = run({"trace", "--config", config("multi_part"), "--pixel-radius", "513"});

  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(json::parse(outcome.out)["ground_distance_m"].is_null());
}

TEST(MirrorTrace, RefusesANegativeRadius) {
  EXPECT_EQ(run({"trace", "--config", config("cone"), "--pixel-radius", "-3"}).exit_code, 2);
}

}  // namespace
}  // namespace teamsight::test
