#include "codegen/runtime/rest_value_set.hpp"

#include "codegen/canonical/rest_values.hpp"
#include "codegen/runtime/smooth_value.hpp"

namespace secular {

RestValueSet::RestValueSet(const CanonicalModel& model) {
  for (const CanonicalRestValue& value : model.rest_values) {
    Value& added =
        values_.emplace_back(Value{index_of_symbol(model, value.name), value.function,
                                   static_cast<double>(value.exponent.numerator) / value.exponent.denominator,
                                   FormulaSet(model.order.size())});
    added.argument.add(value.argument);
  }
}

void RestValueSet::fill(double* symbol_values) const {
  for (const Value& value : values_) {
    const FormulaSet::Values argument(value.argument, symbol_values);
    symbol_values[value.symbol] = smooth_value(value.function, value.exponent, argument[0]);
  }
}

}  // namespace secular
