#include "blind/random.hpp"

#include <cmath>
#include <numbers>

namespace secular::blind {
namespace {

constexpr std::uint64_t golden = 0x9e3779b97f4a7c15ULL;

std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

}  // namespace

Random::Random(std::uint64_t seed, std::uint64_t stream)
    : state_(mixed(mixed(seed + golden) ^ (stream * golden))) {}

std::uint64_t Random::next() {
  state_ += golden;
  return mixed(state_);
}

double Random::unit() {
  return (static_cast<double>(next() >> 11) + 0.5) * 0x1p-53;
}

double Random::uniform(double low, double high) {
  return low + (high - low) * unit();
}

double Random::log_uniform(double low, double high) {
  return low * std::exp(unit() * std::log(high / low));
}

double Random::sign() {
  return chance(0.5) ? 1.0 : -1.0;
}

bool Random::chance(double probability) {
  return unit() < probability;
}

std::size_t Random::below(std::size_t count) {
  return static_cast<std::size_t>(unit() * static_cast<double>(count));
}

double Random::gaussian() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  const double radius = std::sqrt(-2 * std::log(unit())), angle = 2 * std::numbers::pi * unit();
  spare_ = radius * std::sin(angle);
  has_spare_ = true;
  return radius * std::cos(angle);
}

}  // namespace secular::blind
