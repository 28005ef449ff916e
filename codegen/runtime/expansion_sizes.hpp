#pragma once

#include <complex>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"
#include "codegen/runtime/formula_set.hpp"
#include "codegen/runtime/monomial.hpp"
#include "codegen/runtime/rest_value_set.hpp"

namespace secular {

/// How much each order of a case's expansion contributes at a state, and whether the expansion still says something
/// there. An order's size is the sum of the moduli of its terms, phases left out, so that terms of one order that
/// happen to cancel do not hide it. Needs CanonicalContent::all; `model` and `resonance` need not outlive it.
class ExpansionSizes {
 public:
  ExpansionSizes(const CanonicalModel& model, const CanonicalCase& resonance);

  /// Arrays as for CompiledCase::modulation.
  struct State {
    const double* parameters;
    const double* excitation_frequency;
    const std::complex<double>* amplitude;
    const std::complex<double>* forcing;
  };
  /// An asymptotic series ends with its smallest term: whether in some mode the nonlinear terms of the last order
  /// of the displacement exceed every order before, A itself included. (Every one, since orders may vanish by
  /// symmetry or for want of a coefficient. Orders of dA/dt are no such measure: what the model counts as small of
  /// first order, a damping perhaps, may be smaller than what it counts as second.) Linear terms of the last order
  /// are as large as the orders that the model gives its parameters, whatever the amplitude: they are no sign.
  bool outside(const State& state) const;

  /// [mode]: size of the largest order of dA/dt, of its terms that are not linear in amplitudes and excitation; of
  /// a mode without any of these, of all its terms. What an expansion leaves out is to be smaller than that. (Than
  /// its largest order, since the last one may be small by symmetry or for want of a coefficient.)
  std::vector<double> largest_rates(const State& state) const;
  /// [mode]: the same of all terms of dA/dt.
  std::vector<double> all_rates(const State& state) const;
  /// Whether dA/dt is a sum of terms, as largest_rates needs it; not where it takes quadrature.
  bool tells_rates() const { return tells_rates_; }
  /// Whether terms that are not linear in amplitudes and excitation vanish beside those that are as all of these
  /// shrink; not with dry friction.
  bool linear_when_small() const { return linear_when_small_; }
  /// Of the displacement's part without amplitudes and excitation, all modes: a constant force moves the rest
  /// position.
  double rest_size(const State& state) const;

 private:
  struct Term {
    std::size_t mode = 0, order = 0;
    std::size_t real = 0, imaginary = 0;  ///< in formulas_
    int degree = 1;                       ///< in amplitudes and excitation together
    Monomial monomial;
  };
  /// [mode][order]: sums of moduli of the terms that `counts` says to count.
  template <class Counts>
  std::vector<double> largest_order(const State& state, const Counts& counts) const;
  template <class Counts>
  std::vector<std::vector<double>> sizes(const std::vector<Term>& terms, const State& state,
                                         const Counts& counts) const;

  std::size_t modes_, excitations_, symbols_, last_;  // last_: order
  bool tells_rates_, linear_when_small_;
  std::vector<std::size_t> symbol_of_parameter_;
  FormulaSet formulas_;
  RestValueSet rest_values_;
  std::vector<Term> displacement_, rate_;
};

}  // namespace secular
