// tests/system/bad_input_test.cpp: what cannot start says why in one line and exits with 2.
#include <algorithm>
#include <memory>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/system/team.hpp"

namespace teamsight::test {
namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::HasSubstr;

class BadInput : public testing::Test {
 protected:
  // The one line of a process that should not have started.
  static std::string last_words(ChildProcess& process) {
    EXPECT_EQ(process.wait_exit(30s), 2);
    const std::string text = process.err();
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
    return text;
  }

  Team team_{"robot"};
};

TEST_F(BadInput, NamesAKeyThatNobodyKnows) {
  team_.config().append("robots/robot1.textproto", "\ncolour: RED\n");

  EXPECT_THAT(last_words(*team_.agent(1, "stream:/nowhere")),
              AllOf(HasSubstr("robot1.textproto"), HasSubstr("colour")));
}

TEST_F(BadInput, NamesAKeyThatIsMissing) {
  team_.config().replace("robots/robot1.textproto", "id: 1\n");

  EXPECT_THAT(last_words(*team_.agent(1, "stream:/nowhere")),
              AllOf(HasSubstr("robot1.textproto"), HasSubstr("team")));
}

TEST_F(BadInput, NamesAFrameOfTheWrongSize) {
  const TempDirectory directory;
  const std::string frame = directory.write("small.raw", "too small").string();

  EXPECT_THAT(last_words(*team_.agent(1, frame)),
              AllOf(HasSubstr(frame), HasSubstr("found 9 bytes, expected 614400")));
}

TEST_F(BadInput, NamesAFileThatCannotBeRead) {
  EXPECT_THAT(last_words(*team_.agent(1, "raw:/nowhere/frame.raw")),
              HasSubstr("/nowhere/frame.raw: cannot be read"));
}

TEST_F(BadInput, NamesASourceOfUnknownKind) {
  EXPECT_THAT(last_words(*team_.agent(1, "film:reel")), HasSubstr("found \"film:reel\""));
}

TEST_F(BadInput, NamesAPriorThatIsNone) {
  EXPECT_THAT(last_words(*team_.agent(1, "stream:/nowhere", {"--prior", "1,2"})),
              HasSubstr("--prior: found \"1,2\", expected x_m,y_m,theta_rad"));
}

TEST_F(BadInput, NamesAProfileThatDoesNotParse) {
  team_.config().replace("dds/loopback.xml", "<CycloneDDS><Domain></CycloneDDS>\n");

  EXPECT_THAT(last_words(*team_.agent(1, "stream:/nowhere")), HasSubstr("loopback.xml"));
}

TEST_F(BadInput, EndsTheSimulatorToo) {
  team_.config().append("matches/demo.textproto", "\nweather: RAIN\n");

  EXPECT_THAT(last_words(*team_.simulator()),
              AllOf(HasSubstr("demo.textproto"), HasSubstr("weather")));
}

}  // namespace
}  // namespace teamsight::test
