#pragma once

#include <complex>
#include <memory>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"
#include "codegen/runtime/formula_set.hpp"
#include "codegen/runtime/monomial.hpp"
#include "estimator/model/compiled_model.hpp"

namespace secular {

/// One block of rows computed from its canonical form.
class InterpretedBlock {
 public:
  InterpretedBlock(const CanonicalModel& model, const CanonicalBlock& block);

  /// See RegressorBlock::columns.
  void columns(const ObservationBatch& data, std::complex<double>* const* columns) const;
  /// See RegressorBlock::column_slopes.
  void column_slopes(const ObservationBatch& data, std::size_t mode, std::complex<double>* const* columns) const;
  /// target = sum of columns * lumps at one amplitude; `symbol_values` in the model's order of symbols.
  std::complex<double> target(const double* symbol_values, const double* lumps,
                              const std::complex<double>* amplitude, const std::complex<double>* forcing) const;

 private:
  struct Term {
    std::size_t column = 0, lump = 0, factor = 0;  ///< factor: in formulas_
    bool imaginary = false;
    Monomial monomial;
  };
  /// d(factor)/d(natural frequency of `mode`) of one term, as in LumpGradient.
  struct Slope {
    std::size_t term = 0, mode = 0, rate = 0;
  };
  /// Fills columns from numbers that multiply the terms: factor(values of all symbols, numbers).
  template <class Factors>
  void rows(const ObservationBatch& data, Factors factors, std::complex<double>* const* columns) const;

  const CanonicalModel& model_;
  FormulaSet formulas_, slope_formulas_;
  std::vector<Term> terms_;
  std::vector<Slope> slopes_;
};

/// One case computed from its canonical form. `model` must outlive it.
class InterpretedCase {
 public:
  InterpretedCase(const CanonicalModel& model, const CanonicalCase& resonance);

  /// See CompiledCase; `symbol_values` in the model's order of symbols.
  void lumps(const double* symbol_values, double* lumps) const;
  void lumps_jacobian(const double* symbol_values, double* jacobian) const;
  void modulation(const double* symbol_values, const double* excitation_frequency,
                  const std::complex<double>* amplitude, const std::complex<double>* forcing,
                  std::complex<double>* derivative) const;
  void modulation_jacobian(const double* symbol_values, const double* excitation_frequency,
                           const std::complex<double>* amplitude, const std::complex<double>* forcing,
                           double* jacobian) const;
  const InterpretedBlock& block(std::size_t b) const { return *blocks_[b]; }

 private:
  struct GradientEntry {
    std::size_t lump = 0, parameter = 0, rate = 0;
  };
  /// A term of dB_mode/dt derived by B_along or its conjugate.
  struct DerivedTerm {
    std::size_t mode = 0, along = 0, lump = 0, factor = 0;
    bool by_conjugate = false, imaginary = false;
    double weight = 1;
    Monomial monomial;
  };
  void derive_modulation();
  /// The symbols' values with the excitation frequencies, which detunings hold.
  std::vector<double> with_excitation(const double* symbol_values, const double* excitation_frequency) const;
  /// w_k - omega_k: the frame turns with w_k instead of omega_k.
  double rotation(std::size_t mode, const double* symbol_values, const double* excitation_frequency) const;

  const CanonicalModel& model_;
  const CanonicalCase& case_;
  FormulaSet lump_formulas_, gradient_formulas_, derived_formulas_;
  std::vector<DerivedTerm> derived_;
  std::vector<GradientEntry> gradient_;
  std::vector<std::unique_ptr<InterpretedBlock>> blocks_;
};

}  // namespace secular
