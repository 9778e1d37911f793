// tests/settings/bad_field_test.cpp: what is said about field files that cannot be used.
#include <limits>

#include <gmock/gmock.h>

#include "settings/load.hpp"
#include "tests/settings/temporary_files.hpp"

namespace teamsight::settings {
namespace {

constexpr const char* kGood = R"(name: "yard"  # { not a block
length_m: 10
width_m: 6
line_width_m: 0.1
rulebook {
  centre_circle_radius_m: 1.0
  goal_colour_own: BLUE
  side_lines: true
}
line {
  name: "kerb"
  from { x_m: 0 y_m: 1 }
  to { x_m: 2 y_m: 1 }
}
)";

class BadField : public testing::TestWithParam<Spoilt> {};

TEST_P(BadField, IsNamedWithPlaceKeyFoundAndExpected) {
  const TemporaryFolder folder;
  const auto path = folder.write("yard.textproto", spoil(kGood, GetParam()));

  const std::string complaint = complaint_of([&] { std::ignore = load_field(path); });

  EXPECT_EQ(complaint, expected_complaint(path, GetParam()));
}

constexpr const char* kPoint = "a block { ... } with x_m, y_m";
constexpr const char* kShape = "one of name, from, to, family";

// clang-format off
INSTANTIATE_TEST_SUITE_P(Each, BadField, testing::Values(
    Spoilt{"OutOfRange", "length_m: 10", "length_m: 1000", "2:1", "length_m",
           "1000", "a finite number from 1 to 120"},
    Spoilt{"NotANumber", "length_m: 10", "length_m: nan", "2:1", "length_m",
           "nan", "a finite number from 1 to 120"},
    Spoilt{"Infinite", "x_m: 2", "x_m: inf", "13:8", "line[0].to.x_m",
           "inf", "a finite number"},
    Spoilt{"NestedOutOfRange", "centre_circle_radius_m: 1.0", "centre_circle_radius_m: -1", "6:3",
           "rulebook.centre_circle_radius_m", "-1", "a finite number from 0 to 15"},
    Spoilt{"MissingKey", "width_m: 6\n", "", "1:1", "width_m",
           "nothing", "a finite number from 1 to 90"},
    Spoilt{"MissingNestedKey", "to { x_m: 2 y_m: 1 }", "to { x_m: 2 }", "13:3", "line[0].to.y_m",
           "nothing", "a finite number"},
    Spoilt{"MissingBlock", "  to { x_m: 2 y_m: 1 }\n", "", "10:1", "line[0].to",
           "nothing", kPoint},
    Spoilt{"UnknownNestedKey", "name: \"kerb\"", "nome: \"kerb\"", "11:3", "line.nome",
           "an unknown key", kShape},
    Spoilt{"UnknownEnumValue", "BLUE", "MAUVE", "7:20", "rulebook.goal_colour_own",
           "'MAUVE'", "one of NONE, BLUE, YELLOW, WHITE"},
    Spoilt{"WordForNumber", "width_m: 6", "width_m: wide", "3:10", "width_m",
           "'wide'", "a finite number from 1 to 90"},
    Spoilt{"WordForBool", "side_lines: true", "side_lines: maybe", "8:15", "rulebook.side_lines",
           "'maybe'", "true or false"},
    Spoilt{"TwiceTheSameKey", "width_m: 6", "width_m: 6 width_m: 6", "3:12", "width_m",
           "a second value", "one value"},
    Spoilt{"NoColon", "width_m: 6", "width_m 6", "3:9", "width_m",
           "'6'", "\":\""},
    Spoilt{"UnitBehindANumber", "width_m: 6", "width_m: 6m", "3:11", "width_m",
           "what the parser refuses (Need space between number and identifier)",
           "protobuf text format"},
    Spoilt{"LineOfNoLength", "to { x_m: 2 y_m: 1 }", "to { x_m: 0 y_m: 1 }", "10:1", "line[0]",
           "a length of 0 m", "two different points"},
    Spoilt{"CircleOutside", "centre_circle_radius_m: 1.0", "centre_circle_radius_m: 3.5", "6:3",
           "rulebook.centre_circle_radius_m", "3.5", "at most half the field's width, 3"},
    Spoilt{"AreaWithoutWidth", "side_lines: true", "goal_area_length_m: 1", "8:3",
           "rulebook.goal_area_length_m", "length 1 and width 0",
           "both above 0, or both 0 for an area that is not painted"}),
    name_of_spoilt);

// clang-format on

TEST(LoadField, RefusesAFieldWithoutPaint) {
  const TemporaryFolder folder;
  const auto path = folder.write("a", "name: \"a\" length_m: 9 width_m: 6 line_width_m: 0.1");

  EXPECT_EQ(complaint_of([&] { std::ignore = load_field(path); }),
            path.string() +
                ":1:1: key 'line': found neither lines nor arcs, expected a rulebook "
                "block, a line or an arc");
}

TEST(LoadField, NamesAFileThatIsNotThere) {
  EXPECT_EQ(complaint_of([] { std::ignore = load_field("/nowhere/a.textproto"); }),
            "/nowhere/a.textproto:1:1: found no readable file, expected a settings file in "
            "protobuf text format");
}

TEST(LoadField, DoesNotTakeAFolderForAFile) {
  const TemporaryFolder folder;

  EXPECT_THAT(complaint_of([&] { std::ignore = load_field(folder.path()); }),
              testing::HasSubstr("found no readable file"));
}

TEST(LoadField, ComplainsInOneLineAboutBytesThatAreNoText) {
  const TemporaryFolder folder;
  const auto path = folder.write("a", std::string("\x00\xff\n{{}\n\"", 7));

  const std::string complaint = complaint_of([&] { std::ignore = load_field(path); });

  EXPECT_THAT(complaint, testing::StartsWith(path.string() + ":1:1: "));
  EXPECT_THAT(complaint, testing::Not(testing::HasSubstr("\n")));
}

TEST(LoadField, NamesTheListOfKeysForAnUnknownOne) {
  const TemporaryFolder folder;
  const auto path = folder.write("a", "\n  heigth_m: 2\n");

  EXPECT_EQ(complaint_of([&] { std::ignore = load_field(path); }),
            path.string() +
                ":2:3: key 'heigth_m': found an unknown key, expected one of name, "
                "rulebook, line, arc, spot, goal, wall, length_m, width_m, "
                "line_width_m, surround_m, offset");
}

}  // namespace
}  // namespace teamsight::settings
