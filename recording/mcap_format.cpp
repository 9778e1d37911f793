// recording/mcap_format.cpp: see recording/mcap_format.hpp.
#include "recording/mcap_format.hpp"

#include <stdexcept>

#include <zlib.h>
#include <zstd.h>

namespace teamsight::recording {

namespace {

constexpr int kLevel = 3;  // denser levels take several times as long for a tenth less

}  // namespace

std::uint32_t crc32_of(std::string_view bytes, std::uint32_t before) {
  // zlib reads bytes as unsigned.
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  return static_cast<std::uint32_t>(crc32_z(before, data, bytes.size()));
}

std::string compressed(std::string_view bytes) {
  std::string out(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ZSTD_compress(out.data(), out.size(), bytes.data(), bytes.size(), kLevel);
  if (ZSTD_isError(size) != 0) throw std::runtime_error("zstd: out of memory");
  out.resize(size);
  return out;
}

bool decompress(std::string_view bytes, std::size_t size, std::string& out) {
  out.resize(size);
  const std::size_t got = ZSTD_decompress(out.data(), out.size(), bytes.data(), bytes.size());
  return ZSTD_isError(got) == 0 && got == size;
}

}  // namespace teamsight::recording
