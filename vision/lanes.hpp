// vision/lanes.hpp: several values at once, as every processor with 16-byte registers computes
// them.
//
// The compiler's own vectors: arithmetic, comparisons and conversions of all lanes; a
// comparison gives -1 in the lanes where it holds, else 0.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace teamsight::vision {

using FourFloats [[gnu::vector_size(16)]] = float;
using FourInts [[gnu::vector_size(16)]] = std::int32_t;
using FourWords [[gnu::vector_size(16)]] = std::uint32_t;
using EightHalves [[gnu::vector_size(16)]] = std::uint16_t;
using EightShorts [[gnu::vector_size(16)]] = std::int16_t;
using EightBytes [[gnu::vector_size(8)]] = std::uint8_t;
using TwoWholes [[gnu::vector_size(16)]] = std::uint64_t;
using SixteenBytes [[gnu::vector_size(16)]] = std::uint8_t;

inline constexpr std::size_t kLanes = 4;

/// As many values as `Vector` has, from anywhere in memory.
template <class Vector, class Value>
[[nodiscard]] inline Vector load_lanes(const Value* from) {
  static_assert(std::is_trivially_copyable_v<Value>);
  Vector vector;
  std::memcpy(&vector, static_cast<const void*>(from), sizeof(vector));
  return vector;
}

template <class Vector, class Value>
inline void store_lanes(const Vector& vector, Value* to) {
  static_assert(std::is_trivially_copyable_v<Value>);
  std::memcpy(static_cast<void*>(to), &vector, sizeof(vector));
}

/// Eight bytes, and eight of 0 behind them.
template <class Byte>
[[nodiscard]] inline SixteenBytes load_eight(const Byte* from) {
  static_assert(sizeof(Byte) == 1);
  std::uint64_t packed = 0;
  std::memcpy(&packed, from, sizeof(packed));
  return std::bit_cast<SixteenBytes>(TwoWholes{packed, 0});
}

/// The lanes, each from 0 to 255, as bytes.
template <class Byte>
inline void store_bytes(const FourInts& lanes, Byte* to) {
  static_assert(sizeof(Byte) == 1);
#ifdef __SSE2__
  const __m128i words = _mm_packs_epi32(reinterpret_cast<__m128i>(lanes), _mm_setzero_si128());
  const std::int32_t packed = _mm_cvtsi128_si32(_mm_packus_epi16(words, words));
#else
  const std::int32_t packed = lanes[0] | lanes[1] << 8 | lanes[2] << 16 | lanes[3] << 24;
#endif
  std::memcpy(static_cast<void*>(to), &packed, sizeof(packed));
}

/// The same for bytes.
[[nodiscard]] inline std::uint32_t bits_of(const SixteenBytes& claim) {
#ifdef __SSE2__
  return static_cast<std::uint32_t>(_mm_movemask_epi8(reinterpret_cast<__m128i>(claim)));
#else
  std::uint32_t bits = 0;
  for (std::uint32_t i = 0; i < 16; ++i) bits |= claim[i] != 0 ? 1U << i : 0U;
  return bits;
#endif
}

/// a - b, or 0 where that is less.
[[nodiscard]] inline SixteenBytes excess(const SixteenBytes& a, const SixteenBytes& b) {
#ifdef __SSE2__
  return reinterpret_cast<SixteenBytes>(
      _mm_subs_epu8(reinterpret_cast<__m128i>(a), reinterpret_cast<__m128i>(b)));
#else
  return (a - b) & std::bit_cast<SixteenBytes>(a > b);
#endif
}

/// a b of each even lane and the odd one behind it, added up.
[[nodiscard]] inline FourInts pair_products(const EightShorts& a, const EightShorts& b) {
#ifdef __SSE2__
  return reinterpret_cast<FourInts>(
      _mm_madd_epi16(reinterpret_cast<__m128i>(a), reinterpret_cast<__m128i>(b)));
#else
  return FourInts{a[0] * b[0] + a[1] * b[1],
                  a[2] * b[2] + a[3] * b[3],
                  a[4] * b[4] + a[5] * b[5],
                  a[6] * b[6] + a[7] * b[7]};
#endif
}

/// The upper sixteen bits of the products of all lanes.
[[nodiscard]] inline EightHalves high_products(const EightHalves& a, const EightHalves& b) {
#ifdef __SSE2__
  return reinterpret_cast<EightHalves>(
      _mm_mulhi_epu16(reinterpret_cast<__m128i>(a), reinterpret_cast<__m128i>(b)));
#else
  EightHalves high{};
  for (std::size_t i = 0; i < 8; ++i) {
    high[i] = static_cast<std::uint16_t>(std::uint32_t{a[i]} * b[i] >> 16U);
  }
  return high;
#endif
}

/// The same of signed lanes, rounded downwards.
[[nodiscard]] inline EightShorts high_products(const EightShorts& a, const EightShorts& b) {
#ifdef __SSE2__
  return reinterpret_cast<EightShorts>(
      _mm_mulhi_epi16(reinterpret_cast<__m128i>(a), reinterpret_cast<__m128i>(b)));
#else
  EightShorts high{};
  for (std::size_t i = 0; i < 8; ++i) high[i] = static_cast<std::int16_t>(a[i] * b[i] >> 16);
  return high;
#endif
}

/// The lanes of both, each from 0 to 255, as bytes.
[[nodiscard]] inline SixteenBytes to_bytes(const EightHalves& low, const EightHalves& high) {
#ifdef __SSE2__
  return reinterpret_cast<SixteenBytes>(
      _mm_packus_epi16(reinterpret_cast<__m128i>(low), reinterpret_cast<__m128i>(high)));
#else
  return __builtin_shufflevector(__builtin_convertvector(low, EightBytes),
                                 __builtin_convertvector(high, EightBytes),
                                 0,
                                 1,
                                 2,
                                 3,
                                 4,
                                 5,
                                 6,
                                 7,
                                 8,
                                 9,
                                 10,
                                 11,
                                 12,
                                 13,
                                 14,
                                 15);
#endif
}

/// How many bytes from the first on have this value, in whole eights.
template <class Byte>
[[nodiscard]] inline std::size_t leading_eights(std::span<const Byte> bytes, Byte value) {
  static_assert(sizeof(Byte) == 1);
  constexpr std::size_t kEight = sizeof(std::uint64_t);
  const std::uint64_t all = 0x0101010101010101 * static_cast<std::uint64_t>(value);
  std::size_t count = 0;
  for (; count + kEight <= bytes.size(); count += kEight) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, &bytes[count], kEight);
    if (eight != all) break;
  }
  return count;
}

/// One bit for each lane of a claim, the first lane's the lowest.
[[nodiscard]] inline std::uint32_t bits_of(const FourInts& claim) {
#ifdef __SSE2__
  return static_cast<std::uint32_t>(_mm_movemask_ps(reinterpret_cast<__m128>(claim)));
#else
  std::uint32_t bits = 0;
  for (std::uint32_t i = 0; i < kLanes; ++i) bits |= claim[i] != 0 ? 1U << i : 0U;
  return bits;
#endif
}

/// The lower eights of both, in turns.
[[nodiscard]] inline SixteenBytes low_in_turns(const SixteenBytes& a, const SixteenBytes& b) {
  return __builtin_shufflevector(a, b, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23);
}

/// The upper eights.
[[nodiscard]] inline SixteenBytes high_in_turns(const SixteenBytes& a, const SixteenBytes& b) {
  return __builtin_shufflevector(
      a, b, 8, 24, 9, 25, 10, 26, 11, 27, 12, 28, 13, 29, 14, 30, 15, 31);
}

/// The lower fours of both, in turns.
[[nodiscard]] inline EightShorts low_in_turns(const EightShorts& a, const EightShorts& b) {
  return __builtin_shufflevector(a, b, 0, 8, 1, 9, 2, 10, 3, 11);
}

/// The upper fours.
[[nodiscard]] inline EightShorts high_in_turns(const EightShorts& a, const EightShorts& b) {
  return __builtin_shufflevector(a, b, 4, 12, 5, 13, 6, 14, 7, 15);
}

/// Eight rows of eight. Written out, not in loops, so that they stay in registers.
using EightRows = std::array<EightShorts, 8>;

/// A third of the way from rows to columns: of an element's place, three bits for the row and three
/// for the column, the first becomes the last.
[[nodiscard]] inline EightRows turned(const EightRows& rows) {
  return {low_in_turns(rows[0], rows[4]),
          high_in_turns(rows[0], rows[4]),
          low_in_turns(rows[1], rows[5]),
          high_in_turns(rows[1], rows[5]),
          low_in_turns(rows[2], rows[6]),
          high_in_turns(rows[2], rows[6]),
          low_in_turns(rows[3], rows[7]),
          high_in_turns(rows[3], rows[7])};
}

/// Rows to columns.
[[nodiscard]] inline EightRows transposed(const EightRows& rows) {
  return turned(turned(turned(rows)));
}

/// Rows of eight bytes to columns, two of them in each.
[[nodiscard]] inline std::array<SixteenBytes, 4> columns_of(
    const std::array<SixteenBytes, 8>& rows) {
  const SixteenBytes a = low_in_turns(rows[0], rows[4]);
  const SixteenBytes b = low_in_turns(rows[1], rows[5]);
  const SixteenBytes c = low_in_turns(rows[2], rows[6]);
  const SixteenBytes d = low_in_turns(rows[3], rows[7]);
  const SixteenBytes even_low = low_in_turns(a, c);
  const SixteenBytes even_high = high_in_turns(a, c);
  const SixteenBytes odd_low = low_in_turns(b, d);
  const SixteenBytes odd_high = high_in_turns(b, d);
  return {low_in_turns(even_low, odd_low),
          high_in_turns(even_low, odd_low),
          low_in_turns(even_high, odd_high),
          high_in_turns(even_high, odd_high)};
}

}  // namespace teamsight::vision
