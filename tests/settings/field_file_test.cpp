// tests/settings/field_file_test.cpp: the rulebook's letters become lines, arcs, spots and goals.
#include <algorithm>
#include <cstdlib>
#include <numbers>

#include <gmock/gmock.h>

#include "settings/load.hpp"
#include "tests/settings/temporary_files.hpp"

namespace teamsight::settings {
namespace {

FieldModel configured(const char* name) {
  const char* source = std::getenv("TEAMSIGHT_SOURCE_DIR");
  return load_field(std::filesystem::path(source ? source : ".") / "config/fields" / name);
}

const FieldLine& line_called(const FieldModel& field, const std::string& name) {
  return *std::ranges::find(field.lines, name, &FieldLine::name);
}

// Where the family's lines lie on the other axis, each place once: "interrupted lines as one".
std::vector<double> places_of(const FieldModel& field, LineFamily family) {
  std::vector<double> places;
  for (const FieldLine& line : field.lines) {
    if (line.family != family) continue;
    places.push_back(family == LineFamily::kVertical ? line.from.x : line.from.y);
  }
  std::ranges::sort(places);
  const auto rest = std::ranges::unique(places);
  places.erase(rest.begin(), rest.end());
  return places;
}

TEST(FieldFile, TurnsLettersIntoTheLinesOfTheLeague) {
  const FieldModel field = configured("msl-2024.textproto");

  EXPECT_EQ(field.lines.size(), 5U + 4U * 3U);
  EXPECT_EQ(field.arcs.size(), 5U);
  EXPECT_EQ(field.spots.size(), 3U);
  EXPECT_EQ(line_called(field, "left side line"),
            (FieldLine{"left side line", {-11, 7}, {11, 7}, LineFamily::kHorizontal}));
  EXPECT_EQ(
      line_called(field, "opponent penalty area front"),
      (FieldLine{
          "opponent penalty area front", {8.75, 3.45}, {8.75, -3.45}, LineFamily::kVertical}));
  EXPECT_EQ(
      line_called(field, "own goal area right side"),
      (FieldLine{
          "own goal area right side", {-11, -1.95}, {-10.25, -1.95}, LineFamily::kHorizontal}));
}

TEST(FieldFile, CornerArcsPointIntoTheField) {
  const FieldModel field = configured("msl-2024.textproto");

  for (const FieldArc& arc : field.arcs) {
    if (arc.name == "centre circle") continue;
    const double middle = arc.start + 0.5 * arc.sweep;
    EXPECT_LT(std::cos(middle) * arc.centre.x, 0.0) << arc.name;
    EXPECT_LT(std::sin(middle) * arc.centre.y, 0.0) << arc.name;
  }
}

TEST(FieldFile, GoalPostsAreNamedAsSeenFromTheField) {
  const FieldModel field = configured("msl-2024.textproto");

  ASSERT_EQ(field.goals.size(), 2U);
  EXPECT_EQ(field.goals[0].left_post, (Point<Field>{-11, -1}));  // looking towards -x, left is -y
  EXPECT_EQ(field.goals[1].left_post, (Point<Field>{11, 1}));
}

TEST(FieldFile, OfThePaperHasFiveVerticalAndSixHorizontalLines) {
  const FieldModel field = configured("robocup-2001.textproto");

  EXPECT_THAT(places_of(field, LineFamily::kVertical), testing::ElementsAre(-4.5, -3, 0, 3, 4.5));
  EXPECT_THAT(places_of(field, LineFamily::kHorizontal),
              testing::ElementsAre(-2.25, -1.5, -1, 1, 1.5, 2.25));
  EXPECT_EQ(field.goals.at(0).colour, GoalColour::kBlue);
  EXPECT_EQ(field.goals.at(1).colour, GoalColour::kYellow);
}

TEST(FieldFile, EveryConfiguredFieldIsHalfTurnSymmetric) {
  EXPECT_TRUE(is_half_turn_symmetric(configured("msl-2024.textproto")));
  EXPECT_TRUE(is_half_turn_symmetric(configured("robocup-2001.textproto")));
  EXPECT_TRUE(is_half_turn_symmetric(configured("kassel-lab.textproto")));
}

TEST(FieldFile, OffsetMovesEverything) {
  const TemporaryFolder folder;
  const std::string text =
      "name: \"a\" length_m: 10 width_m: 6 line_width_m: 0.1 rulebook { goal_width_m: 2 }";
  const FieldModel plain = load_field(folder.write("plain", text));

  const FieldModel moved =
      load_field(folder.write("moved", text + " offset { x_m: 1.0 y_m: 0.5 }"));

  EXPECT_EQ(moved, shifted(plain, {1.0, 0.5}));
  EXPECT_EQ(moved.centre, (Point<Field>{1.0, 0.5}));
}

TEST(FieldFile, FreeShapesStandBesideTheLetters) {
  const TemporaryFolder folder;
  const auto path = folder.write("a",
                                 "name: \"a\" length_m: 10 width_m: 6 line_width_m: 0.1\n"
                                 "arc { name: \"d\" centre { x_m: 1 y_m: 2 } radius_m: 0.5\n"
                                 "  start_deg: 90 sweep_deg: 180 }");

  const FieldModel field = load_field(path);

  EXPECT_TRUE(field.lines.empty());
  ASSERT_EQ(field.arcs.size(), 1U);
  EXPECT_NEAR(field.arcs[0].start, 0.5 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(field.arcs[0].sweep, std::numbers::pi, 1e-12);
}

}  // namespace
}  // namespace teamsight::settings
