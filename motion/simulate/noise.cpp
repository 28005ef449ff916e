#include "motion/simulate/noise.hpp"

#include <cmath>

namespace secular {
namespace {

// S. Vigna's splitmix64 step as a mixing function.
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

}  // namespace

NoiseStream::NoiseStream(std::uint64_t seed, std::uint64_t record, std::uint64_t channel)
    : state_(mixed(mixed(mixed(seed) + record) + channel)) {}

std::uint64_t NoiseStream::next() {
  state_ += 0x9e3779b97f4a7c15ULL;
  return mixed(state_);
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
