// tests/realdata/zip_file.cpp: see tests/realdata/zip_file.hpp.
#include "tests/realdata/zip_file.hpp"

#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include <zlib.h>

namespace teamsight::test {
namespace {

constexpr std::size_t kEndSize = 22;  // of the record at the end, without a comment
constexpr std::uint32_t kEndMark = 0x06054b50;
constexpr std::uint32_t kEntryMark = 0x02014b50;

/// A little-endian number at a place of the archive.
std::uint32_t number(const std::string& bytes, std::size_t at, std::size_t size) {
  if (at + size > bytes.size()) throw std::runtime_error("archive is cut off");
  std::uint32_t value = 0;
  for (std::size_t i = size; i-- > 0;) {
    value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
  }
  return value;
}

std::string inflated(const std::string& packed, std::size_t size) {
  std::string plain(size, '\0');
  z_stream stream{};
  // No zlib head around the data.
  if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) throw std::runtime_error("no memory to inflate");
  std::string input = packed;
  stream.next_in = reinterpret_cast<Bytef*>(input.data());
  stream.avail_in = static_cast<uInt>(input.size());
  stream.next_out = reinterpret_cast<Bytef*>(plain.data());
  stream.avail_out = static_cast<uInt>(plain.size());
  const int result = inflate(&stream, Z_FINISH);
  inflateEnd(&stream);
  if (result != Z_STREAM_END) throw std::runtime_error("archive does not inflate");
  return plain;
}

/// The file that one entry of the directory is about.
std::string content_of(const std::string& bytes, std::size_t entry) {
  const std::uint32_t method = number(bytes, entry + 10, 2);
  const std::uint32_t packed_size = number(bytes, entry + 20, 4);
  const std::uint32_t local = number(bytes, entry + 42, 4);
  const std::size_t begin =
      local + 30 + number(bytes, local + 26, 2) + number(bytes, local + 28, 2);
  if (begin + packed_size > bytes.size()) throw std::runtime_error("archive is cut off");
  const std::string packed = bytes.substr(begin, packed_size);
  if (method == 0) return packed;
  if (method != Z_DEFLATED) throw std::runtime_error("archive: found another way of packing");
  return inflated(packed, number(bytes, entry + 24, 4));
}

}  // namespace

void unzip(const std::filesystem::path& archive, const std::filesystem::path& folder) {
  std::ifstream in(archive, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (bytes.size() < kEndSize || number(bytes, bytes.size() - kEndSize, 4) != kEndMark) {
    throw std::runtime_error(archive.string() + ": no ZIP file without a comment");
  }
  const std::size_t end = bytes.size() - kEndSize;
  std::size_t entry = number(bytes, end + 16, 4);
  for (std::uint32_t left = number(bytes, end + 10, 2); left > 0; --left) {
    if (number(bytes, entry, 4) != kEntryMark) throw std::runtime_error("archive is damaged");
    const std::uint32_t name_size = number(bytes, entry + 28, 2);
    const std::filesystem::path name = bytes.substr(entry + 46, name_size);
    std::ofstream(folder / name.filename(), std::ios::binary) << content_of(bytes, entry);
    entry += 46 + name_size + number(bytes, entry + 30, 2) + number(bytes, entry + 32, 2);
  }
}

}  // namespace teamsight::test
