// tests/process/program_test.cpp: what a program says and returns when it cannot start.
#include "process/program.hpp"

#include <stdexcept>

#include <CLI/CLI.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace teamsight::process {
namespace {

TEST(Program, ReturnsWhatItsBodyReturns) {
  EXPECT_EQ(run_program("p", [] { return kAnswerIsNo; }), kAnswerIsNo);
}

TEST(Program, TurnsAnExceptionIntoOneLineAndExitCodeTwo) {
  testing::internal::CaptureStderr();

  const int code =
      run_program("p", []() -> int { throw std::runtime_error("a.textproto:\nid: found 0\n"); });

  EXPECT_EQ(testing::internal::GetCapturedStderr(), "p: a.textproto: id: found 0\n");
  EXPECT_EQ(code, kBadInput);
}

TEST(Program, SurvivesSomethingThatIsNoException) {
  testing::internal::CaptureStderr();

  const int code = run_program("p", []() -> int { throw 7; });

  EXPECT_EQ(testing::internal::GetCapturedStderr(), "p: something unknown was thrown\n");
  EXPECT_EQ(code, kBadInput);
}

TEST(Program, NamesAWrongOptionInOneLine) {
  CLI::App app("test");
  const char* const argv[] = {"p", "--bogus"};

  EXPECT_THAT([&] { (void)parse_command_line(app, 2, argv); },
              testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr("--bogus")));
}

TEST(Program, PrintsHelpAndIsDone) {
  CLI::App app("test");
  const char* const argv[] = {"p", "--help"};
  testing::internal::CaptureStdout();

  const auto code = parse_command_line(app, 2, argv);

  EXPECT_THAT(testing::internal::GetCapturedStdout(), testing::HasSubstr("--help"));
  EXPECT_EQ(code, kDone);
}

TEST(Program, GoesOnAfterAGoodCommandLine) {
  CLI::App app("test");
  int value = 0;
  app.add_option("--value", value);
  const char* const argv[] = {"p", "--value", "3"};

  EXPECT_EQ(parse_command_line(app, 3, argv), std::nullopt);
  EXPECT_EQ(value, 3);
}

TEST(Program, DrawsDifferentBootIds) {
  const auto first = draw_boot_id();
  const auto second = draw_boot_id();

  EXPECT_NE(first, 0U);
  EXPECT_NE(first, second);  // equal once in four billion runs
}

}  // namespace
}  // namespace teamsight::process
