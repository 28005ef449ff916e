#pragma once

#include <cstdint>

namespace secular {

inline constexpr std::uint64_t splitmix64_step = 0x9e3779b97f4a7c15ULL;

/// The number that splitmix64 (G. L. Steele, D. Lea, C. H. Flood, OOPSLA 2014) gives at a state; the next state is
/// a splitmix64_step further. Also a mixing function: every bit of `x` changes half of the bits.
constexpr std::uint64_t splitmix64(std::uint64_t x) {
  x += splitmix64_step;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

}  // namespace secular
