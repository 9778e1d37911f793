// recording/mcap_index.hpp: where the chunks of an MCAP file lie. For recording/ only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "recording/mcap_format.hpp"
#include "recording/mcap_reader.hpp"

namespace teamsight::recording {

/// A file that is read at any place; closes itself.
class InputFile {
 public:
  /// @throws RecordingError if it cannot be opened
  explicit InputFile(const std::filesystem::path& path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  [[nodiscard]] std::uint64_t size() const { return size_; }

  /// Exactly `size` bytes; nothing if they are not all there.
  [[nodiscard]] std::optional<std::string> read(std::uint64_t offset, std::uint64_t size) const;

 private:
  int descriptor_{-1};
  std::uint64_t size_{0};
};

/// One chunk in the file.
struct ChunkPlace {
  std::int64_t start_ns{0};
  std::int64_t end_ns{0};
  std::uint64_t offset{0};  ///< of its record
  std::uint64_t length{0};  ///< of its record
};

/// What index and definitions say, or what a search found.
struct FileIndex {
  Contents contents;
  std::vector<ChunkPlace> chunks;
};

/// A chunk's records, uncompressed.
///
/// @param record  content of a chunk record
/// @return nothing if it is not whole: sizes, compression or CRC are wrong
[[nodiscard]] std::optional<std::string> open_chunk(std::string_view record);

/// Takes in a schema or channel record; others are passed over. Schemas wait in `schemas`.
class Definitions {
 public:
  /// @return false if the record is broken
  [[nodiscard]] bool take(Opcode opcode, std::string_view content, Contents& contents);

 private:
  std::map<std::uint16_t, Schema> schemas_;
};

/// The index at the end of a finished file; nothing if there is no valid one.
[[nodiscard]] std::optional<FileIndex> index_by_summary(const InputFile& file);

/// The index of whatever whole records stand at the start of the file.
[[nodiscard]] FileIndex index_by_search(const InputFile& file);

}  // namespace teamsight::recording
