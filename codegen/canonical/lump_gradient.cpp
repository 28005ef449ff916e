#include "codegen/canonical/lump_gradient.hpp"

#include <algorithm>

namespace secular {

LumpGradient lump_gradient(const CanonicalModel& model, const RationalFunction& definition) {
  const std::vector<PolynomialTerm> one = {{"1", std::vector<int>(model.order.size(), 0)}};
  const RationalFunction numerator{definition.numerator, one}, denominator{definition.denominator, one};
  LumpGradient gradient;
  gradient.shared = definition.denominator.size() > 1;
  if (gradient.shared) gradient.denominator = denominator;
  for (std::size_t p = 0; p < model.parameters.size(); ++p) {
    const auto symbol = static_cast<std::size_t>(
        std::find(model.order.begin(), model.order.end(), model.parameters[p]) - model.order.begin());
    LumpGradient::Entry entry{p, symbol, {}, {}};
    if (gradient.shared) {
      entry.rate = derivative(numerator, symbol);
      entry.denominator_rate = derivative(denominator, symbol);
    } else {
      entry.rate = derivative(definition, symbol);
    }
    if (!entry.rate.is_zero() || !entry.denominator_rate.is_zero()) gradient.entries.push_back(std::move(entry));
  }
  return gradient;
}

}  // namespace secular
