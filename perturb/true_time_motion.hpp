#pragma once

#include <array>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "perturb/derivation.hpp"
#include "perturb/graded_polynomial.hpp"
#include "perturb/substitution_arithmetic.hpp"
#include "perturb/true_time_variables.hpp"

namespace secular {

/// An expansion as functions of true time: positions, velocities and accelerations as polynomials in the
/// TrueTimeVariables, truncated in eps like the expansion. There are no multiple scales: frequencies are what the
/// relations make of them (solved_frequencies), and
///   d/dt = sum_j i f_j (power of exp(i f_j t)) + sum_k dA_k/dt d/dA_k + conjugates,
/// with dA_k/dt the sum of all eps^n D_n A_k. For ExactArithmetic and FloatingArithmetic.
template <class Arithmetic>
class TrueTimeMotion {
 public:
  using Number = typename Arithmetic::Number;
  using Series = EpsSeries<Number>;
  using Polynomial = GradedPolynomial<Number>;

  TrueTimeMotion(const Derivation& derivation, Arithmetic arithmetic);

  const TrueTimeVariables& variables() const { return variables_; }
  /// The mode's coordinate (degree 1) and its first two time derivatives.
  const Polynomial& of_mode(std::size_t mode, std::size_t derivative) const { return motion_[mode][derivative]; }
  /// d/dt as above, cut at the expansion's power of eps.
  Polynomial time_derivative(const Polynomial& p) const;
  /// The mode whose displacement or velocity, times a number, is x.
  std::optional<std::size_t> mode_of(const Polynomial& x) const;

  Polynomial zero() const { return Polynomial(static_cast<int>(size_) - 1); }
  /// value*eps^order.
  Polynomial constant(const Number& value, std::size_t order = 0) const;
  /// A frequency as the relations give it, any other symbol at its random value.
  Series symbol(const std::string& name) const;
  /// A coefficient of the expansion, whose natural and excitation frequencies move with the detunings.
  Series coefficient(const GiNaC::ex& e) const;

 private:
  Series computed(const GiNaC::ex& symbol_or_power) const;
  Polynomial in_true_time(const Derivation& d, const FieldSeries& fields, bool coordinate) const;

  const Model* model_;
  Arithmetic arithmetic_;
  std::size_t size_;
  TrueTimeVariables variables_;
  std::vector<Series> frequency_;
  std::vector<Polynomial> amplitude_rate_, conjugate_rate_;
  std::vector<std::array<Polynomial, 3>> motion_;           // [mode][derivative]
  mutable std::unordered_map<GiNaC::ex, Series> computed_;  // symbols and denominators, as far as they were met
};

}  // namespace secular
