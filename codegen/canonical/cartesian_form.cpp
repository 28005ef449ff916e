#include "codegen/canonical/cartesian_form.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <utility>

#include "codegen/canonical/polar_form.hpp"

namespace secular {
namespace {

// Real and imaginary part of the monomial prod (x_k + i y_k)^n_k (x_k - i y_k)^m_k with n_k or m_k zero.
using IntegerPolynomial = std::map<std::vector<int>, long>;  // powers x_0, y_0, x_1, ... -> integer

std::array<IntegerPolynomial, 2> expanded(const std::vector<int>& surplus) {
  const std::size_t modes = surplus.size();
  std::map<std::vector<int>, std::pair<long, long>> polynomial{{std::vector<int>(2 * modes, 0), {1, 0}}};
  for (std::size_t k = 0; k < modes; ++k) {
    const long sign = surplus[k] > 0 ? 1 : -1;
    for (int n = 0; n < std::abs(surplus[k]); ++n) {
      std::map<std::vector<int>, std::pair<long, long>> product;
      for (const auto& [exponents, value] : polynomial) {
        std::vector<int> with_x = exponents, with_y = exponents;
        ++with_x[2 * k];
        ++with_y[2 * k + 1];
        auto& x = product[with_x];
        x = {x.first + value.first, x.second + value.second};
        auto& y = product[with_y];  // times +-i
        y = {y.first - sign * value.second, y.second + sign * value.first};
      }
      polynomial = std::move(product);
    }
  }
  std::array<IntegerPolynomial, 2> parts;
  for (const auto& [exponents, value] : polynomial) {
    if (value.first != 0) parts[0][exponents] = value.first;
    if (value.second != 0) parts[1][exponents] = value.second;
  }
  return parts;
}

}  // namespace

CartesianEquations cartesian_equations(const CanonicalModel& model, const CanonicalCase& resonance,
                                       std::size_t mode) {
  CartesianEquations equations;
  const std::size_t modes = model.coordinates.size();
  for (const CanonicalTerm& term : resonance.slow_derivative[mode]) {
    const CanonicalPowers& powers = term.powers;
    CartesianTerm common;
    common.forcing = powers.forcing;
    common.norm = powers.modulus;
    std::vector<int> surplus;
    int halves = 0;
    for (std::size_t k = 0; k < modes; ++k) {
      common.norm_squared.push_back(std::min(powers.amplitude[k], powers.conjugate[k]));
      surplus.push_back(powers.amplitude[k] - powers.conjugate[k]);
      halves += powers.amplitude[k] + powers.conjugate[k] + powers.modulus[k];
    }
    // d(x + i y)/dt = 2 (real + i imaginary) * monomial
    const long up = halves < 1 ? 1L << (1 - halves) : 1, down = halves > 1 ? 1L << (halves - 1) : 1;
    const auto add = [&](std::vector<CartesianTerm>& sum, const RationalFunction& part, long value,
                         const std::vector<int>& exponents) {
      if (part.is_zero()) return;
      CartesianTerm one = common;
      one.coefficient = scaled(part, value * up, down);
      for (std::size_t k = 0; k < modes; ++k) {
        one.x.push_back(exponents[2 * k]);
        one.y.push_back(exponents[2 * k + 1]);
      }
      sum.push_back(std::move(one));
    };
    const auto [real, imaginary] = expanded(surplus);
    for (const auto& [exponents, value] : real) {
      add(equations.x_rate, term.real, value, exponents);
      add(equations.y_rate, term.imaginary, value, exponents);
    }
    for (const auto& [exponents, value] : imaginary) {
      add(equations.x_rate, term.imaginary, -value, exponents);
      add(equations.y_rate, term.real, value, exponents);
    }
  }
  return equations;
}

std::vector<CanonicalRatio> frame_offset(const CanonicalCase& resonance, std::size_t mode) {
  std::vector<CanonicalRatio> offset = resonance.observed_frequency[mode];
  offset[mode].numerator -= offset[mode].denominator;
  return offset;
}

}  // namespace secular
