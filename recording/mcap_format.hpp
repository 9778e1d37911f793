// recording/mcap_format.hpp: the bytes of MCAP records: opcodes, little-endian numbers, bounds.
//
// Method: https://mcap.dev/spec; docs/references.md [MCAP].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace teamsight::recording {

inline constexpr std::string_view kMagic{"\x89MCAP0\r\n", 8};

enum class Opcode : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kStatistics = 0x0B,
  kMetadata = 0x0C,
  kMetadataIndex = 0x0D,
  kSummaryOffset = 0x0E,
  kDataEnd = 0x0F,
};

/// Bytes of a record before its content: opcode and length.
inline constexpr std::size_t kRecordHead = 9;
/// Bytes of the footer's content.
inline constexpr std::size_t kFooterBytes = 20;

/// Appends numbers and strings as MCAP writes them.
class Packer {
 public:
  explicit Packer(std::string& out) : out_(&out) {}

  template <class Number>
  Packer& number(Number value) {
    for (std::size_t i = 0; i < sizeof(Number); ++i) {
      out_->push_back(static_cast<char>((static_cast<std::uint64_t>(value) >> (8 * i)) & 0xFFU));
    }
    return *this;
  }

  Packer& text(std::string_view value) {
    number(static_cast<std::uint32_t>(value.size()));
    out_->append(value);
    return *this;
  }

  Packer& raw(std::string_view value) {
    out_->append(value);
    return *this;
  }

  Packer& pairs(const std::map<std::string, std::string>& values) {
    std::size_t bytes = 0;
    for (const auto& [key, value] : values) bytes += 8 + key.size() + value.size();
    number(static_cast<std::uint32_t>(bytes));
    for (const auto& [key, value] : values) text(key).text(value);
    return *this;
  }

 private:
  std::string* out_;
};

/// Appends a whole record.
inline void pack_record(Opcode opcode, std::string_view content, std::string& out) {
  Packer(out).number(static_cast<std::uint8_t>(opcode)).number(std::uint64_t{content.size()});
  out.append(content);
}

/// Takes numbers and strings from bytes that may be anything; once a bound is broken every answer
/// is empty and `is_good` stays false.
class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}

  template <class Number>
  [[nodiscard]] Number number() {
    if (!has(sizeof(Number))) return {};
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i) {
      value |= std::uint64_t{static_cast<unsigned char>(bytes_[i])} << (8 * i);
    }
    bytes_.remove_prefix(sizeof(Number));
    return static_cast<Number>(value);
  }

  [[nodiscard]] std::string_view raw(std::uint64_t size) {
    if (!has(size)) return {};
    const std::string_view value = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return value;
  }

  [[nodiscard]] std::string_view text() { return raw(number<std::uint32_t>()); }

  [[nodiscard]] std::map<std::string, std::string> pairs() {
    Unpacker inner(text());
    std::map<std::string, std::string> values;
    while (is_good_ && inner.is_good() && inner.left() > 0) {
      std::string key(inner.text());
      values[std::move(key)] = std::string(inner.text());
    }
    is_good_ = is_good_ && inner.is_good();
    return values;
  }

  [[nodiscard]] std::size_t left() const { return bytes_.size(); }

  [[nodiscard]] bool is_good() const { return is_good_; }

 private:
  bool has(std::uint64_t size) {
    is_good_ = is_good_ && size <= bytes_.size();
    if (!is_good_) bytes_ = {};
    return is_good_;
  }

  std::string_view bytes_;
  bool is_good_{true};
};

/// CRC-32 (zlib's polynomial) of `bytes`, going on from `before`.
[[nodiscard]] std::uint32_t crc32_of(std::string_view bytes, std::uint32_t before = 0);

/// zstd, level 3.
[[nodiscard]] std::string compressed(std::string_view bytes);

/// @param size  what it has to become, bounded by the caller
/// @return whether `bytes` are zstd and hold exactly `size` bytes, now in `out`
[[nodiscard]] bool decompress(std::string_view bytes, std::size_t size, std::string& out);

}  // namespace teamsight::recording
