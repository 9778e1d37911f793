// tests/bus/files.hpp: profiles for tests: those of the repository, and files made for one test.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <unistd.h>

namespace teamsight::bus::testing {

/// config/dds/<name> of the repository.
inline std::string profile_path(const std::string& name) {
  const char* const root = std::getenv("TEAMSIGHT_SOURCE_DIR");
  return std::string(root != nullptr ? root : ".") + "/config/dds/" + name;
}

inline std::string text_of(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// A file with this text, gone with the object.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& text) {
    std::string pattern =
        (std::filesystem::temp_directory_path() / "teamsight-bus-XXXXXX").string();
    const int descriptor = mkstemp(pattern.data());
    path_ = pattern;
    ::close(descriptor);
    std::ofstream(path_) << text;
  }

  ~TemporaryFile() { std::filesystem::remove(path_); }

  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace teamsight::bus::testing
