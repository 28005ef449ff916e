#include "codegen/rational_function.hpp"

#include <algorithm>

namespace secular {
namespace {

bool is_number(const std::vector<PolynomialTerm>& polynomial) {
  return polynomial.empty() ||
         (polynomial.size() == 1 && std::all_of(polynomial.front().exponents.begin(),
                                                polynomial.front().exponents.end(), [](int e) { return e == 0; }));
}

}  // namespace

bool RationalFunction::denominator_is_number() const {
  return is_number(denominator);
}

bool RationalFunction::is_constant() const {
  return is_number(numerator) && is_number(denominator);
}

bool RationalFunction::is_one() const {
  return is_constant() && !numerator.empty() && numerator.front().coefficient == denominator.front().coefficient;
}

}  // namespace secular
