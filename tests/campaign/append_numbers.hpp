#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>

#include "measure/formats/stored_numbers.hpp"

namespace secular {

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
