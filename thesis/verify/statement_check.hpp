#pragma once

#include <optional>
#include <string>

#include "thesis/verify/printed_formula.hpp"

namespace secular::verify {

/// Compares statements of one chapter with the engine's derivation of the same case, exactly: a difference is zero
/// if it vanishes at random points of a prime field (see PrimeFieldComplex).
class StatementCheck {
 public:
  StatementCheck(const PrintedChapter& chapter, const Derivation& derivation);

  /// Whether `text` (the statement as printed, or corrected) is right. Throws InputError for a mode, an order or a
  /// name that model and case do not have, and for a formula without a value.
  bool holds(const PrintedStatement& statement, const FormulaSource& text) const;

  const PrintedFormula& formula() const { return formula_; }

 private:
  bool compared(const PrintedStatement& statement, const FormulaSource& text) const;
  void require_possible(const PrintedStatement& statement) const;
  /// The symbol that `key` names.
  const GiNaC::ex& named(const PrintedStatement& statement, const char* key, const std::string& name) const;
  GiNaC::ex slope_by(const PrintedStatement& statement, const GiNaC::ex& condition, const GiNaC::ex& unknown) const;
  bool vanishes_at_resonance(const GiNaC::ex& difference, const PrintedStatement& statement) const;
  std::optional<GiNaC::ex> scheme_difference(const PrintedStatement& statement, const FormulaSource& text) const;
  bool phase_leaves_rates(const PrintedStatement& statement, const FormulaSource& text) const;
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
