// tests/support/process_test.cpp: children end with the test object, and say how they ended.
#include "tests/support/process.hpp"

#include <fstream>

#include <gtest/gtest.h>
#include <signal.h>

namespace teamsight::test {
namespace {

using std::chrono::milliseconds;

// A process that has ended may still wait for its parent to read its exit code.
bool is_alive(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::string number;
  std::string name;
  char state = 'X';
  file >> number >> name >> state;
  return state != 'X' && state != 'Z';
}

TEST(ChildProcess, ReportsTheExitCodeAndWhatWasPrinted) {
  ChildProcess child({"/bin/sh", "-c", "echo hello; echo oh >&2; exit 7"});

  EXPECT_EQ(child.wait_exit(milliseconds(5000)), 7);
  EXPECT_EQ(child.out(), "hello\n");
  EXPECT_EQ(child.err(), "oh\n");
}

TEST(ChildProcess, ReportsASignalAsTheShellDoes) {
  ChildProcess child({"/bin/sleep", "100"});

  child.kill(SIGINT);

  EXPECT_EQ(child.wait_exit(milliseconds(5000)), 128 + SIGINT);
}

TEST(ChildProcess, HasNoExitCodeWhileItRuns) {
  ChildProcess child({"/bin/sleep", "100"});

  EXPECT_EQ(child.wait_exit(milliseconds(10)), std::nullopt);
  EXPECT_TRUE(child.is_running());
}

TEST(ChildProcess, TakesItsGrandchildrenAlong) {
  const TempDirectory directory;
  const std::string file = (directory.path() / "pid").string();
  pid_t grandchild = 0;
  {
    ChildProcess child({"/bin/sh", "-c", "sleep 100 & echo $! > " + file + "; wait"});
    ASSERT_TRUE(
        wait_until([&] { return bool(std::ifstream(file) >> grandchild); }, milliseconds(5000)));
  }

  EXPECT_TRUE(wait_until([&] { return !is_alive(grandchild); }, milliseconds(5000)));
}

TEST(ChildProcess, SetsTheEnvironment) {
  ChildProcess child({"/bin/sh", "-c", "echo $COLOUR"}, {{"COLOUR", "green"}});

  ASSERT_EQ(child.wait_exit(milliseconds(5000)), 0);
  EXPECT_EQ(child.out(), "green\n");
}

TEST(UniqueDomain, StaysTheSameAndLeavesRoomForAHostDomain) {
  EXPECT_EQ(unique_domain(), unique_domain());
  EXPECT_EQ(unique_domain() % 2, 0U);
  EXPECT_LE(unique_domain(), 98U);
}

}  // namespace
}  // namespace teamsight::test
