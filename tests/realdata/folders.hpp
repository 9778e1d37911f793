// tests/realdata/folders.hpp: where the repository and the real data are.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <iostream>

namespace teamsight::test {

inline std::filesystem::path from_environment(const char* name,
                                              const std::filesystem::path& otherwise) {
  // A test has one thread when it reads its environment.
  // NOLINTNEXTLINE(concurrency-mt-unsafe)
  const char* folder = std::getenv(name);
  return folder != nullptr ? std::filesystem::path(folder) : otherwise;
}

inline std::filesystem::path source_dir() {
  return from_environment("TEAMSIGHT_SOURCE_DIR", std::filesystem::current_path());
}

inline std::filesystem::path data_dir() {
  return from_environment("TEAMSIGHT_DATA", source_dir() / ".." / "shared" / "data");
}

/// Whether that part of the real data is there; says loudly if not, for the test to be skipped.
inline bool has_data(const std::filesystem::path& part) {
  if (std::filesystem::exists(data_dir() / part)) return true;
  std::cerr << "\n*** NO REAL DATA in " << data_dir() << "; set TEAMSIGHT_DATA ***\n";
  return false;
}

}  // namespace teamsight::test
