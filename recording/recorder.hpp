// recording/recorder.hpp: messages onto the disk, on a thread of its own.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "geometry/time.hpp"
#include "recording/message_sink.hpp"

namespace teamsight::recording {

struct RecorderSettings {
  std::filesystem::path folder;                   ///< made if it is not there
  std::string name{"teamsight"};                  ///< files are NAME-YYYYMMDD-HHMMSS-NNN.mcap
  std::string library;                            ///< who writes, e.g. "teamsight 0.1.0"
  std::map<std::string, std::string> facts;       ///< written into every file
  std::uint64_t max_file_bytes{1U << 30U};        ///< a new file begins after so many
  Duration flush_every{std::chrono::seconds(1)};  ///< what a kill -9 can cost
  Duration retry_every{std::chrono::seconds(5)};  ///< after the disk refused
  std::size_t max_queued_bytes{64U << 20U};       ///< for a disk that stalls
  /// What to add to host time to get the file's log time. Nothing: so that it reads as a date,
  /// taken once when the recording begins; a wall clock that jumps later changes nothing.
  std::optional<Duration> log_minus_host;
};

/// What to add to host time now to get the time since 1970; other a moment later if that clock
/// jumps.
[[nodiscard]] Duration wall_minus_host();

struct RecorderReport {
  std::string file;             ///< the one that is written; empty: none now
  std::uint64_t bytes{0};       ///< in all files of this recording
  std::uint64_t messages{0};    ///< on the disk or on the way there
  std::uint64_t dropped{0};     ///< messages that found no room on the disk or in the queue
  std::uint64_t free_bytes{0};  ///< on the disk
  std::string problem;          ///< why nothing is written now; empty: all is well

  friend bool operator==(const RecorderReport&, const RecorderReport&) = default;
};

/// Records into MCAP files that follow one another. Nothing here waits for the disk: a disk that is
/// full or slow costs messages, which are counted, and never holds up the caller.
class Recorder : public MessageSink {
 public:
  /// Begins the first file.
  ///
  /// @throws RecordingError if the folder cannot be made or written
  explicit Recorder(RecorderSettings settings);

  /// Finishes the file.
  ~Recorder() override;

  ChannelId add_channel(Channel channel) override;

  [[nodiscard]] bool is_wanted(ChannelId /*channel*/) const override { return true; }

  void write(ChannelId channel, HostTime received, PeerTime stamp, std::string payload) override;
  [[nodiscard]] Duration log_minus_host() const override;

  /// Finishes the file and ends the recording; later messages are dropped.
  void finish();

  /// Any thread.
  [[nodiscard]] RecorderReport report() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace teamsight::recording
