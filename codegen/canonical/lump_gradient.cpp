#include "codegen/canonical/lump_gradient.hpp"

#include <algorithm>

namespace secular {

LumpGradient lump_gradient(const CanonicalModel& model, const RationalFunction& definition) {
  LumpGradient gradient;
  for (std::size_t p = 0; p < model.parameters.size(); ++p) {
    const auto symbol = static_cast<std::size_t>(
        std::find(model.order.begin(), model.order.end(), model.parameters[p]) - model.order.begin());
    RationalFunction rate = derivative(definition, symbol);
    if (!rate.is_zero()) gradient.entries.push_back({p, symbol, std::move(rate)});
  }
  return gradient;
}

}  // namespace secular
