#pragma once

#include <vector>

#include "perturb/graded_polynomial.hpp"
#include "perturb/model.hpp"
#include "perturb/substitution_arithmetic.hpp"

namespace secular {

/// Every frequency of a case, natural ones and then excitations, as a series in eps on which all relations
///   sum_j multiples_j f_j = coefficient * eps^n * detuning
/// hold: each relation gives one frequency, the last that no other relation gives, in terms of the others. Those
/// are random values, as are the detunings. For ExactArithmetic and FloatingArithmetic. Its elimination is its own
/// on purpose: a certificate must not lean on that of the derivation that it checks (numerics/row_reduction.hpp).
template <class Arithmetic>
std::vector<EpsSeries<typename Arithmetic::Number>> solved_frequencies(const Model& model,
                                                                       const ResonanceCase& resonance,
                                                                       const Arithmetic& arithmetic);

}  // namespace secular
