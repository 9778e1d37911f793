// tests/layering/references_test.cpp: every source that a comment names is in docs/references.md.
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include <gmock/gmock.h>

#include "tests/layering/source_tree.hpp"

namespace teamsight::layering {
namespace {

std::string listed_references() {
  // Nothing in this program sets the environment.
  // NOLINTNEXTLINE(concurrency-mt-unsafe)
  const char* root = std::getenv("TEAMSIGHT_SOURCE_DIR");
  std::ifstream file(std::string(root == nullptr ? "." : root) + "/docs/references.md");
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(References, EveryKeyInACommentIsListed) {
  const std::regex key(R"(\[[A-Z][a-z]+\d\d[a-z]?\])");
  const std::string listed = listed_references();

  for (const SourceFile& file : source_tree()) {
    for (std::sregex_iterator found(file.text.begin(), file.text.end(), key), end; found != end;
         ++found) {
      EXPECT_THAT(listed, testing::HasSubstr("**" + found->str() + "**")) << file.path;
    }
  }
}

}  // namespace
}  // namespace teamsight::layering
