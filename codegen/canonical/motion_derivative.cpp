#include "codegen/canonical/motion_derivative.hpp"

#include <algorithm>

namespace secular {
namespace {

using Kind = CanonicalFactor::Kind;

// d(argument of abs or sgn)/d(variable).
CanonicalRatio argument_rate(const CanonicalModel& model, const CanonicalFactor& factor,
                             const MotionVariable& variable) {
  const bool state = variable.kind != MotionVariable::Kind::parameter;
  const int derivative = variable.kind == MotionVariable::Kind::velocity ? 1 : 0;
  if (factor.argument.empty())
    return {state && factor.index == variable.index && factor.derivative == derivative ? 1 : 0, 1};
  std::string name = state ? model.coordinates[variable.index] : model.parameters[variable.index];
  if (variable.kind == MotionVariable::Kind::velocity) name = "D(" + name + ")";
  for (const auto& [part, ratio] : factor.argument)
    if (part == name) return ratio;
  return {0, 1};
}

}  // namespace

std::vector<WeightedMotionTerm> motion_derivative(const CanonicalModel& model, const CanonicalMotionTerm& term,
                                                  const MotionVariable& variable) {
  std::vector<WeightedMotionTerm> result;
  if (variable.kind == MotionVariable::Kind::parameter) {
    const auto symbol = static_cast<std::size_t>(
        std::find(model.order.begin(), model.order.end(), model.parameters[variable.index]) - model.order.begin());
    CanonicalMotionTerm derived = term;
    derived.coefficient = derivative(term.coefficient, symbol);
    if (!derived.coefficient.is_zero()) result.push_back({{1, 1}, std::move(derived)});
  }
  for (std::size_t f = 0; f < term.factors.size(); ++f) {
    const CanonicalFactor& factor = term.factors[f];
    CanonicalRatio weight{0, 1};
    if (factor.kind == Kind::absolute) {
      weight = argument_rate(model, factor, variable);
    } else if ((factor.kind == Kind::displacement && variable.kind == MotionVariable::Kind::displacement) ||
               (factor.kind == Kind::velocity && variable.kind == MotionVariable::Kind::velocity)) {
      weight.numerator = factor.index == variable.index ? 1 : 0;
    }
    if (weight.numerator == 0) continue;
    weight.numerator *= factor.power;
    CanonicalMotionTerm derived = term;
    if (factor.kind == Kind::absolute) {
      CanonicalFactor sign = factor;
      sign.kind = Kind::sign;
      sign.power = 1;
      derived.factors.push_back(std::move(sign));
    }
    if (factor.power == 1)
      derived.factors.erase(derived.factors.begin() + static_cast<std::ptrdiff_t>(f));
    else
      --derived.factors[f].power;
    result.push_back({weight, std::move(derived)});
  }
  return result;
}

}  // namespace secular
