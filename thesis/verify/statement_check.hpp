#pragma once

#include <string>

#include "thesis/verify/printed_formula.hpp"

namespace secular::verify {

/// Compares statements of one chapter with the engine's derivation of the same case, exactly: a difference is zero
/// if it vanishes at random points of a prime field (see PrimeFieldComplex).
class StatementCheck {
 public:
  StatementCheck(const PrintedChapter& chapter, const Derivation& derivation);

  /// Whether `text` (the statement as printed, or corrected) is right. Throws InputError for an unknown kind or
  /// symbol.
  bool holds(const PrintedStatement& statement, const FormulaSource& text) const;

  const PrintedFormula& formula() const { return formula_; }

 private:
  bool vanishes_at_resonance(const GiNaC::ex& difference, const PrintedStatement& statement) const;
  GiNaC::ex forcing(const PrintedStatement& statement) const;
  GiNaC::ex definition(const PrintedStatement& statement) const;
  GiNaC::ex with_engine_rates(const GiNaC::ex& expression) const;
  bool holds_on_fixed_points(const PrintedStatement& statement, const FormulaSource& text) const;
  bool holds_at_saddle_node(const PrintedStatement& statement, const FormulaSource& text) const;
  bool holds_at_threshold(const PrintedStatement& statement, const FormulaSource& text) const;
  bool fourier_mean_holds(const PrintedStatement& statement, const FormulaSource& text) const;

  const Derivation& derivation_;
  PrintedFormula formula_;
  std::vector<std::vector<GiNaC::ex>> rate_;  // [mode][n], amplitudes as A
  GiNaC::exmap polar_rates_;                  // da, dbeta, dgamma
};

}  // namespace secular::verify
