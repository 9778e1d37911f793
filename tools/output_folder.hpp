// tools/output_folder.hpp: files that appear in a folder all together and whole, or not at all.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace teamsight::tools {

/// Collects files beside their folder and puts them there when all are written.
///
/// The destructor removes what was not put there. Other files in the folder are left alone.
class OutputFolder {
 public:
  /// @throws std::runtime_error if the place beside `folder` cannot be written
  explicit OutputFolder(const std::filesystem::path& folder);
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;
  ~OutputFolder();

  /// Writes one file. @param name  relative to the folder, may have folders of its own
  /// @throws std::runtime_error if it cannot be written whole
  void write(const std::filesystem::path& name, const std::string& text);

  /// Puts all files in their places; each one replaces its predecessor in one step.
  ///
  /// @throws std::runtime_error if a place cannot be taken
  void publish();

 private:
  std::filesystem::path folder_;
  std::filesystem::path staging_;
  std::vector<std::filesystem::path> names_;
};

}  // namespace teamsight::tools
