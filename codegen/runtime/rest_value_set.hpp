#pragma once

#include <vector>

#include "codegen/canonical/canonical_model.hpp"
#include "codegen/runtime/formula_set.hpp"

namespace secular {

/// Values of functions at a model's rest position, in numbers.
class RestValueSet {
 public:
  explicit RestValueSet(const CanonicalModel& model);
  /// Puts them among the values of the model's symbols, of which the parameters are there.
  void fill(double* symbol_values) const;

 private:
  struct Value {
    std::size_t symbol = 0;
    SmoothKind function = SmoothKind::power;
    double exponent = 1;
    FormulaSet argument;
  };
  std::vector<Value> values_;
};

}  // namespace secular
