#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace secular {

enum class ByteOrder { little, big };

/// The integer of `size` (1 to 8) bytes that stands at `at`; the caller has checked that it lies inside.
inline std::uint64_t unsigned_at(std::string_view bytes, std::size_t at, std::size_t size, ByteOrder order) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t position = order == ByteOrder::big ? at + i : at + size - 1 - i;
    value = value << 8 | static_cast<unsigned char>(bytes[position]);
  }
  return value;
}

/// The same in two's complement.
inline std::int64_t signed_at(std::string_view bytes, std::size_t at, std::size_t size, ByteOrder order) {
  const auto unused = static_cast<int>(64 - 8 * size);
  return static_cast<std::int64_t>(unsigned_at(bytes, at, size, order) << unused) >> unused;
}

/// An IEEE 754 number of four or eight bytes.
inline double float_at(std::string_view bytes, std::size_t at, std::size_t size, ByteOrder order) {
  const std::uint64_t bits = unsigned_at(bytes, at, size, order);
  if (size == 4) return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
  return std::bit_cast<double>(bits);
}

inline void append_unsigned(std::string& bytes, std::uint64_t value, std::size_t size, ByteOrder order) {
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t position = order == ByteOrder::big ? size - 1 - i : i;
    bytes += static_cast<char>(value >> (8 * position) & 0xFF);
  }
}

inline void append_float(std::string& bytes, double value, std::size_t size, ByteOrder order) {
  const std::uint64_t bits =
      size == 4 ? std::bit_cast<std::uint32_t>(static_cast<float>(value)) : std::bit_cast<std::uint64_t>(value);
  append_unsigned(bytes, bits, size, order);
}

}  // namespace secular
