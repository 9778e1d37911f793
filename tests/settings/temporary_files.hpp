// tests/settings/temporary_files.hpp: a folder that goes away with the test, and complaints caught.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "settings/settings_error.hpp"

namespace teamsight::settings {

/// A new folder below the system's temporary one, removed at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "teamsight-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }

  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  TemporaryFolder(TemporaryFolder&&) = delete;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// Writes a file into the folder and returns its path.
  [[nodiscard]] std::filesystem::path write(const std::string& name,
                                            const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }

 private:
  std::filesystem::path path_;
};

/// What `load` says when it refuses; empty if it does not.
template <class Load>
std::string complaint_of(const Load& load) {
  try {
    load();
  } catch (const SettingsError& error) {
    return error.what();
  }
  return {};
}

/// A text, one change that spoils it, and the complaint that must follow.
struct Spoilt {
  const char* name;
  const char* good;   ///< a part of the good text ...
  const char* bad;    ///< ... and what stands there instead
  const char* place;  ///< LINE:COLUMN of the complaint
  const char* key;
  const char* found;
  const char* expected;
};

inline void PrintTo(const Spoilt& spoilt, std::ostream* out) {
  *out << spoilt.name;
}

/// `text` with the change made.
inline std::string spoil(std::string text, const Spoilt& spoilt) {
  const std::size_t at = text.find(spoilt.good);
  EXPECT_NE(at, std::string::npos) << "the good text has no " << spoilt.good;
  return at == std::string::npos ? text
                                 : text.replace(at, std::string(spoilt.good).size(), spoilt.bad);
}

/// The whole line that is expected of a spoilt file.
inline std::string expected_complaint(const std::filesystem::path& path, const Spoilt& spoilt) {
  return path.string() + ":" + spoilt.place + ": key '" + spoilt.key + "': found " + spoilt.found +
         ", expected " + spoilt.expected;
}

inline std::string name_of_spoilt(const testing::TestParamInfo<Spoilt>& test) {
  return test.param.name;
}

}  // namespace teamsight::settings
