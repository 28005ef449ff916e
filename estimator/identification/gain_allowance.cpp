#include "estimator/identification/gain_allowance.hpp"

#include <algorithm>
#include <cmath>

namespace secular {
namespace {

double power_of_coordinates(std::span<const Ratio> dimension, std::size_t modes) {
  double power = 0;
  for (std::size_t k = 0; k < std::min(modes, dimension.size()); ++k)
    power += static_cast<double>(dimension[k].numerator) / dimension[k].denominator;
  return power;
}

void allow(EstimatedValue& value, double power, double share) {
  if (!value.value || value.fixed || power == 0) return;
  const double misfit = std::abs(power * *value.value) * share;
  value.doubtful = value.doubtful || misfit > 2 * value.sd;
  value.sd = std::hypot(value.sd, 0.5 * misfit);
  value.misfit = std::hypot(value.misfit, misfit);
}

}  // namespace

void allow_for_gain(Estimate& estimate, const CompiledModel& model, double share) {
  const auto power = [&](std::span<const Ratio> dimension) {
    return power_of_coordinates(dimension, model.modes());
  };
  for (EstimatedValue& value : estimate.parameters)
    for (const CompiledSymbol& symbol : model.symbols)
      if (symbol.name == value.name) allow(value, power(symbol.dimension), share);
  for (EstimatedValue& value : estimate.lumps)
    for (const CompiledCase* resonance : estimate.cases)
      for (const CompiledLump& lump : resonance->lumps)
        if (resonance->name == value.resonance && lump.name == value.name)
          allow(value, power(lump.dimension), share);
}

}  // namespace secular
