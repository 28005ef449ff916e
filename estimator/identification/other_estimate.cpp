#include "estimator/identification/other_estimate.hpp"

#include <cmath>

#include "estimator/identification/value_errors.hpp"

namespace secular {
namespace {

void allow_for_other(EstimatedValue& value, const EstimatedValue& other, const std::string& why, double share) {
  if (!value.value || !other.value || value.fixed) return;
  add_misfit(value, share * std::abs(*other.value - *value.value), why);
}

}  // namespace

void allow_for_other(Estimate& estimate, const Estimate& other, const std::string& why, double share) {
  for (auto list : {&Estimate::parameters, &Estimate::lumps})
    for (EstimatedValue& value : estimate.*list)
      for (const EstimatedValue& there : other.*list)
        if (there.name == value.name && there.resonance == value.resonance)
          allow_for_other(value, there, why, share);
}

}  // namespace secular
