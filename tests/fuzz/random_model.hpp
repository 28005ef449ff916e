#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace secular::fuzz {

/// Bytes as decisions: whatever they are, something valid is chosen; where they end, the first of everything.
class Choices {
 public:
  Choices(const std::uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}
  int below(int n) { return at_ == end_ ? 0 : *at_++ % n; }

 private:
  const std::uint8_t *at_, *end_;
};

/// coefficient * number/denominator * product of powers of D^i(coordinate) * F*cos(multiple*Omega*t), or without
/// the last factor where the multiple is zero. It stands on the right of its equation.
struct RandomTerm {
  std::string coefficient;
  int number = 1, denominator = 1;
  std::vector<std::array<int, 3>> powers;  ///< [mode][derivative]
  int multiple = 0;
  bool sine = false;
  int order = 1;  ///< of eps

  bool is_forced() const { return multiple == 1 && !sine; }
};

/// sum multiples[j]*f_j = eps^order * sigma over natural frequencies and then Omega.
struct RandomRelation {
  std::vector<int> multiples;
  std::string detuning, text;
  int order = 1;
};

/// Polynomial equations of one or two modes with parametric and direct excitation, and a resonance of them.
struct RandomModel {
  std::size_t modes = 1;
  std::vector<std::vector<RandomTerm>> equations;  ///< D2(v) + w^2*v = their sum
  std::vector<RandomRelation> relations;
  int expand_to = 1;

  std::string text() const;
};

RandomModel random_model(Choices choices);

}  // namespace secular::fuzz
