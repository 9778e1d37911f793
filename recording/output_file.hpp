// recording/output_file.hpp: a file that is written from start to end. For recording/ only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace teamsight::recording {

/// Writes at the end, remembers the first failure, closes itself.
class OutputFile {
 public:
  /// A new file; one that exists is never touched. See `problem`.
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  /// @return whether all bytes were taken; after a failure nothing is written any more
  bool write(std::string_view bytes);

  /// Asks for everything to be on the disk.
  void sync();

  /// What the system said, with the file's name; empty while all is well.
  [[nodiscard]] const std::string& problem() const { return problem_; }

  /// Whether it could not even be made because the name is taken.
  [[nodiscard]] bool exists_already() const { return exists_already_; }

 private:
  void fail(int error);

  std::string name_;
  int descriptor_{-1};
  std::string problem_;
  bool exists_already_{false};
};

}  // namespace teamsight::recording
