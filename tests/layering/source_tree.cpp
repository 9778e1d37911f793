// tests/layering/source_tree.cpp: walks over the repository and reads it.
#include "tests/layering/source_tree.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace teamsight::layering {

namespace {

namespace fs = std::filesystem;

bool is_source(const fs::path& path) {
  constexpr std::string_view kExtensions[] = {".cpp", ".hpp", ".ts", ".idl", ".proto"};
  return std::ranges::find(kExtensions, path.extension().string()) != std::end(kExtensions);
}

bool is_foreign(const fs::path& folder) {
  const std::string name = folder.filename().string();
  return name == "build" || name == "node_modules" || name == "dist" || name.starts_with(".");
}

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

std::vector<SourceFile> source_tree() {
  // Nothing in this program sets the environment.
  // NOLINTNEXTLINE(concurrency-mt-unsafe)
  const char* root = std::getenv("TEAMSIGHT_SOURCE_DIR");
  if (root == nullptr) return {};
  std::vector<SourceFile> files;
  for (fs::recursive_directory_iterator entry(root), end; entry != end; ++entry) {
    if (entry->is_directory() && is_foreign(entry->path())) {
      entry.disable_recursion_pending();
    } else if (entry->is_regular_file() && is_source(entry->path())) {
      const std::string path = entry->path().lexically_relative(root).generic_string();
      files.push_back({path, text_of(entry->path())});
    }
  }
  std::ranges::sort(files, {}, &SourceFile::path);
  return files;
}

std::vector<Include> includes_of(std::string_view text) {
  constexpr std::string_view kDirective = "#include ";
  std::vector<Include> includes;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    const std::string_view line = text.substr(start, end - start);
    start = end + 1;
    if (!line.starts_with(kDirective)) continue;
    const bool in_quotes = line[kDirective.size()] == '"';
    const std::size_t from = kDirective.size() + 1;
    const std::size_t to = line.find(in_quotes ? '"' : '>', from);
    includes.push_back({std::string(line.substr(from, to - from)), in_quotes});
  }
  return includes;
}

int line_count(std::string_view text) {
  return static_cast<int>(std::ranges::count(text, '\n'));
}

std::string_view first_line(std::string_view text) {
  return text.substr(0, text.find('\n'));
}

}  // namespace teamsight::layering
