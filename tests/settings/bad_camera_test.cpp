// tests/settings/bad_camera_test.cpp: what is said about camera files that cannot be used.
#include <gmock/gmock.h>

#include "settings/load.hpp"
#include "tests/settings/camera_text.hpp"
#include "tests/settings/temporary_files.hpp"

namespace teamsight::settings {
namespace {

// A file whose colours go by a cube, and what may be wrong with it.
constexpr const char* kCubeCamera = R"(name: "eye"
width_px: 640
height_px: 480
format: UYVY
radial_table {
  centre_u_px: 320
  centre_v_px: 240
  mirror_height_m: 0.67
  row { radius_px: 100 distance_m: 1 }
  row { radius_px: 150 distance_m: 2 }
  row { radius_px: 180 distance_m: 4 }
}
mounting { forward_deg: 90 mirrored: false }
colours {
  white_min_y: 150
  black_max_y: 50
  method: CUBE
  cube {
    red { red: 1 green: -0.5 threshold: 40 }
    green { green: 1 threshold: 80 }
    blue { blue: 1 threshold: 90 }
    vertex { at: YELLOW class: BALL }
    vertex { at: CYAN }
  }
}
)";

class BadCube : public testing::TestWithParam<Spoilt> {};

TEST_P(BadCube, IsNamedWithPlaceKeyFoundAndExpected) {
  const TemporaryFolder folder;
  const auto path = folder.write("eye.textproto", spoil(kCubeCamera, GetParam()));

  const std::string complaint = complaint_of([&] { std::ignore = load_camera(path); });

  EXPECT_EQ(complaint, expected_complaint(path, GetParam()));
}

// clang-format off
INSTANTIATE_TEST_SUITE_P(Each, BadCube, testing::Values(
    Spoilt{"MethodUnknown", "method: CUBE", "method: DISCS", "17:11", "colours.method",
           "'DISCS'", "one of SAMPLES, TABLE, CUBE"},
    Spoilt{"TableWithoutATable", "method: CUBE", "method: TABLE", "17:3", "colours.method",
           "TABLE without a table", "colours.table beside it"},
    Spoilt{"CubeThatNothingAsks", "  method: CUBE\n", "", "17:3", "colours.cube",
           "a cube, but no method", "colours.method: CUBE, or another"},
    Spoilt{"PlaneWithoutWeights", "green { green: 1", "green { green: 0", "20:5", "colours.cube.green",
           "no weight", "one of red, green or blue"},
    Spoilt{"PlaneBesideAllColours", "threshold: 80", "threshold: 255", "20:22", "colours.cube.green.threshold",
           "255", "more than 0 and less than 255, which its weights reach"},
    Spoilt{"PlaneBelowAllColours", "threshold: 40", "threshold: -127.5", "19:30", "colours.cube.red.threshold",
           "-127.5", "more than -127.5 and less than 255, which its weights reach"},
    Spoilt{"PlanesThatDoNotMeet", "blue { blue: 1", "blue { green: 2", "18:3", "colours.cube",
           "planes that do not meet in one point", "weights that are independent"},
    Spoilt{"VertexThatIsNone", "at: CYAN", "at: BALL", "23:14", "colours.cube.vertex[1].at",
           "BALL", "one of the cube's: BLACK, RED, GREEN, YELLOW, BLUE, MAGENTA, CYAN, WHITE"},
    Spoilt{"VertexTwice", "at: CYAN", "at: YELLOW", "23:14", "colours.cube.vertex[1].at",
           "YELLOW", "each vertex once"},
    Spoilt{"NoCarpet", "at: CYAN", "at: GREEN", "18:3", "colours.cube.vertex",
           "none of class GREEN", "one that shows the carpet"}),
    name_of_spoilt);

// clang-format on

TEST(LoadCamera, RefusesTheMethodCubeWithoutACube) {
  const TemporaryFolder folder;
  const auto path =
      folder.write("eye.textproto",
                   spoil(kRadialCamera,
                         {"", "black_max_y: 50", "black_max_y: 50 method: CUBE", "", "", "", ""}));

  EXPECT_EQ(complaint_of([&] { std::ignore = load_camera(path); }),
            path.string() +
                ":16:19: key 'colours.method': found CUBE without a cube, expected colours.cube "
                "beside it");
}

class BadCamera : public testing::TestWithParam<Spoilt> {};

TEST_P(BadCamera, IsNamedWithPlaceKeyFoundAndExpected) {
  const TemporaryFolder folder;
  const auto path = folder.write("eye.textproto", spoil(kRadialCamera, GetParam()));

  const std::string complaint = complaint_of([&] { std::ignore = load_camera(path); });

  EXPECT_EQ(complaint, expected_complaint(path, GetParam()));
}

// clang-format off
INSTANTIATE_TEST_SUITE_P(Each, BadCamera, testing::Values(
    Spoilt{"RadiusThatDoesNotGrow", "radius_px: 150", "radius_px: 100", "10:9",
           "radial_table.row[1].radius_px", "100", "more than in the row before, 100"},
    Spoilt{"DistanceThatDoesNotGrow", "distance_m: 4", "distance_m: 1.5", "11:24",
           "radial_table.row[2].distance_m", "1.5", "more than in the row before, 2"},
    Spoilt{"TooFewRows", "  row { radius_px: 180 distance_m: 4 }\n", "", "5:1",
           "radial_table.row", "2 rows", "at least 3"},
    Spoilt{"RepeatedBlockOutOfRange", "sigma_px: 1.5", "sigma_px: 0", "10:38",
           "radial_table.row[1].sigma_px", "0", "a finite number from 0.01 to 50"},
    Spoilt{"CentreLeftOfTheImage", "centre_u_px: 320", "centre_u_px: -1", "6:3",
           "radial_table.centre_u_px", "-1", "a place in the image, from 0 to 639"},
    Spoilt{"CentreBelowTheImage", "centre_v_px: 240", "centre_v_px: 480", "7:3",
           "radial_table.centre_v_px", "480", "a place in the image, from 0 to 479"},
    Spoilt{"TwoMirrors", "mounting", "profile { }\nmounting", "13:1", "profile",
           "'profile' besides 'radial_table'", "only one of the two"},
    Spoilt{"SampleTwice", "u: 90 v: 190", "u: 110 v: 100", "18:3",
           "colours.sample[1]", "the same u and v as in sample[0]", "each (u, v) once"},
    Spoilt{"SampleOutOfRange", "u: 90", "u: 256", "18:24", "colours.sample[1].u",
           "256", "a whole number from 0 to 255"},
    Spoilt{"NegativeCount", "width_px: 640", "width_px: -640", "2:11", "width_px",
           "'-'", "a whole number from 16 to 8192"},
    Spoilt{"HugeCount", "width_px: 640", "width_px: 4294967296", "2:11", "width_px",
           "4294967296", "a whole number from 16 to 8192"},
    Spoilt{"OddWidth", "width_px: 640", "width_px: 641", "2:1", "width_px",
           "641", "an even number: in this format pixels share their chroma"},
    Spoilt{"UnknownFormat", "UYVY", "RGB", "4:9", "format",
           "'RGB'", "one of BGR, YUYV, UYVY, GREY, NV12, BAYER_RGGB, BAYER_BGGR, BAYER_GRBG, BAYER_GBRG"},
    Spoilt{"BlackAboveWhite", "black_max_y: 50", "black_max_y: 150", "16:3", "colours.black_max_y",
           "150", "less than white_min_y, 150"},
    Spoilt{"PaintDarkerThanTheCarpet", "black_max_y: 50",
           "black_max_y: 50 light { green { y: 90 u: 110 v: 100 } white { y: 90 u: 128 v: 128 } }", "16:65",
           "colours.light.white.y", "90", "more than green's, 90"},
    Spoilt{"PatternOfOneClass", "black_max_y: 50", "black_max_y: 50 pattern { class: WHITE }", "16:19",
           "colours.pattern", "1 of the ball's classes", "at least 2, such as `class: WHITE class: BLACK`; a "
           "ball of one colour is told by samples of class BALL"},
    Spoilt{"PatternOfNoClass", "black_max_y: 50", "black_max_y: 50 pattern { }", "16:19",
           "colours.pattern", "0 of the ball's classes", "at least 2, such as `class: WHITE class: BLACK`; a "
           "ball of one colour is told by samples of class BALL"},
    Spoilt{"PatternWithAClassTwice", "black_max_y: 50", "black_max_y: 50 pattern { class: WHITE class: WHITE }",
           "16:42", "colours.pattern.class[1]", "WHITE again", "each class of the ball once"},
    Spoilt{"PatternWithTheCarpet", "black_max_y: 50", "black_max_y: 50 pattern { class: WHITE class: GREEN }",
           "16:42", "colours.pattern.class[1]", "GREEN", "a class that the carpet has not"},
    Spoilt{"PatternWithAClassWithoutSamples", "black_max_y: 50",
           "black_max_y: 50 pattern { class: WHITE class: BLUE }", "16:42", "colours.pattern.class[1]",
           "BLUE, which no colour is of", "a class that a sample, hue, table or cube names"},
    Spoilt{"PatternWithAnUnknownClass", "black_max_y: 50",
           "black_max_y: 50 pattern { class: WHITE class: PLAID }", "16:49", "colours.pattern.class",
           "'PLAID'", "one of GREEN, BALL, BLUE, YELLOW, MAGENTA, CYAN, RED, WHITE, BLACK"},
    Spoilt{"RimInsideTheBody", "outer_radius_px: 175", "outer_radius_px: 40", "22:3",
           "mask.outer_radius_px", "40", "more than inner_radius_px, 40"},
    Spoilt{"MaskBeyondTheMirror", "outer_radius_px: 175", "outer_radius_px: 182", "22:3",
           "mask.outer_radius_px", "182", "at most where the mirror ends, 180 px"},
    Spoilt{"SectorBackwards", "to_deg: 370", "to_deg: 10", "23:26", "mask.sector[0].to_deg",
           "10", "more than from_deg, by less than a full turn"}),
    name_of_spoilt);

// clang-format on

TEST(LoadCamera, RefusesACameraWithoutMirror) {
  const TemporaryFolder folder;
  const auto path = folder.write(
      "eye.textproto",
      "name: \"eye\" width_px: 640 height_px: 480 format: BGR\n"
      "mounting { forward_deg: 0 mirrored: false } colours { white_min_y: 9 black_max_y: 1 }");

  EXPECT_EQ(complaint_of([&] { std::ignore = load_camera(path); }),
            path.string() +
                ":1:1: key 'mirror': found no mirror, expected a block radial_table "
                "or profile");
}

TEST(LoadCamera, RefusesAMirrorThatDoesNotCoverTheImage) {
  const TemporaryFolder folder;
  std::ignore = folder.write("eye.csv", "x_m,y_m\n0,0.2\n0.002,0.21\n0.004,0.23\n");
  const auto path = folder.write("eye.textproto", kProfileCamera);

  EXPECT_EQ(complaint_of([&] { std::ignore = load_camera(path); }),
            path.string() +
                ":10:3: key 'profile.profile_csv': found a mirror whose rim is seen 10 px "
                "from the centre of the image, expected at least 96 px: it does not "
                "cover the image");
}

TEST(LoadCamera, RefusesACalibrationOfAnotherKindOfMirror) {
  const TemporaryFolder folder;
  const auto path =
      folder.write("eye.textproto",
                   std::string(kRadialCamera) +
                       "calibration {\n  knob { name: \"tilt_x_rad\" sigma: 0.1 }\n}\n");

  EXPECT_EQ(complaint_of([&] { std::ignore = load_camera(path); }),
            path.string() +
                ":26:10: key 'calibration.knob[0].name': found tilt_x_rad, expected a "
                "knob of this kind of mirror");
}

TEST(LoadCamera, NamesTheProfileThatIsNotThere) {
  const TemporaryFolder folder;
  const auto path = folder.write("eye.textproto", kProfileCamera);

  EXPECT_EQ(complaint_of([&] { std::ignore = load_camera(path); }),
            path.string() + ":10:3: key 'profile.profile_csv': found no file " +
                (folder.path() / "eye.csv").string() +
                ", expected the path of a file, relative to this one");
}

TEST(LoadCamera, RefusesATableOfClassesThatIsNone) {
  const TemporaryFolder folder;
  const auto table = folder.write("eye-classes.bin", "teamsight");
  const auto path = folder.write(
      "eye.textproto",
      spoil(kRadialCamera,
            {"", "black_max_y: 50", "black_max_y: 50 table: \"eye-classes.bin\"", "", "", "", ""}));

  const std::string complaint = complaint_of([&] { std::ignore = load_camera(path); });

  EXPECT_EQ(
      complaint,
      table.string() + ":1:1: found 9 bytes, expected a table of colour classes, 262188 bytes");
}

}  // namespace
}  // namespace teamsight::settings
