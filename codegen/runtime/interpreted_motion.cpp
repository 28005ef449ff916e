#include "codegen/runtime/interpreted_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "codegen/cpp/emit_cpp.hpp"
#include "codegen/runtime/smooth_value.hpp"
#include "estimator/model/dense_solve.hpp"
#include "estimator/model/integer_power.hpp"
#include "estimator/model/scalar_functions.hpp"

namespace secular {

InterpretedMotion::InterpretedMotion(const CanonicalModel& model)
    : model_(model), by_state_{FormulaSet(model.order.size()), {}, 1, {}}, by_parameters_(by_state_) {
  refuse_unsupported_motion(model);
  for (const MotionPart& part : motion_parts(model)) {
    Part& added = parts_.emplace_back(Part{part.strength, {FormulaSet(model.order.size()), {}, 1, {}}});
    for (std::size_t k = 0; k < part.motion.size(); ++k)
      for (const CanonicalMotionTerm& term : part.motion[k]) add(added.list, term, k, 0, 1);
  }
  std::vector<MotionVariable> state, parameters;
  for (const auto kind : {MotionVariable::Kind::displacement, MotionVariable::Kind::velocity})
    for (std::size_t k = 0; k < model.coordinates.size(); ++k) state.push_back({kind, k});
  for (std::size_t p = 0; p < model.parameters.size(); ++p)
    parameters.push_back({MotionVariable::Kind::parameter, p});
  add_slopes(by_state_, state);
  add_slopes(by_parameters_, parameters);
}

void InterpretedMotion::add(TermList& list, const CanonicalMotionTerm& canonical, std::size_t mode,
                            std::size_t column, double weight) const {
  Term term{list.formulas.add(canonical.coefficient), {}, mode, column, canonical.acceleration_of, weight};
  for (const CanonicalFactor& factor : canonical.factors)
    term.factors.push_back(prepared(list.factors.emplace_back(factor), list.formulas));
  list.terms.push_back(std::move(term));
}

void InterpretedMotion::add_slopes(TermList& list, const std::vector<MotionVariable>& variables) const {
  list.columns = variables.size();
  for (std::size_t k = 0; k < model_.motion.size(); ++k)
    for (const CanonicalMotionTerm& term : model_.motion[k])
      for (std::size_t x = 0; x < variables.size(); ++x)
        for (const WeightedMotionTerm& derived : motion_derivative(model_, term, variables[x]))
          add(list, derived.term, k, x, static_cast<double>(derived.weight.numerator) / derived.weight.denominator);
}

InterpretedMotion::Factor InterpretedMotion::prepared(const CanonicalFactor& factor, FormulaSet& formulas) const {
  using Source = ArgumentPart::Source;
  Factor result{&factor, {}, {}};
  for (const CanonicalMotionTerm& term : factor.inner) {
    InnerTerm& inner = result.inner.emplace_back(InnerTerm{formulas.add(term.coefficient), {}});
    for (const CanonicalFactor& nested : term.factors) inner.factors.push_back(prepared(nested, formulas));
  }
  for (const auto& [name, ratio] : factor.argument) {
    ArgumentPart part{Source::one, 0, static_cast<double>(ratio.numerator) / ratio.denominator};
    for (std::size_t p = 0; p < model_.parameters.size(); ++p)
      if (name == model_.parameters[p]) part.source = Source::parameter, part.index = p;
    for (std::size_t k = 0; k < model_.coordinates.size(); ++k) {
      if (name == model_.coordinates[k]) part.source = Source::displacement, part.index = k;
      if (name == "D(" + model_.coordinates[k] + ")") part.source = Source::velocity, part.index = k;
    }
    result.argument.push_back(part);
  }
  return result;
}

double InterpretedMotion::argument(const Factor& factor, const Point& point) {
  const CanonicalFactor& f = *factor.canonical;
  if (factor.argument.empty()) return f.derivative == 0 ? point.displacement[f.index] : point.velocity[f.index];
  double sum = 0;
  for (const ArgumentPart& part : factor.argument) switch (part.source) {
      case ArgumentPart::Source::displacement:
        sum += part.weight * point.displacement[part.index];
        break;
      case ArgumentPart::Source::velocity:
        sum += part.weight * point.velocity[part.index];
        break;
      case ArgumentPart::Source::parameter:
        sum += part.weight * point.parameters[part.index];
        break;
      case ArgumentPart::Source::one:
        sum += part.weight;
    }
  return sum;
}

double InterpretedMotion::function(const Factor& factor, const Point& point,
                                   const FormulaSet::Values& coefficient) {
  double argument = 0;
  for (const InnerTerm& inner : factor.inner) {
    double product = coefficient[inner.coefficient];
    for (const Factor& nested : inner.factors) product *= value(nested, point, coefficient);
    argument += product;
  }
  const CanonicalFactor& f = *factor.canonical;
  return smooth_value(f.function, static_cast<double>(f.exponent.numerator) / f.exponent.denominator, argument);
}

double InterpretedMotion::value(const Factor& factor, const Point& point, const FormulaSet::Values& coefficient) {
  using Kind = CanonicalFactor::Kind;
  const CanonicalFactor& f = *factor.canonical;
  switch (f.kind) {
    case Kind::displacement:
      return integer_power(point.displacement[f.index], f.power);
    case Kind::velocity:
      return integer_power(point.velocity[f.index], f.power);
    case Kind::excitation: {
      const ExcitationSample& sample = point.excitation[f.index];
      return integer_power(f.derivative == 0   ? sample.value
                           : f.derivative == 1 ? sample.first_derivative
                                               : sample.second_derivative,
                           f.power);
    }
    case Kind::absolute:
      return integer_power(absolute(argument(factor, point)), f.power);
    case Kind::sign:
      return integer_power(sign_of(argument(factor, point)), f.power);
    case Kind::smooth:
      return integer_power(function(factor, point, coefficient), f.power);
    case Kind::acceleration:
    case Kind::clock_cos:
    case Kind::clock_sin:
      break;
  }
  return 0.0;
}

template <class Take>
void InterpretedMotion::each_term(const Point& point, bool inertia, const Take& take) const {
  for (const Part& part : parts_) {
    if (!part.acts(point)) continue;
    const FormulaSet::Values coefficient(part.list.formulas, point.symbol_values);
    for (const Term& term : part.list.terms) {
      if (term.acceleration_of.has_value() != inertia) continue;
      double product = coefficient[term.coefficient];
      for (const Factor& factor : term.factors) product *= value(factor, point, coefficient);
      take(term, product);
    }
  }
}

void InterpretedMotion::mass_matrix(const Point& point, double* mass) const {
  const std::size_t modes = model_.coordinates.size();
  std::fill(mass, mass + modes * modes, 0.0);
  each_term(point, true,
            [&](const Term& term, double value) { mass[term.mode * modes + *term.acceleration_of] += value; });
}

void InterpretedMotion::acceleration(const Point& point, double* acceleration) const {
  const std::size_t modes = model_.coordinates.size();
  std::fill(acceleration, acceleration + modes, 0.0);
  each_term(point, false, [&](const Term& term, double value) { acceleration[term.mode] -= value; });
  std::vector<double> mass(modes * modes);
  mass_matrix(point, mass.data());
  solve_in_place(mass.data(), modes, acceleration);
}

void InterpretedMotion::acceleration_slopes(const TermList& list, const Point& point, double* slope) const {
  const std::size_t modes = model_.coordinates.size();
  std::vector<double> accelerations(modes), mass(modes * modes);
  acceleration(point, accelerations.data());
  const FormulaSet::Values coefficient(list.formulas, point.symbol_values);
  std::fill(slope, slope + modes * list.columns, 0.0);
  for (const Term& term : list.terms) {
    double product = term.weight * coefficient[term.coefficient];
    for (const Factor& factor : term.factors) product *= value(factor, point, coefficient);
    if (term.acceleration_of) product *= accelerations[*term.acceleration_of];
    slope[term.mode * list.columns + term.column] -= product;
  }
  mass_matrix(point, mass.data());
  solve_in_place(mass.data(), modes, slope, list.columns);
}

void InterpretedMotion::acceleration_by_state(const Point& point, double* slope) const {
  acceleration_slopes(by_state_, point, slope);
}

void InterpretedMotion::acceleration_by_parameters(const Point& point, double* slope) const {
  acceleration_slopes(by_parameters_, point, slope);
}

}  // namespace secular
