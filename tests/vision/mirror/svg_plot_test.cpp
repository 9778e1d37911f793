// tests/vision/mirror/svg_plot_test.cpp: ticks are round, and drawings are whole.
#include "tools/svg_plot.hpp"

#include <limits>

#include <gmock/gmock.h>

#include "tools/svg_ticks.hpp"

namespace teamsight::plot {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

TEST(Ticks, AreRoundNumbersInsideTheAxis) {
  EXPECT_THAT(ticks({"", 0.0, 12.0, false}, 6), ElementsAre(0, 2, 4, 6, 8, 10, 12));
  EXPECT_THAT(ticks({"", -0.3, 0.31, false}, 4), ElementsAre(DoubleEq(-0.2), 0.0, DoubleEq(0.2)));
}

TEST(Ticks, OfALogarithmicAxisAreOneTwoFive) {
  EXPECT_THAT(ticks({"", 0.7, 30.0, true}, 5), ElementsAre(1, 2, 5, 10, 20));
}

TEST(Ticks, HaveNoNeedlessDigits) {
  EXPECT_EQ(tick_text(0.1 + 0.2), "0.3");
  EXPECT_EQ(tick_text(-1e-17), "0");
}

Figure figure_with(Panel panel) {
  return {.title = "A < B & C", .subtitle = "", .columns = 1, .panels = {std::move(panel)}};
}

Panel panel_with(std::vector<Line> lines) {
  return {.title = "panel",
          .x = {"x [m]", 0.0, 10.0},
          .y = {"y [m]", 0.0, 10.0},
          .areas = {},
          .lines = std::move(lines),
          .marks = {}};
}

TEST(SvgPlot, EscapesItsTexts) {
  const std::string svg = to_svg(figure_with(panel_with({})));

  EXPECT_THAT(svg, HasSubstr("A &lt; B &amp; C"));
  EXPECT_THAT(svg, testing::StartsWith("<svg "));
  EXPECT_THAT(svg, testing::EndsWith("</svg>\n"));
}

TEST(SvgPlot, PutsAPointWhereTheAxesSay) {
  // the middle of 640 x 380 px that begin 86 px from the left
  const Line line{.label = "", .points = {{0.0, 0.0}, {5.0, 5.0}}};

  EXPECT_THAT(to_svg(figure_with(panel_with({line}))), HasSubstr("L406.0 "));
}

TEST(SvgPlot, BreaksALineWhereItHasNoValue) {
  const double nowhere = std::numeric_limits<double>::quiet_NaN();
  const Line line{.label = "", .points = {{0, 0}, {1, 1}, {2, nowhere}, {3, 3}, {4, 4}}};

  const std::string svg = to_svg(figure_with(panel_with({line})));
  const std::string path = svg.substr(svg.find("<path d="));
  const std::string data = path.substr(0, path.find("fill"));

  EXPECT_EQ(std::count(data.begin(), data.end(), 'M'), 2);
  EXPECT_EQ(std::count(data.begin(), data.end(), 'L'), 2);
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(SvgPlot, NamesEachLabelOnceInTheLegend) {
  const Line line{.label = "twice", .points = {{0, 0}, {1, 1}}};

  const std::string svg = to_svg(figure_with(panel_with({line, line})));

  EXPECT_EQ(svg.find("twice"), svg.rfind("twice"));
  EXPECT_NE(svg.find("twice"), std::string::npos);
}

}  // namespace
}  // namespace teamsight::plot
