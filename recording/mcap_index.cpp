// recording/mcap_index.cpp: see recording/mcap_index.hpp.
#include "recording/mcap_index.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace teamsight::recording {
namespace {

// Larger than anything an honest recorder writes; what a hostile file could make us hold.
constexpr std::uint64_t kLargestRecord = 256U << 20U;
constexpr std::uint64_t kLargestChunk = 256U << 20U;
constexpr std::size_t kMostChannels = 4096;

/// One record at `offset`, if it is whole.
struct Record {
  Opcode opcode{};
  std::string content;
  std::uint64_t next{0};
};

std::optional<Record> record_at(const InputFile& file, std::uint64_t offset) {
  const auto head = file.read(offset, kRecordHead);
  if (!head) return std::nullopt;
  Unpacker unpacker(*head);
  Record record;
  record.opcode = static_cast<Opcode>(unpacker.number<std::uint8_t>());
  const auto size = unpacker.number<std::uint64_t>();
  if (size > kLargestRecord) return std::nullopt;
  auto content = file.read(offset + kRecordHead, size);
  if (!content) return std::nullopt;
  record.content = std::move(*content);
  record.next = offset + kRecordHead + size;
  return record;
}

bool take_statistics(std::string_view content, Contents& contents) {
  Unpacker unpacker(content);
  contents.messages = unpacker.number<std::uint64_t>();
  static_cast<void>(unpacker.raw(2 + 4 + 4 + 4 + 4));
  contents.span.from_ns = unpacker.number<std::int64_t>();
  contents.span.until_ns = unpacker.number<std::int64_t>();
  Unpacker counts(unpacker.text());
  while (counts.left() > 0) {
    const auto channel = counts.number<std::uint16_t>();
    contents.message_counts[channel] = counts.number<std::uint64_t>();
  }
  return unpacker.is_good() && counts.is_good();
}

bool take_chunk_index(std::string_view content, std::vector<ChunkPlace>& chunks) {
  Unpacker unpacker(content);
  ChunkPlace place;
  place.start_ns = unpacker.number<std::int64_t>();
  place.end_ns = unpacker.number<std::int64_t>();
  place.offset = unpacker.number<std::uint64_t>();
  place.length = unpacker.number<std::uint64_t>();
  chunks.push_back(place);
  return unpacker.is_good() && place.length <= kLargestRecord;
}

bool take_metadata(std::string_view content, Contents& contents) {
  Unpacker unpacker(content);
  std::string name(unpacker.text());
  contents.metadata[std::move(name)] = unpacker.pairs();
  return unpacker.is_good();
}

bool take_header(std::string_view content, Contents& contents) {
  Unpacker unpacker(content);
  static_cast<void>(unpacker.text());
  contents.library = std::string(unpacker.text());
  return unpacker.is_good();
}

/// Walks over the records of a summary or of a chunk until one is broken or refused.
template <class Use>
bool for_each_record(std::string_view bytes, const Use& use) {
  Unpacker unpacker(bytes);
  while (unpacker.left() > 0) {
    const auto opcode = static_cast<Opcode>(unpacker.number<std::uint8_t>());
    const std::string_view content = unpacker.raw(unpacker.number<std::uint64_t>());
    if (!unpacker.is_good() || !use(opcode, content)) return false;
  }
  return true;
}

bool take_summary(const InputFile& file, std::string_view summary, FileIndex& index) {
  Definitions definitions;
  return for_each_record(summary, [&](Opcode opcode, std::string_view content) {
    if (opcode == Opcode::kStatistics) return take_statistics(content, index.contents);
    if (opcode == Opcode::kChunkIndex) return take_chunk_index(content, index.chunks);
    if (opcode == Opcode::kMetadataIndex) {
      Unpacker unpacker(content);
      const auto record = record_at(file, unpacker.number<std::uint64_t>());
      return record && record->opcode == Opcode::kMetadata &&
             take_metadata(record->content, index.contents);
    }
    return definitions.take(opcode, content, index.contents);
  });
}

/// Notes the messages of one opened chunk.
bool take_messages(std::string_view records, Definitions& definitions, Contents& contents) {
  return for_each_record(records, [&](Opcode opcode, std::string_view content) {
    if (opcode != Opcode::kMessage) return definitions.take(opcode, content, contents);
    Unpacker unpacker(content);
    const auto channel = unpacker.number<std::uint16_t>();
    static_cast<void>(unpacker.number<std::uint32_t>());
    const auto log_ns = unpacker.number<std::int64_t>();
    const bool is_first = contents.messages == 0;
    contents.span.from_ns = is_first ? log_ns : std::min(contents.span.from_ns, log_ns);
    contents.span.until_ns = is_first ? log_ns : std::max(contents.span.until_ns, log_ns);
    ++contents.message_counts[channel];
    ++contents.messages;
    return unpacker.is_good() && contents.channels.contains(channel);
  });
}

/// @return why the search ends here; empty to go on
std::string search_chunk(const Record& record,
                         std::uint64_t offset,
                         Definitions& definitions,
                         FileIndex& index) {
  const auto records = open_chunk(record.content);
  if (!records) return "a chunk at byte " + std::to_string(offset) + " is not whole";
  Contents with_chunk = index.contents;  // nothing of a chunk counts unless all of it does
  if (!take_messages(*records, definitions, with_chunk)) {
    return "a chunk at byte " + std::to_string(offset) + " holds a broken record";
  }
  index.contents = std::move(with_chunk);
  Unpacker times(record.content);
  const auto start_ns = times.number<std::int64_t>();
  const auto end_ns = times.number<std::int64_t>();
  index.chunks.push_back({start_ns, end_ns, offset, record.next - offset});
  return {};
}

}  // namespace

InputFile::InputFile(const std::filesystem::path& path)
    : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
  struct stat facts {};

  if (descriptor_ < 0 || ::fstat(descriptor_, &facts) != 0) {
    throw RecordingError(path.string() + ": " + std::generic_category().message(errno));
  }
  size_ = static_cast<std::uint64_t>(std::max<off_t>(facts.st_size, 0));
}

InputFile::~InputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::optional<std::string> InputFile::read(std::uint64_t offset, std::uint64_t size) const {
  if (offset > size_ || size > size_ - offset) return std::nullopt;
  std::string bytes(size, '\0');
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t got = ::pread(
        descriptor_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return std::nullopt;
    done += static_cast<std::size_t>(got);
  }
  return bytes;
}

std::optional<std::string> open_chunk(std::string_view record) {
  Unpacker unpacker(record);
  static_cast<void>(unpacker.raw(16));
  const auto size = unpacker.number<std::uint64_t>();
  const auto crc = unpacker.number<std::uint32_t>();
  const std::string_view compression = unpacker.text();
  const std::string_view packed = unpacker.raw(unpacker.number<std::uint64_t>());
  if (!unpacker.is_good() || size > kLargestChunk) return std::nullopt;
  std::string records;
  if (compression.empty()) {
    records = packed;
  } else if (compression != "zstd" || !decompress(packed, size, records)) {
    return std::nullopt;
  }
  if (records.size() != size) return std::nullopt;
  if (crc != 0 && crc != crc32_of(records)) return std::nullopt;
  return records;
}

bool Definitions::take(Opcode opcode, std::string_view content, Contents& contents) {
  Unpacker unpacker(content);
  if (opcode == Opcode::kSchema) {
    const auto id = unpacker.number<std::uint16_t>();
    Schema schema;
    schema.name = unpacker.text();
    schema.encoding = unpacker.text();
    schema.data = unpacker.text();
    if (schemas_.size() < kMostChannels) schemas_[id] = std::move(schema);
  } else if (opcode == Opcode::kChannel) {
    const auto id = unpacker.number<std::uint16_t>();
    const auto schema = unpacker.number<std::uint16_t>();
    Channel channel;
    channel.topic = unpacker.text();
    channel.encoding = unpacker.text();
    if (const auto found = schemas_.find(schema); found != schemas_.end()) {
      channel.schema = found->second;
    } else if (schema != 0) {
      return false;
    }
    if (contents.channels.size() < kMostChannels) contents.channels[id] = std::move(channel);
  }
  return unpacker.is_good();
}

std::optional<FileIndex> index_by_summary(const InputFile& file) {
  constexpr std::uint64_t kTail = kRecordHead + kFooterBytes + kMagic.size();
  if (file.size() < kTail) return std::nullopt;
  const std::uint64_t footer_at = file.size() - kTail;
  const auto tail = file.read(footer_at, kTail);
  if (!tail || !tail->ends_with(kMagic)) return std::nullopt;
  Unpacker unpacker(*tail);
  const auto opcode = static_cast<Opcode>(unpacker.number<std::uint8_t>());
  const auto size = unpacker.number<std::uint64_t>();
  const auto start = unpacker.number<std::uint64_t>();
  static_cast<void>(unpacker.number<std::uint64_t>());
  const auto crc = unpacker.number<std::uint32_t>();
  const bool is_footer = opcode == Opcode::kFooter && size == kFooterBytes;
  if (!is_footer || start == 0 || start > footer_at) return std::nullopt;
  if (footer_at - start > kLargestRecord) return std::nullopt;
  const auto summary = file.read(start, footer_at - start);
  if (!summary) return std::nullopt;
  const std::string_view footer(tail->data(), kRecordHead + kFooterBytes - 4);
  if (crc != 0 && crc != crc32_of(footer, crc32_of(*summary))) return std::nullopt;
  FileIndex index;
  if (!take_summary(file, *summary, index)) return std::nullopt;
  const auto header = record_at(file, kMagic.size());
  if (!header || !take_header(header->content, index.contents)) return std::nullopt;
  index.contents.file_bytes = file.size();
  return index;
}

FileIndex index_by_search(const InputFile& file) {
  FileIndex index;
  Definitions definitions;
  std::uint64_t offset = kMagic.size();
  std::string& damage = index.contents.damage;
  while (damage.empty()) {
    const auto record = record_at(file, offset);
    if (!record) {
      damage = offset == file.size() ? "the file ends without a summary"
                                     : "the file ends within a record";
      break;
    }
    bool is_good = true;
    switch (record->opcode) {
      case Opcode::kHeader:
        is_good = take_header(record->content, index.contents);
        break;
      case Opcode::kMetadata:
        is_good = take_metadata(record->content, index.contents);
        break;
      case Opcode::kChunk:
        damage = search_chunk(*record, offset, definitions, index);
        break;
      case Opcode::kDataEnd:
        damage = "the summary is broken";
        break;
      default:
        is_good = definitions.take(record->opcode, record->content, index.contents);
    }
    if (!is_good) damage = "a record at byte " + std::to_string(offset) + " is broken";
    offset = record->next;
  }
  index.contents.file_bytes = file.size();
  return index;
}

}  // namespace teamsight::recording
