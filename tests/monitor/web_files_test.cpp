// tests/monitor/web_files_test.cpp: what of a folder is served.
#include "monitor/web_files.hpp"

#include <filesystem>
#include <stdexcept>

#include <gmock/gmock.h>

#include "tests/support/process.hpp"

namespace teamsight::monitor {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(WebFiles, AreKeptByTheirAddress) {
  const test::TempDirectory folder;
  static_cast<void>(folder.write("index.html", "<html></html>"));
  std::filesystem::create_directory(folder.path() / "assets");
  static_cast<void>(folder.write("assets/page.css", "body{}"));

  const WebFiles files = load_web_files(folder.path());

  ASSERT_EQ(files.size(), 3U);
  EXPECT_EQ(files.at("/"), files.at("/index.html"));
  EXPECT_EQ(files.at("/assets/page.css").content_type, "text/css; charset=utf-8");
}

TEST(WebFiles, DoNotFollowLinksOutOfTheFolder) {
  const test::TempDirectory folder;
  static_cast<void>(folder.write("index.html", "<html></html>"));
  std::filesystem::create_symlink("/etc/passwd", folder.path() / "passwd");

  EXPECT_EQ(load_web_files(folder.path()).count("/passwd"), 0U);
}

TEST(WebFiles, NeedAPage) {
  const test::TempDirectory folder;

  EXPECT_THAT([&]() { return load_web_files(folder.path()); },
              ThrowsMessage<std::runtime_error>(HasSubstr("no index.html in")));
}

TEST(WebFiles, AreLookedForWhereTheOperatorSaysFirst) {
  EXPECT_EQ(find_web_folder("/somewhere", "/usr/bin/teamsight-monitor"), "/somewhere");
}

}  // namespace
}  // namespace teamsight::monitor
