#pragma once

#include <vector>

#include "codegen/canonical_model.hpp"
#include "codegen/runtime/formula_set.hpp"
#include "estimator/compiled_model.hpp"

namespace secular {

/// Equations of motion computed from their canonical form. `model` must outlive it.
class InterpretedMotion {
 public:
  explicit InterpretedMotion(const CanonicalModel& model);

  /// See CompiledModel::acceleration; `symbol_values` in the model's order of symbols.
  void acceleration(const double* parameters, const double* symbol_values, const ExcitationSample* excitation,
                    const double* displacement, const double* velocity, double* acceleration) const;

 private:
  struct ArgumentPart {
    enum class Source { displacement, velocity, parameter, one };
    Source source = Source::one;
    std::size_t index = 0;
    double weight = 1;
  };
  struct Factor {
    const CanonicalFactor* canonical = nullptr;
    std::vector<ArgumentPart> argument;  ///< of abs and sgn: empty for one coordinate
  };
  struct Term {
    std::size_t coefficient = 0;  ///< in formulas_
    std::vector<Factor> factors;
    std::size_t mode = 0;
    std::optional<std::size_t> acceleration_of;
  };
  Factor prepared(const CanonicalFactor& factor) const;

  const CanonicalModel& model_;
  FormulaSet formulas_;
  std::vector<Term> terms_;
};

}  // namespace secular
