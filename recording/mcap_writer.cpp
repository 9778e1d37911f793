// recording/mcap_writer.cpp: see recording/mcap_writer.hpp.
#include "recording/mcap_writer.hpp"

#include <algorithm>
#include <utility>

#include "recording/mcap_format.hpp"

namespace teamsight::recording {
namespace {

std::uint8_t code(Opcode opcode) {
  return static_cast<std::uint8_t>(opcode);
}

std::string counts_by_channel(const std::map<std::uint16_t, std::uint64_t>& values) {
  std::string out;
  Packer packer(out);
  packer.number(static_cast<std::uint32_t>(values.size() * 10));
  for (const auto& [channel, value] : values) packer.number(channel).number(value);
  return out;
}

}  // namespace

McapWriter::McapWriter(Sink sink, const std::string& library) : sink_(std::move(sink)) {
  emit(kMagic);
  std::string header;
  Packer(header).text("").text(library);
  emit_record(code(Opcode::kHeader), header);
}

void McapWriter::emit(std::string_view bytes) {
  is_good_ = is_good_ && sink_(bytes);
  offset_ += bytes.size();
  data_crc_ = crc32_of(bytes, data_crc_);
}

void McapWriter::emit_record(std::uint8_t opcode, std::string_view content) {
  scratch_.clear();
  pack_record(static_cast<Opcode>(opcode), content, scratch_);
  emit(scratch_);
}

std::uint16_t McapWriter::add_channel(const Channel& channel) {
  const auto schema = ++schema_count_;  // 0 means "none"
  const auto id = channel_count_++;
  std::string content;
  Packer(content)
      .number(schema)
      .text(channel.schema.name)
      .text(channel.schema.encoding)
      .text(channel.schema.data);
  pack_record(Opcode::kSchema, content, schema_records_);
  pack_record(Opcode::kSchema, content, chunk_);
  content.clear();
  Packer(content).number(id).number(schema).text(channel.topic).text(channel.encoding).pairs({});
  pack_record(Opcode::kChannel, content, channel_records_);
  pack_record(Opcode::kChannel, content, chunk_);
  return id;
}

void McapWriter::write(std::uint16_t channel, const MessageStamp& stamp, std::string_view payload) {
  const bool is_first = chunk_index_.empty();
  chunk_start_ns_ = is_first ? stamp.log_ns : std::min(chunk_start_ns_, stamp.log_ns);
  chunk_end_ns_ = is_first ? stamp.log_ns : std::max(chunk_end_ns_, stamp.log_ns);
  start_ns_ = message_count_ == 0 ? stamp.log_ns : std::min(start_ns_, stamp.log_ns);
  end_ns_ = message_count_ == 0 ? stamp.log_ns : std::max(end_ns_, stamp.log_ns);
  chunk_index_[channel].push_back({stamp.log_ns, chunk_.size()});
  Packer(chunk_)
      .number(code(Opcode::kMessage))
      .number(std::uint64_t{22 + payload.size()})
      .number(channel)
      .number(stamp.sequence)
      .number(stamp.log_ns)
      .number(stamp.publish_ns)
      .raw(payload);
  ++channel_messages_[channel];
  ++message_count_;
  if (chunk_.size() >= kChunkBytes) flush();
}

void McapWriter::flush() {
  if (chunk_.empty()) return;
  ChunkEntry entry;
  const std::string records = compressed(chunk_);
  entry.start_ns = chunk_index_.empty() ? 0 : chunk_start_ns_;
  entry.end_ns = chunk_index_.empty() ? 0 : chunk_end_ns_;
  entry.size = chunk_.size();
  entry.compressed_size = records.size();
  std::string content;
  Packer(content)
      .number(entry.start_ns)
      .number(entry.end_ns)
      .number(entry.size)
      .number(crc32_of(chunk_))
      .text("zstd")
      .number(entry.compressed_size)
      .raw(records);
  entry.offset = offset_;
  emit_record(code(Opcode::kChunk), content);
  entry.length = offset_ - entry.offset;
  emit_indexes(entry);
  chunks_.push_back(std::move(entry));
  chunk_.clear();
  chunk_index_.clear();
}

void McapWriter::emit_indexes(ChunkEntry& entry) {
  const std::uint64_t begin = offset_;
  for (auto& [channel, messages] : chunk_index_) {
    std::ranges::stable_sort(messages, {}, &IndexEntry::log_ns);
    std::string content;
    Packer packer(content);
    packer.number(channel).number(static_cast<std::uint32_t>(messages.size() * 16));
    for (const IndexEntry& message : messages) packer.number(message.log_ns).number(message.offset);
    entry.index_offsets[channel] = offset_;
    emit_record(code(Opcode::kMessageIndex), content);
  }
  entry.index_length = offset_ - begin;
}

void McapWriter::add_metadata(const std::string& name,
                              const std::map<std::string, std::string>& values) {
  flush();
  MetadataEntry entry;
  entry.offset = offset_;
  entry.name = name;
  std::string content;
  Packer(content).text(name).pairs(values);
  emit_record(code(Opcode::kMetadata), content);
  entry.length = offset_ - entry.offset;
  metadata_.push_back(std::move(entry));
}

void McapWriter::pack_statistics(std::string& summary) const {
  std::string content;
  Packer(content)
      .number(message_count_)
      .number(schema_count_)
      .number(std::uint32_t{channel_count_})
      .number(std::uint32_t{0})
      .number(static_cast<std::uint32_t>(metadata_.size()))
      .number(static_cast<std::uint32_t>(chunks_.size()))
      .number(start_ns_)
      .number(end_ns_)
      .raw(counts_by_channel(channel_messages_));
  pack_record(Opcode::kStatistics, content, summary);
}

void McapWriter::pack_chunk_indexes(std::string& summary) const {
  for (const ChunkEntry& chunk : chunks_) {
    std::string content;
    Packer(content)
        .number(chunk.start_ns)
        .number(chunk.end_ns)
        .number(chunk.offset)
        .number(chunk.length)
        .raw(counts_by_channel(chunk.index_offsets))
        .number(chunk.index_length)
        .text("zstd")
        .number(chunk.compressed_size)
        .number(chunk.size);
    pack_record(Opcode::kChunkIndex, content, summary);
  }
}

void McapWriter::pack_metadata_indexes(std::string& summary) const {
  for (const MetadataEntry& entry : metadata_) {
    std::string content;
    Packer(content).number(entry.offset).number(entry.length).text(entry.name);
    pack_record(Opcode::kMetadataIndex, content, summary);
  }
}

void McapWriter::finish() {
  flush();
  std::string end;
  Packer(end).number(data_crc_);
  emit_record(code(Opcode::kDataEnd), end);

  const std::uint64_t summary_start = offset_;
  std::string summary;
  std::string offsets;
  const auto group = [&](Opcode opcode, const auto& pack) {
    const std::uint64_t begin = summary.size();
    pack();
    if (summary.size() == begin) return;
    std::string content;
    Packer(content)
        .number(code(opcode))
        .number(summary_start + begin)
        .number(summary.size() - begin);
    pack_record(Opcode::kSummaryOffset, content, offsets);
  };
  group(Opcode::kSchema, [&]() { summary += schema_records_; });
  group(Opcode::kChannel, [&]() { summary += channel_records_; });
  group(Opcode::kStatistics, [&]() { pack_statistics(summary); });
  group(Opcode::kChunkIndex, [&]() { pack_chunk_indexes(summary); });
  group(Opcode::kMetadataIndex, [&]() { pack_metadata_indexes(summary); });
  const std::uint64_t offsets_start = summary_start + summary.size();
  summary += offsets;
  Packer(summary)
      .number(code(Opcode::kFooter))
      .number(std::uint64_t{kFooterBytes})
      .number(summary_start)
      .number(offsets_start);
  Packer(summary).number(crc32_of(summary)).raw(kMagic);
  emit(summary);
}

}  // namespace teamsight::recording
