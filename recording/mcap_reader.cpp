// recording/mcap_reader.cpp: see recording/mcap_reader.hpp.
#include "recording/mcap_reader.hpp"

#include <algorithm>
#include <memory>
#include <queue>
#include <utility>

#include "recording/mcap_index.hpp"

namespace teamsight::recording {
namespace {

// Chunks that lie over one another in time are held together; so much and no more.
constexpr std::uint64_t kMostHeldBytes = 512U << 20U;

constexpr std::int64_t kFirst = std::numeric_limits<std::int64_t>::min();

using Bytes = std::shared_ptr<const std::string>;

/// A message that waits for its turn; `chunk` keeps its bytes.
struct Waiting {
  MessageStamp stamp;
  std::uint16_t channel{0};
  std::uint64_t order{0};
  std::string_view payload;
  Bytes chunk;

  friend bool operator>(const Waiting& a, const Waiting& b) {
    return std::pair(a.stamp.log_ns, a.order) > std::pair(b.stamp.log_ns, b.order);
  }
};

using Queue = std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>>;

/// Lines up one chunk's messages; false if a record is broken.
bool enqueue(const Bytes& chunk, const TimeSpan& span, std::uint64_t& order, Queue& queue) {
  Unpacker records(*chunk);
  while (records.left() > 0) {
    const auto opcode = static_cast<Opcode>(records.number<std::uint8_t>());
    Unpacker content(records.raw(records.number<std::uint64_t>()));
    if (!records.is_good()) return false;
    if (opcode != Opcode::kMessage) continue;
    Waiting waiting;
    waiting.channel = content.number<std::uint16_t>();
    waiting.stamp.sequence = content.number<std::uint32_t>();
    waiting.stamp.log_ns = content.number<std::int64_t>();
    waiting.stamp.publish_ns = content.number<std::int64_t>();
    if (!content.is_good()) return false;
    waiting.payload = content.raw(content.left());
    waiting.order = order++;
    waiting.chunk = chunk;
    const bool is_inside =
        waiting.stamp.log_ns >= span.from_ns && waiting.stamp.log_ns <= span.until_ns;
    if (is_inside) queue.push(std::move(waiting));
  }
  return true;
}

/// Chunks whose messages still wait.
class HeldChunks {
 public:
  /// @return whether all that is held stays within the bound
  bool add(const Bytes& chunk) {
    std::erase_if(chunks_, [](const auto& held) { return held.expired(); });
    chunks_.push_back(chunk);
    std::uint64_t bytes = 0;
    for (const auto& held : chunks_) {
      if (const auto alive = held.lock()) bytes += alive->size();
    }
    return bytes <= kMostHeldBytes;
  }

 private:
  std::vector<std::weak_ptr<const std::string>> chunks_;
};

}  // namespace

struct McapReader::Impl {
  explicit Impl(const std::filesystem::path& path) : name(path.string()), file(path) {
    const auto magic = file.read(0, kMagic.size());
    if (!magic || *magic != kMagic) {
      throw RecordingError(name + ": no MCAP file, expected it to begin with its magic bytes");
    }
    auto found = index_by_summary(file);
    index = found ? std::move(*found) : index_by_search(file);
    std::ranges::stable_sort(index.chunks, {}, &ChunkPlace::start_ns);
  }

  [[nodiscard]] Bytes read_chunk(const ChunkPlace& place) const {
    const auto record = file.read(place.offset, place.length);
    std::optional<std::string> records;
    if (record && record->size() > kRecordHead &&
        static_cast<Opcode>((*record)[0]) == Opcode::kChunk) {
      records = open_chunk(std::string_view(*record).substr(kRecordHead));
    }
    if (!records) fail(place);
    return std::make_shared<const std::string>(std::move(*records));
  }

  [[noreturn]] void fail(const ChunkPlace& place) const {
    throw RecordingError(name + ": the chunk at byte " + std::to_string(place.offset) +
                         " is broken, expected zstd or no compression and the CRC it names");
  }

  /// Hands over what waits up to and including `until_ns`; false when `use` has enough.
  bool drain(Queue& queue,
             std::int64_t until_ns,
             const std::function<bool(const Message&)>& use) const {
    while (!queue.empty() && queue.top().stamp.log_ns <= until_ns) {
      const Waiting& next = queue.top();
      const auto channel = index.contents.channels.find(next.channel);
      const bool goes_on = channel == index.contents.channels.end() ||
                           use({&channel->second, next.stamp, next.payload});
      if (!goes_on) return false;
      queue.pop();
    }
    return true;
  }

  std::string name;
  InputFile file;
  FileIndex index;
};

McapReader::McapReader(const std::filesystem::path& file) : impl_(std::make_unique<Impl>(file)) {}

McapReader::~McapReader() = default;
McapReader::McapReader(McapReader&&) noexcept = default;
McapReader& McapReader::operator=(McapReader&&) noexcept = default;

const Contents& McapReader::contents() const {
  return impl_->index.contents;
}

void McapReader::for_each(const TimeSpan& span,
                          const std::function<bool(const Message&)>& use) const {
  Queue queue;
  std::uint64_t order = 0;
  HeldChunks held;
  for (const ChunkPlace& place : impl_->index.chunks) {
    if (place.end_ns < span.from_ns || place.start_ns > span.until_ns) continue;
    // Equal stamps keep their order: what this chunk begins with may still be joined.
    const std::int64_t before = place.start_ns == kFirst ? kFirst : place.start_ns - 1;
    if (!impl_->drain(queue, before, use)) return;
    const Bytes chunk = impl_->read_chunk(place);
    if (!held.add(chunk)) {
      throw RecordingError(impl_->name + ": too many chunks lie over one another in time");
    }
    if (!enqueue(chunk, span, order, queue)) impl_->fail(place);
  }
  static_cast<void>(impl_->drain(queue, std::numeric_limits<std::int64_t>::max(), use));
}

}  // namespace teamsight::recording
