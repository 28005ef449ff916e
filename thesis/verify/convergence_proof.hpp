#pragma once

#include <string>
#include <vector>

#include "thesis/verify/laboratory.hpp"

namespace secular::verify {

/// How far a printed and a corrected statement are from the full equations of motion as eps decreases. The
/// equations are integrated accurately, the record is demodulated, and what it gives for amplitudes, their rates
/// and the harmonics is put into the statement: nothing comes from the derivation engine but, for a coefficient
/// inside a modulation equation, that equation's other coefficients.
struct ConvergenceProof {
  std::vector<double> eps;
  std::vector<double> printed_error, corrected_error;
  double printed_slope = 0, corrected_slope = 0;  ///< of log(error) over log(eps)
  bool decides_for_correction = false;            ///< the corrected error falls by at least half an order faster
  std::string text() const;
};

/// Whether a statement says something that a measurement can contradict (a harmonic, a rate, a relation of both).
bool can_be_measured(const PrintedStatement& statement);

/// `inside`: for a definition, the (corrected) modulation equation that it stands in.
ConvergenceProof prove(Laboratory& laboratory, const PrintedStatement& statement, const PrintedStatement* inside);

}  // namespace secular::verify
