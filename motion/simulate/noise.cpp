#include "motion/simulate/noise.hpp"

#include <cmath>

#include "numerics/splitmix64.hpp"

namespace secular {

NoiseStream::NoiseStream(std::uint64_t seed, std::uint64_t record, std::uint64_t channel)
    : state_(splitmix64(splitmix64(splitmix64(seed) + record) + channel)) {}

std::uint64_t NoiseStream::next() {
  state_ += splitmix64_step;
  return splitmix64(state_);
}

double NoiseStream::uniform() {
  return 2 * (static_cast<double>(next() >> 11) * 0x1p-53) - 1;
}

double NoiseStream::gaussian() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  double u = 0, v = 0, s = 0;
  do {
    u = uniform();
    v = uniform();
    s = u * u + v * v;
  } while (s >= 1 || s == 0);
  const double scale = std::sqrt(-2 * std::log(s) / s);
  spare_ = v * scale;
  has_spare_ = true;
  return u * scale;
}

}  // namespace secular
