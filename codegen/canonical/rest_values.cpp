#include "codegen/canonical/rest_values.hpp"

#include <algorithm>
#include <span>

namespace secular {
namespace {

// By the chain rule through the first values: arguments hold earlier ones alone.
RationalFunction derivative_through(const CanonicalModel& model, std::span<const CanonicalRestValue> values,
                                    const RationalFunction& of, std::size_t symbol) {
  RationalFunction whole = derivative(of, symbol);
  for (std::size_t v = 0; v < values.size(); ++v) {
    const RationalFunction by_value = derivative(of, index_of_symbol(model, values[v].name));
    if (by_value.is_zero()) continue;
    const RationalFunction inner = derivative_through(model, values.first(v), values[v].argument, symbol);
    if (!inner.is_zero()) whole = sum(whole, product(by_value, product(values[v].slope, inner)));
  }
  return whole;
}

}  // namespace

RationalFunction total_derivative(const CanonicalModel& model, const RationalFunction& value, std::size_t symbol) {
  return derivative_through(model, model.rest_values, value, symbol);
}

std::size_t index_of_symbol(const CanonicalModel& model, const std::string& name) {
  return static_cast<std::size_t>(std::find(model.order.begin(), model.order.end(), name) - model.order.begin());
}

}  // namespace secular
