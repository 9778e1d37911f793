// tests/vision/mirror/mirror_file_test.cpp: mirror files and profiles are read, written and
// refused.
#include "settings/mirror_file.hpp"

#include <gmock/gmock.h>

#include "tests/support/process.hpp"
#include "tests/vision/mirror/mirrors.hpp"
#include "vision/mirror/trace.hpp"

namespace teamsight::settings {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(MirrorFile, NeedsNothingButANameAndAShape) {
  const test::TempDirectory folder;
  const auto path = folder.write("m.textproto", "name: \"default\" multi_part {}");

  EXPECT_EQ(load_mirror(path).parameters, test::default_parameters());
}

TEST(MirrorFile, OfTheMultiPartMirrorStatesTheDefaults) {
  auto written = load_mirror(test::source_path("config/mirrors/multi_part.textproto"));
  EXPECT_EQ(written.pixel_pitch, 4.8e-6);

  written.parameters.name = "default";
  written.parameters.body.clear();

  EXPECT_EQ(written.parameters, test::default_parameters());
}

TEST(MirrorFile, BringsItsOwnProfile) {
  const test::TempDirectory folder;
  const mirror::Profile profile = test::designed("multi_part").assembly.profile;
  static_cast<void>(folder.write("p.csv", mirror_profile_csv(profile)));
  const auto path = folder.write("m.textproto", "name: \"again\" profile_csv: \"p.csv\"");

  const mirror::Mirror again = mirror::design(load_mirror(path).parameters).value();
  const mirror::Mirror first = mirror::design(test::default_parameters()).value();

  EXPECT_NEAR(again.assembly.focal_px, first.assembly.focal_px, 1e-9);
  for (double radius = 1.5; radius < 512.0; radius += 7.3) {
    const auto expected = mirror::trace(first.assembly, radius);
    const auto found = mirror::trace(again.assembly, radius);
    EXPECT_NEAR(found->psi, expected->psi, 1e-9) << radius;
  }
}

TEST(MirrorProfile, GrowsStrictlyAndKeepsItsKink) {
  const test::TempDirectory folder;
  const auto path =
      folder.write("p.csv", mirror_profile_csv(test::designed("multi_part").assembly.profile));

  const mirror::Profile read = read_mirror_profile(path);

  ASSERT_EQ(read.parts.size(), 2U);  // the smooth joint A is no border any more
  EXPECT_TRUE(read.parts[1].kinked_start);
  EXPECT_NEAR(read.parts[1].nodes.front().x - read.parts[0].nodes.back().x, 1e-9, 1e-15);
  EXPECT_EQ(read.parts[1].nodes.front().slope, 0.0);
}

struct Spoilt {
  std::string text;
  std::string place;
  std::string words;
};

std::string complaint_of(const std::filesystem::path& path) {
  try {
    static_cast<void>(load_mirror(path));
  } catch (const SettingsError& error) {
    return error.what();
  }
  return "no complaint";
}

class SpoiltMirrorFile : public testing::TestWithParam<Spoilt> {};

TEST_P(SpoiltMirrorFile, IsRefusedInOneLine) {
  const test::TempDirectory folder;
  const auto path = folder.write("m.textproto", GetParam().text);

  EXPECT_THAT(complaint_of(path),
              AllOf(HasSubstr(path.string() + GetParam().place),
                    HasSubstr(GetParam().words),
                    testing::Not(HasSubstr("\n"))));
}

INSTANTIATE_TEST_SUITE_P(
    Reasons,
    SpoiltMirrorFile,
    testing::Values(
        Spoilt{"multi_part {}", ":1", "name"},
        Spoilt{"name: \"m\"", ":1", "one of multi_part, cone, sphere"},
        Spoilt{"name: \"m\"\nmulti_part { ring_near_m: 0.7 }", ":2", "less than ring_far_m, 0.51"},
        Spoilt{"name: \"m\" multi_part { max_distance_m: 5 }", ":1", "more than isometric_range_m"},
        Spoilt{"name: \"m\" multi_part { isometric_share: 1.2 }", ":1", "from 0.05 to 0.99"},
        Spoilt{"name: \"m\" multi_part { rim: 1 }", ":1", "rim"},
        Spoilt{"name: \"m\" cone { slope_deg: 30 }", ":1", "apex_m"},
        Spoilt{"name: \"m\" cone_with_apex { near_m: 7 rim_y_m: 0.2 }", ":1", "less than far_m, 6"},
        Spoilt{"name: \"m\" sphere { apex_m: nan radius_m: 1 }", ":1", "apex_m"},
        Spoilt{"name: \"m\" profile_csv: \"none.csv\"", ":1", "none.csv"}));

class SpoiltProfile : public testing::TestWithParam<Spoilt> {};

TEST_P(SpoiltProfile, IsRefusedWithTheLine) {
  const test::TempDirectory folder;
  const auto csv = folder.write("p.csv", GetParam().text);
  const auto path = folder.write("m.textproto", "name: \"m\" profile_csv: \"p.csv\"");

  EXPECT_THAT(complaint_of(path),
              AllOf(HasSubstr(csv.string() + GetParam().place), HasSubstr(GetParam().words)));
}

INSTANTIATE_TEST_SUITE_P(
    Reasons,
    SpoiltProfile,
    testing::Values(
        Spoilt{"", ":1", "no rows"},
        Spoilt{"x_m,y_m\n0,1\n", ":1", "the head x_m,y_m,slope"},
        Spoilt{"x_m,y_m,slope\n0,0.1,0\n0.1,0.2\n", ":3", "three finite numbers"},
        Spoilt{"x_m,y_m,slope\n0,0.1,0\n0.1,inf,0\n", ":3", "three finite numbers"},
        Spoilt{"x_m,y_m,slope\n0,0.1,0\n0.1,0.1,0\n0.05,0.1,0\n", ":4", "must be a function"},
        Spoilt{"x_m,y_m,slope\n-0.1,0.1,0\n0.1,0.1,0\n", ":2", "at least 0, the axis"},
        Spoilt{"x_m,y_m,slope\n0,0.1,0\n0.1,-0.1,0\n", ":3", "above 0, the pinhole"},
        Spoilt{"x_m,y_m,slope\n0,0.1,0\n", ":2", "at least two rows"}));

}  // namespace
}  // namespace teamsight::settings
