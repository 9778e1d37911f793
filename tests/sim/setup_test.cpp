// tests/sim/setup_test.cpp: match files, and what a simulator makes of them.
#include "sim/setup.hpp"

#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/process.hpp"

namespace teamsight::sim {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class MatchFile : public testing::Test {
 protected:
  // A match of two robots with these lines besides.
  [[nodiscard]] sim::Setup load(const std::string& lines) const {
    const auto config = test::source_path("config").string();
    const auto file =
        folder_.write("match.textproto",
                      "field: \"" + config + "/fields/msl-2024.textproto\"\n" + "camera: \"" +
                          config + "/cameras/sim-640.textproto\"\nrobot: [2, 4]\n" + lines);
    return load_setup(file, {}, {});
  }

  // Why it does not load.
  [[nodiscard]] std::string refusal(const std::string& lines) const {
    try {
      (void)load(lines);
    } catch (const std::exception& error) {
      return error.what();
    }
    return "";
  }

 private:
  test::TempDirectory folder_;
};

TEST_F(MatchFile, NamesTheScenarioThatIsPlayed) {
  const sim::Setup setup = load("scenario: \"kicks\"\nopponents: 3\n");

  EXPECT_EQ(setup.parameters.own, (std::vector<RobotId>{2, 4}));
  EXPECT_EQ(setup.parameters.opponents, 3U);
  EXPECT_EQ(setup.parameters.style.shot_share, 1.0);
}

TEST_F(MatchFile, SetsThePicture) {
  const sim::Setup setup =
      load("picture { exposure_ms: 8 strut { direction_deg: 180 half_width_deg: 2 } }");

  EXPECT_DOUBLE_EQ(setup.match.picture.exposure, 0.008);
  ASSERT_EQ(setup.match.picture.struts.size(), 1U);
  EXPECT_NEAR(setup.match.picture.struts[0].direction, 3.14159265, 1e-8);
}

TEST_F(MatchFile, PaintsTheBall) {
  const sim::Setup setup =
      load("ball { paint { red: 230 green: 220 blue: 210 } pattern: FOOTBALL }");

  const BallLook look = make_eye(setup, 0, setup.camera.format).bodies.ball;
  EXPECT_EQ(look.paint, (Paint{230, 220, 210}));
  EXPECT_EQ(look.pattern, BallPattern::kFootball);
  EXPECT_EQ(look.panels, BallLook{}.panels);
  EXPECT_EQ(make_eye(load(""), 0, setup.camera.format).bodies.ball, BallLook{});
}

TEST_F(MatchFile, IsRefusedWithPanelsOfAPlainBall) {
  EXPECT_THAT(refusal("ball { panels { red: 1 green: 2 blue: 3 } }"),
              AllOf(HasSubstr("ball.panels"), HasSubstr("FOOTBALL or OCTANTS")));
}

TEST_F(MatchFile, IsRefusedWithAScenarioThatNobodyKnows) {
  EXPECT_THAT(refusal("scenario: \"rugby\"\n"),
              AllOf(HasSubstr("match.textproto"),
                    HasSubstr("scenario: found \"rugby\""),
                    HasSubstr("expected one of play, ")));
}

TEST_F(MatchFile, IsRefusedWithAPictureOutOfRange) {
  EXPECT_THAT(refusal("picture { moments: 17 }"),
              AllOf(HasSubstr("match.textproto"), HasSubstr("moments"), HasSubstr("17")));
}

// A table says what the picture shows, not what mirror made it.
TEST_F(MatchFile, IsRefusedWithDefectsOfAMirrorThatIsNotKnown) {
  EXPECT_THAT(refusal("picture { defect_seed: 7 }"),
              AllOf(HasSubstr("picture.defect_seed"), HasSubstr("radial table")));
}

}  // namespace
}  // namespace teamsight::sim
