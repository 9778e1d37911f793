// tests/deploy/scripts_test.cpp: the scripts refuse bad input with one line and exit code 2.
#include <algorithm>
#include <chrono>
#include <ostream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/process.hpp"

namespace teamsight::test {
namespace {

struct BadCall {
  std::vector<std::string> words;  // script and arguments
  std::string line;                // part of what it says
};

std::ostream& operator<<(std::ostream& out, const BadCall& call) {
  return out << call.words.front() << ": " << call.line;
}

class Scripts : public testing::TestWithParam<BadCall> {};

TEST_P(Scripts, RefuseBadInputInOneLine) {
  std::vector<std::string> words = GetParam().words;
  words.front() = source_path(words.front()).string();

  ChildProcess script(words, {{"TEAMSIGHT_DATA", "/nowhere"}});

  EXPECT_EQ(script.wait_exit(std::chrono::seconds(20)), 2);
  EXPECT_THAT(script.err(), testing::HasSubstr(GetParam().line));
  const std::string said = script.err();
  EXPECT_EQ(std::count(said.begin(), said.end(), '\n'), 1) << said;
}

INSTANTIATE_TEST_SUITE_P(
    Deploy,
    Scripts,
    testing::Values(
        BadCall{{"deploy/setup", "nonsense"}, "unknown group 'nonsense'"},
        BadCall{{"deploy/demo", "--port", "http"}, "--port is 'http'; expected a number"},
        BadCall{{"deploy/demo", "--robots", "6"}, "--robots is '6'; expected a number from 1 to 5"},
        BadCall{{"deploy/demo", "--bin", "/nowhere"}, "no teamsight-agent in /nowhere"},
        BadCall{{"deploy/demo", "--fast"}, "unknown argument '--fast'"},
        BadCall{{"deploy/lint", "nonsense"}, "unknown argument 'nonsense'"},
        BadCall{{".ci/run", "nonsense"}, "TEAMSIGHT_DATA is '/nowhere'"}));

}  // namespace
}  // namespace teamsight::test
