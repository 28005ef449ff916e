#include "estimator/identification/other_estimate.hpp"

#include <cmath>

namespace secular {
namespace {

void allow_for_other(EstimatedValue& value, const EstimatedValue& other) {
  if (!value.value || !other.value || value.fixed) return;
  const double misfit = std::abs(*other.value - *value.value);
  value.doubtful = value.doubtful || misfit > 2 * value.sd;
  value.sd = std::hypot(value.sd, 0.5 * misfit);
  value.misfit = std::hypot(value.misfit, misfit);
}

}  // namespace

void allow_for_other(Estimate& estimate, const Estimate& other) {
  for (auto list : {&Estimate::parameters, &Estimate::lumps})
    for (EstimatedValue& value : estimate.*list)
      for (const EstimatedValue& there : other.*list)
        if (there.name == value.name && there.resonance == value.resonance) allow_for_other(value, there);
}

}  // namespace secular
