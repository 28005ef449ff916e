#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
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

}  // namespace secular
