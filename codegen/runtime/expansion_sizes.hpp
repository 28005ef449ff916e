#pragma once

#include <complex>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"
#include "codegen/runtime/formula_set.hpp"
#include "codegen/runtime/monomial.hpp"

namespace secular {

/// How much each order of a case's expansion of the displacements contributes at a state, and whether the expansion
/// still says something there. An order's size is the sum of the moduli of its terms, phases left out, so that
/// terms of one order that happen to cancel do not hide it. (Orders of dA/dt are no such measure: what the model
/// counts as small of first order, a damping perhaps, may be smaller than what it counts as second.) Needs
/// CanonicalContent::all; `model` and `resonance` need not outlive it.
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
  /// exceed every order before, A itself included. (Every one, since orders may vanish by symmetry or for want of a
  /// coefficient.) Linear terms of the last order are as large as the orders that the model gives its parameters,
  /// whatever the amplitude: they are no sign.
  bool outside(const State& state) const;

 private:
  struct Term {
    std::size_t mode = 0, order = 0;
    std::size_t real = 0, imaginary = 0;  ///< in formulas_
    bool nonlinear = false;
    Monomial monomial;
  };

  std::size_t modes_, excitations_, symbols_, last_;  // last_: order
  std::vector<std::size_t> symbol_of_parameter_;
  FormulaSet formulas_;
  std::vector<Term> terms_;
};

}  // namespace secular
