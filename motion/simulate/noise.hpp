#pragma once

#include <cstdint>

namespace secular {

/// Reproducible white Gaussian noise, the same on every platform: splitmix64 numbers through the polar method. One
/// stream for every (seed, record, channel).
class NoiseStream {
 public:
  NoiseStream(std::uint64_t seed, std::uint64_t record, std::uint64_t channel);
  double gaussian();

 private:
  std::uint64_t next();
  double uniform();  // in (-1, 1)
  std::uint64_t state_;
  double spare_ = 0;
  bool has_spare_ = false;
};

}  // namespace secular
