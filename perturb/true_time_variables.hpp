#pragma once

#include <algorithm>
#include <complex>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "perturb/graded_polynomial.hpp"
#include "perturb/model.hpp"

namespace secular {

/// Where each variable of a function of true time stands in a polynomial's powers:
/// exp(i f_j t) of every frequency | A_k | conj A_k | |A_k| | degree in the coordinates | smooth functions that the
/// term came out of.
struct TrueTimeVariables {
  std::size_t frequencies = 0, modes = 0;

  std::size_t amplitude(std::size_t mode) const { return frequencies + mode; }
  std::size_t conjugate(std::size_t mode) const { return amplitude(modes) + mode; }
  std::size_t modulus(std::size_t mode) const { return conjugate(modes) + mode; }
  std::size_t degree() const { return modulus(modes); }
  std::size_t functions() const { return degree() + 1; }
  std::size_t size() const { return functions() + 1; }
};

/// Powers of the variables of one term.
using TrueTimePowers = std::vector<int>;

/// Whether |A_k| of any mode has an odd power.
bool has_odd_modulus(const TrueTimePowers& powers, const TrueTimeVariables& variables);

/// "A_v^2*conj(A_v)*exp(i*(omega+Omega)*t)".
std::string to_string(const TrueTimePowers& powers, const Model& model);

/// |A|^2 = A conj(A) used so that |A| is left to the power 0 or 1; degree and functions are dropped.
TrueTimePowers normal_form(TrueTimePowers powers, const TrueTimeVariables& variables);

/// The normal form where a term of degree d in the coordinates carries eps^(d-1): every term, or those that came
/// out of a smooth function.
template <class Number>
GradedPolynomial<Number> normal_form(const GradedPolynomial<Number>& p, const TrueTimeVariables& variables,
                                     bool all_by_degree) {
  GradedPolynomial<Number> result(static_cast<int>(p.orders().size()) - 1);
  for (std::size_t n = 0; n < p.orders().size(); ++n)
    for (const auto& [powers, value] : p.orders()[n]) {
      const bool by_degree = all_by_degree || powers[variables.functions()] > 0;
      const int later = by_degree ? std::max(0, powers[variables.degree()] - 1) : 0;
      result.add(n + static_cast<std::size_t>(later), normal_form(powers, variables), value);
    }
  return result;
}

template <class Arithmetic>
GradedPolynomial<typename Arithmetic::Number> conjugated(const GradedPolynomial<typename Arithmetic::Number>& p,
                                                         const TrueTimeVariables& variables) {
  GradedPolynomial<typename Arithmetic::Number> result(static_cast<int>(p.orders().size()) - 1);
  for (std::size_t n = 0; n < p.orders().size(); ++n)
    for (const auto& [powers, value] : p.orders()[n]) {
      TrueTimePowers mirrored = powers;
      for (std::size_t i = 0; i < variables.frequencies; ++i) mirrored[i] = -powers[i];
      for (std::size_t k = 0; k < variables.modes; ++k)
        std::swap(mirrored[variables.amplitude(k)], mirrored[variables.conjugate(k)]);
      result.add(n, mirrored, Arithmetic::conjugate(value));
    }
  return result;
}

/// Sum over amplitude powers at given A_k, by multiples of the frequencies.
std::map<TrueTimePowers, std::complex<double>> at_amplitudes(
    const std::map<TrueTimePowers, std::complex<double>>& terms, const TrueTimeVariables& variables,
    const std::vector<std::complex<double>>& amplitudes);

}  // namespace secular
