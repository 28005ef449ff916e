#include "codegen/canonical/polar_form.hpp"

#include <boost/multiprecision/cpp_int.hpp>
#include <utility>

namespace secular {

using Integer = boost::multiprecision::cpp_int;

RationalFunction scaled(const RationalFunction& value, long numerator, long denominator) {
  if (value.is_zero() || numerator == 0) return {{}, value.denominator};
  // The terms of each part are coprime: only the scale's own factors and the parts' contents can cancel.
  const auto content = [](const std::vector<PolynomialTerm>& terms) {
    Integer divisor = 0;
    for (const PolynomialTerm& term : terms)
      divisor = boost::multiprecision::gcd(divisor, Integer(term.coefficient));
    return divisor;
  };
  const auto divided = [](std::vector<PolynomialTerm> terms, const Integer& by, const Integer& times) {
    for (PolynomialTerm& term : terms) term.coefficient = Integer(Integer(term.coefficient) / by * times).str();
    return terms;
  };
  const Integer above = content(value.numerator), below = content(value.denominator);
  Integer up = above * numerator, down = below * denominator;
  if (down < 0) {
    up = -up;
    down = -down;
  }
  const Integer common = boost::multiprecision::gcd(up, down);
  return {divided(value.numerator, above, up / common), divided(value.denominator, below, down / common)};
}

PolarEquations polar_equations(const CanonicalModel& model, const CanonicalCase& resonance, std::size_t mode) {
  PolarEquations equations;
  const std::size_t modes = model.coordinates.size();
  for (const CanonicalTerm& term : resonance.slow_derivative[mode]) {
    PolarTerm polar;
    int degree = 0;
    for (std::size_t k = 0; k < modes; ++k) {
      const CanonicalPowers& p = term.powers;
      polar.amplitude.push_back(p.amplitude[k] + p.conjugate[k] + p.modulus[k]);
      degree += polar.amplitude.back();
      polar.beta.push_back(p.amplitude[k] - p.conjugate[k] - (k == mode ? 1 : 0));
    }
    polar.forcing = term.powers.forcing;
    polar.slow_phase = term.powers.slow_phase;
    bool plain = true;
    for (const int b : polar.beta) plain = plain && b == 0;
    for (const int s : polar.slow_phase) plain = plain && s == 0;
    // 2 * (1/2)^degree
    const long up = degree < 1 ? 1L << (1 - degree) : 1, down = degree > 1 ? 1L << (degree - 1) : 1;
    const auto add = [&](std::vector<PolarTerm>& list, const RationalFunction& part, long sign,
                         PolarTerm::Trigonometric function) {
      if (part.is_zero() || (plain && function == PolarTerm::Trigonometric::sine)) return;
      PolarTerm one = polar;
      one.coefficient = scaled(part, sign * up, down);
      one.function = plain ? PolarTerm::Trigonometric::one : function;
      list.push_back(std::move(one));
    };
    using enum PolarTerm::Trigonometric;
    add(equations.amplitude_rate, term.real, 1, cosine);
    add(equations.amplitude_rate, term.imaginary, -1, sine);
    add(equations.phase_rate, term.real, 1, sine);
    add(equations.phase_rate, term.imaginary, 1, cosine);
  }
  return equations;
}

}  // namespace secular
