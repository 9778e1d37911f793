// recording/mcap_reader.hpp: the messages of an MCAP file, in order, also of one that was cut off.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "recording/mcap_writer.hpp"

namespace teamsight::recording {

/// The file cannot be read; one line that names it, what was found and what was expected.
class RecordingError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// One message; the views end with the call that hands them over.
struct Message {
  const Channel* channel{nullptr};
  MessageStamp stamp;
  std::string_view payload;
};

/// A span of the recording's clock, both ends included; nanoseconds.
struct TimeSpan {
  std::int64_t from_ns{std::numeric_limits<std::int64_t>::min()};
  std::int64_t until_ns{std::numeric_limits<std::int64_t>::max()};

  friend bool operator==(const TimeSpan&, const TimeSpan&) = default;
};

/// What a file holds.
struct Contents {
  std::string library;  ///< who wrote it
  std::map<std::uint16_t, Channel> channels;
  std::map<std::uint16_t, std::uint64_t> message_counts;  ///< by channel
  std::map<std::string, std::map<std::string, std::string>> metadata;
  TimeSpan span{0, 0};  ///< of the messages; both 0 if there are none
  std::uint64_t messages{0};
  std::uint64_t file_bytes{0};
  /// Why the end is missing, e.g. "the file ends within a record"; empty for a finished file.
  std::string damage;
};

/// Reads an MCAP file [MCAP] whose chunks are zstd or not compressed.
///
/// A finished file is read by its index. One without a valid summary (kill -9, full disk) is
/// searched from the start: every whole chunk before the first damage counts. Whatever the bytes
/// are, nothing is read beyond them and memory stays bounded.
class McapReader {
 public:
  /// @throws RecordingError if it cannot be opened or is no MCAP file
  explicit McapReader(const std::filesystem::path& file);
  ~McapReader();
  McapReader(McapReader&&) noexcept;
  McapReader& operator=(McapReader&&) noexcept;
  McapReader(const McapReader&) = delete;
  McapReader& operator=(const McapReader&) = delete;

  [[nodiscard]] const Contents& contents() const;

  /// Calls `use` for each message in `span`, by log time, equal times as they were written, until
  /// it returns false.
  ///
  /// @throws RecordingError for a chunk whose CRC or content is wrong
  void for_each(const TimeSpan& span, const std::function<bool(const Message&)>& use) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace teamsight::recording
