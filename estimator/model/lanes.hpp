#pragma once

#include <cstddef>

namespace secular {

/// As many numbers side by side, for motions that are integrated together: arithmetic is that of every number for
/// itself, to the last bit, and takes about as long as that of one. (g++ and clang make pairs of them what any
/// processor of 64 bits computes at once.)
class Lanes {
 public:
  static constexpr std::size_t count = 8;

  Lanes() : Lanes(0.0) {}
  Lanes(double x) : Lanes(Pair{x, x}, Pair{x, x}, Pair{x, x}, Pair{x, x}) {}  // NOLINT: the same in all lanes

  /// value(lane) of every lane.
  template <class Value>
  static Lanes each(const Value& value) {
    return {Pair{value(0), value(1)}, Pair{value(2), value(3)}, Pair{value(4), value(5)}, Pair{value(6), value(7)}};
  }

  double operator[](std::size_t lane) const { return pair_[lane / 2][lane % 2]; }
  void set(std::size_t lane, double x) { pair_[lane / 2][lane % 2] = x; }

  friend Lanes operator+(const Lanes& a, const Lanes& b) {
    return {a.pair_[0] + b.pair_[0], a.pair_[1] + b.pair_[1], a.pair_[2] + b.pair_[2], a.pair_[3] + b.pair_[3]};
  }
  friend Lanes operator-(const Lanes& a, const Lanes& b) {
    return {a.pair_[0] - b.pair_[0], a.pair_[1] - b.pair_[1], a.pair_[2] - b.pair_[2], a.pair_[3] - b.pair_[3]};
  }
  friend Lanes operator*(const Lanes& a, const Lanes& b) {
    return {a.pair_[0] * b.pair_[0], a.pair_[1] * b.pair_[1], a.pair_[2] * b.pair_[2], a.pair_[3] * b.pair_[3]};
  }
  friend Lanes operator/(const Lanes& a, const Lanes& b) {
    return {a.pair_[0] / b.pair_[0], a.pair_[1] / b.pair_[1], a.pair_[2] / b.pair_[2], a.pair_[3] / b.pair_[3]};
  }
  friend Lanes operator-(const Lanes& a) { return {-a.pair_[0], -a.pair_[1], -a.pair_[2], -a.pair_[3]}; }

  friend Lanes absolute(const Lanes& a) {
    constexpr Bits magnitude{0x7fffffffffffffff, 0x7fffffffffffffff};
    return a.of_pairs([&](Pair x) { return Pair(Bits(x) & magnitude); });
  }
  /// -1, 0 or 1.
  friend Lanes sign_of(const Lanes& a) {
    constexpr Pair one{1, 1}, zero{0, 0};
    return a.of_pairs([&](Pair x) { return Pair(Bits(one) & Bits(x > zero)) - Pair(Bits(one) & Bits(x < zero)); });
  }

 private:
  using Pair = double __attribute__((vector_size(16)));
  using Bits = long long __attribute__((vector_size(16)));
  Lanes(Pair a, Pair b, Pair c, Pair d) : pair_{a, b, c, d} {}

  template <class Function>
  Lanes of_pairs(const Function& function) const {
    return {function(pair_[0]), function(pair_[1]), function(pair_[2]), function(pair_[3])};
  }

  Pair pair_[4];
};

/// One parameter of every lane.
struct LaneParameter : Lanes {
  bool is_nonzero = false;  ///< in any lane
};

/// The excitation signal of every lane at one instant.
struct LaneSample {
  Lanes value, first_derivative, second_derivative;
};

}  // namespace secular
