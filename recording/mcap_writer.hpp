// recording/mcap_writer.hpp: messages into the bytes of an MCAP file: chunks, indexes, summary.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace teamsight::recording {

/// How the payload of a channel is to be read.
struct Schema {
  std::string name;      ///< e.g. "teamsight.v1.RobotState"
  std::string encoding;  ///< "protobuf": data is a serialised FileDescriptorSet
  std::string data;

  friend bool operator==(const Schema&, const Schema&) = default;
};

/// One stream of messages.
struct Channel {
  std::string topic;
  std::string encoding;  ///< of the payload, e.g. "protobuf"
  Schema schema;

  friend bool operator==(const Channel&, const Channel&) = default;
};

/// When one message was recorded and written; nanoseconds.
struct MessageStamp {
  std::int64_t log_ns{0};      ///< on the recording's clock, see Recorder
  std::int64_t publish_ns{0};  ///< on the writer's own clock; log_ns if it has none
  std::uint32_t sequence{0};

  friend bool operator==(const MessageStamp&, const MessageStamp&) = default;
};

/// Writes one MCAP file [MCAP] into a sink: zstd chunks with CRC and index, statistics, summary.
///
/// What was handed to the sink after each `flush` can be read again, also if nothing follows.
class McapWriter {
 public:
  /// Takes the next bytes of the file; false if they could not all be kept.
  using Sink = std::function<bool(std::string_view)>;

  /// @param library  who writes, e.g. "teamsight 0.1.0"
  McapWriter(Sink sink, const std::string& library);

  /// @return the id to write with; channels are few and never leave
  std::uint16_t add_channel(const Channel& channel);

  /// Joins the open chunk, which is handed over when it holds kChunkBytes.
  void write(std::uint16_t channel, const MessageStamp& stamp, std::string_view payload);

  /// Facts about the file; ends the open chunk.
  void add_metadata(const std::string& name, const std::map<std::string, std::string>& values);

  /// Ends the open chunk and hands it over.
  void flush();

  /// Writes index and summary; nothing may follow.
  void finish();

  /// Whether the sink took everything up to now.
  [[nodiscard]] bool is_good() const { return is_good_; }

  /// Bytes handed to the sink.
  [[nodiscard]] std::uint64_t bytes() const { return offset_; }

  [[nodiscard]] std::uint64_t messages() const { return message_count_; }

 private:
  struct ChunkEntry {
    std::int64_t start_ns{0};
    std::int64_t end_ns{0};
    std::uint64_t offset{0};
    std::uint64_t length{0};
    std::map<std::uint16_t, std::uint64_t> index_offsets;
    std::uint64_t index_length{0};
    std::uint64_t compressed_size{0};
    std::uint64_t size{0};
  };

  struct MetadataEntry {
    std::uint64_t offset{0};
    std::uint64_t length{0};
    std::string name;
  };

  struct IndexEntry {
    std::int64_t log_ns{0};
    std::uint64_t offset{0};
  };

  void emit(std::string_view bytes);
  void emit_record(std::uint8_t opcode, std::string_view content);
  void emit_indexes(ChunkEntry& entry);
  void pack_statistics(std::string& summary) const;
  void pack_chunk_indexes(std::string& summary) const;
  void pack_metadata_indexes(std::string& summary) const;

  Sink sink_;
  bool is_good_{true};
  std::uint64_t offset_{0};
  std::uint32_t data_crc_{0};
  std::string schema_records_;
  std::string channel_records_;
  std::uint16_t schema_count_{0};
  std::uint16_t channel_count_{0};
  std::string chunk_;
  std::int64_t chunk_start_ns_{0};
  std::int64_t chunk_end_ns_{0};
  std::map<std::uint16_t, std::vector<IndexEntry>> chunk_index_;
  std::vector<ChunkEntry> chunks_;
  std::vector<MetadataEntry> metadata_;
  std::map<std::uint16_t, std::uint64_t> channel_messages_;
  std::uint64_t message_count_{0};
  std::int64_t start_ns_{0};
  std::int64_t end_ns_{0};
  std::string scratch_;
};

/// A chunk of this size is compressed and handed over.
inline constexpr std::size_t kChunkBytes = 1U << 20U;

}  // namespace teamsight::recording
