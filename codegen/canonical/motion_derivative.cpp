#include "codegen/canonical/motion_derivative.hpp"

#include <algorithm>
#include <utility>

#include "codegen/canonical/polar_form.hpp"
#include "codegen/canonical/rest_values.hpp"

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

CanonicalFactor with_function(CanonicalFactor factor, SmoothKind function, CanonicalRatio exponent = {1, 1}) {
  factor.function = function;
  factor.exponent = exponent;
  factor.power = 1;
  return factor;
}

CanonicalFactor power_of(std::vector<CanonicalMotionTerm> inner, int exponent) {
  CanonicalFactor factor;
  factor.kind = Kind::smooth;
  factor.exponent = {exponent, 1};
  factor.inner = std::move(inner);
  return factor;
}

RationalFunction one() {
  const std::vector<PolynomialTerm> unit{{"1", {}}};
  return {unit, unit};
}

// The sum's square and 1.
std::vector<CanonicalMotionTerm> one_and_square(const std::vector<CanonicalMotionTerm>& sum, std::size_t symbols) {
  std::vector<CanonicalMotionTerm> result(1);
  result.front().coefficient = one();
  for (auto* terms : {&result.front().coefficient.numerator, &result.front().coefficient.denominator})
    terms->front().exponents.assign(symbols, 0);
  for (const CanonicalMotionTerm& a : sum)
    for (const CanonicalMotionTerm& b : sum) {
      CanonicalMotionTerm& both = result.emplace_back(a);
      both.coefficient = product(a.coefficient, b.coefficient);
      both.factors.insert(both.factors.end(), b.factors.begin(), b.factors.end());
    }
  return result;
}

// A smooth function's derivative by its argument: weight * factor.
std::pair<CanonicalRatio, CanonicalFactor> slope_of(const CanonicalModel& model, const CanonicalFactor& f) {
  const auto inverse_square = [&](SmoothKind of) {
    CanonicalMotionTerm inner;
    inner.coefficient = one_and_square({}, model.order.size()).front().coefficient;
    inner.factors = {with_function(f, of)};
    return power_of({std::move(inner)}, -2);
  };
  switch (f.function) {
    case SmoothKind::sine:
      return {{1, 1}, with_function(f, SmoothKind::cosine)};
    case SmoothKind::cosine:
      return {{-1, 1}, with_function(f, SmoothKind::sine)};
    case SmoothKind::tangent:
      return {{1, 1}, inverse_square(SmoothKind::cosine)};
    case SmoothKind::exponential:
      return {{1, 1}, with_function(f, SmoothKind::exponential)};
    case SmoothKind::hyperbolic_sine:
      return {{1, 1}, with_function(f, SmoothKind::hyperbolic_cosine)};
    case SmoothKind::hyperbolic_cosine:
      return {{1, 1}, with_function(f, SmoothKind::hyperbolic_sine)};
    case SmoothKind::hyperbolic_tangent:
      return {{1, 1}, inverse_square(SmoothKind::hyperbolic_cosine)};
    case SmoothKind::logarithm:
      return {{1, 1}, power_of(f.inner, -1)};
    case SmoothKind::arc_tangent:
      return {{1, 1}, power_of(one_and_square(f.inner, model.order.size()), -1)};
    case SmoothKind::power:
      break;
  }
  return {f.exponent, with_function(f, SmoothKind::power,
                                    {f.exponent.numerator - f.exponent.denominator, f.exponent.denominator})};
}

// What a term's smooth factor `place` adds to its derivative.
void add_through_function(const CanonicalModel& model, const CanonicalMotionTerm& term, std::size_t place,
                          const MotionVariable& variable, std::vector<WeightedMotionTerm>& result) {
  const CanonicalFactor& factor = term.factors[place];
  CanonicalMotionTerm beside = term;
  if (factor.power == 1)
    beside.factors.erase(beside.factors.begin() + static_cast<std::ptrdiff_t>(place));
  else
    --beside.factors[place].power;
  auto [weight, slope] = slope_of(model, factor);
  beside.factors.push_back(std::move(slope));
  for (const CanonicalMotionTerm& part : factor.inner)
    for (const WeightedMotionTerm& inner : motion_derivative(model, part, variable)) {
      CanonicalMotionTerm derived = beside;
      derived.coefficient = product(derived.coefficient, inner.term.coefficient);
      for (const CanonicalRatio& ratio : {weight, inner.weight, CanonicalRatio{factor.power, 1}})
        derived.coefficient = scaled(derived.coefficient, ratio.numerator, ratio.denominator);
      derived.factors.insert(derived.factors.end(), inner.term.factors.begin(), inner.term.factors.end());
      result.push_back({{1, 1}, std::move(derived)});
    }
}

}  // namespace

std::vector<WeightedMotionTerm> motion_derivative(const CanonicalModel& model, const CanonicalMotionTerm& term,
                                                  const MotionVariable& variable) {
  std::vector<WeightedMotionTerm> result;
  if (variable.kind == MotionVariable::Kind::parameter) {
    const std::size_t symbol = index_of_symbol(model, model.parameters[variable.index]);
    CanonicalMotionTerm derived = term;
    derived.coefficient = total_derivative(model, term.coefficient, symbol);
    if (!derived.coefficient.is_zero()) result.push_back({{1, 1}, std::move(derived)});
  }
  for (std::size_t f = 0; f < term.factors.size(); ++f) {
    const CanonicalFactor& factor = term.factors[f];
    if (factor.kind == Kind::smooth) {
      add_through_function(model, term, f, variable, result);
      continue;
    }
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
