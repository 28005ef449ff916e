#include "codegen/canonical/amplitude_derivative.hpp"

namespace secular {

std::optional<WeightedPowers> amplitude_derivative(const CanonicalPowers& powers, std::size_t mode,
                                                   bool by_conjugate) {
  WeightedPowers result{{}, powers};
  int& own = (by_conjugate ? result.powers.conjugate : result.powers.amplitude)[mode];
  int& other = (by_conjugate ? result.powers.amplitude : result.powers.conjugate)[mode];
  int& modulus = result.powers.modulus[mode];
  const int twice = 2 * own + modulus;
  if (twice == 0) return std::nullopt;
  result.weight = twice % 2 == 0 ? CanonicalRatio{twice / 2, 1} : CanonicalRatio{twice, 2};
  if (own > 0) {
    --own;
  } else {
    ++other;
    modulus -= 2;
  }
  return result;
}

}  // namespace secular
