#include "codegen/canonical/lump_gradient.hpp"

#include "codegen/canonical/rest_values.hpp"

namespace secular {

LumpGradient lump_gradient(const CanonicalModel& model, const RationalFunction& definition) {
  LumpGradient gradient;
  for (std::size_t p = 0; p < model.parameters.size(); ++p) {
    const std::size_t symbol = index_of_symbol(model, model.parameters[p]);
    RationalFunction rate = total_derivative(model, definition, symbol);
    if (!rate.is_zero()) gradient.entries.push_back({p, symbol, std::move(rate)});
  }
  return gradient;
}

}  // namespace secular
