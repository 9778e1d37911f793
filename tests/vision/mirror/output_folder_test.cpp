// tests/vision/mirror/output_folder_test.cpp: files appear whole and together, or not at all.
#include "tools/output_folder.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>

#include <gmock/gmock.h>

#include "tests/support/process.hpp"

namespace teamsight::tools {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::size_t count_in(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::recursive_directory_iterator(folder), fs::recursive_directory_iterator()));
}

TEST(OutputFolder, ShowsNothingBeforeItIsPublished) {
  const test::TempDirectory place;
  OutputFolder out(place.path() / "a" / "b");

  out.write("sub/one.txt", "one");
  EXPECT_FALSE(fs::exists(place.path() / "a" / "b"));
  out.publish();

  EXPECT_EQ(content_of(place.path() / "a" / "b" / "sub" / "one.txt"), "one");
}

TEST(OutputFolder, LeavesNothingBehindIfItIsNotPublished) {
  const test::TempDirectory place;

  { OutputFolder(place.path() / "out").write("one.txt", "one"); }

  EXPECT_EQ(count_in(place.path()), 0U);
}

TEST(OutputFolder, ReplacesItsOwnFilesAndLeavesOthersAlone) {
  const test::TempDirectory place;
  static_cast<void>(place.write("mine.txt", "mine"));
  static_cast<void>(place.write("one.txt", "old"));

  OutputFolder out(place.path().string() + "/");
  out.write("one.txt", "new");
  out.publish();

  EXPECT_EQ(content_of(place.path() / "mine.txt"), "mine");
  EXPECT_EQ(content_of(place.path() / "one.txt"), "new");
}

TEST(OutputFolder, RefusesAFileInItsPlace) {
  const test::TempDirectory place;
  const fs::path file = place.write("taken", "mine");

  EXPECT_THROW(OutputFolder{file}, std::runtime_error);
  EXPECT_THROW(OutputFolder{file / "below"}, std::runtime_error);
  EXPECT_EQ(content_of(file), "mine");
}

}  // namespace
}  // namespace teamsight::tools
