// tests/layering/source_tree.hpp: the repository's own source files, as text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace teamsight::layering {

struct SourceFile {
  std::string path;  ///< from the repository's root, with slashes
  std::string text;
};

struct Include {
  std::string header;
  bool in_quotes;  ///< "..." rather than <...>
};

/// All .cpp, .hpp, .ts, .idl and .proto files below TEAMSIGHT_SOURCE_DIR, without builds, hidden
/// folders and node_modules; by path.
[[nodiscard]] std::vector<SourceFile> source_tree();

/// What a C++ file includes, in its order.
[[nodiscard]] std::vector<Include> includes_of(std::string_view text);

/// Number of lines, and the first of them.
[[nodiscard]] int line_count(std::string_view text);
[[nodiscard]] std::string_view first_line(std::string_view text);

}  // namespace teamsight::layering
