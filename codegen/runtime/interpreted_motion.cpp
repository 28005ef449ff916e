#include "codegen/runtime/interpreted_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "codegen/emit_cpp.hpp"
#include "estimator/dense_solve.hpp"
#include "estimator/integer_power.hpp"

namespace secular {

InterpretedMotion::InterpretedMotion(const CanonicalModel& model) : model_(model), formulas_(model.order.size()) {
  refuse_unsupported_motion(model);
  for (std::size_t k = 0; k < model.motion.size(); ++k)
    for (const CanonicalMotionTerm& canonical : model.motion[k]) {
      Term term{formulas_.add(canonical.coefficient), {}, k, canonical.acceleration_of};
      for (const CanonicalFactor& factor : canonical.factors) term.factors.push_back(prepared(factor));
      terms_.push_back(std::move(term));
    }
}

InterpretedMotion::Factor InterpretedMotion::prepared(const CanonicalFactor& factor) const {
  using Source = ArgumentPart::Source;
  Factor result{&factor, {}};
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

void InterpretedMotion::acceleration(const double* parameters, const double* symbol_values,
                                     const ExcitationSample* excitation, const double* displacement,
                                     const double* velocity, double* acceleration) const {
  const std::size_t modes = model_.coordinates.size();
  const FormulaSet::Values coefficient(formulas_, symbol_values);
  const auto argument = [&](const Factor& factor) {
    const CanonicalFactor& f = *factor.canonical;
    if (factor.argument.empty()) return f.derivative == 0 ? displacement[f.index] : velocity[f.index];
    double sum = 0;
    for (const ArgumentPart& part : factor.argument) switch (part.source) {
        case ArgumentPart::Source::displacement:
          sum += part.weight * displacement[part.index];
          break;
        case ArgumentPart::Source::velocity:
          sum += part.weight * velocity[part.index];
          break;
        case ArgumentPart::Source::parameter:
          sum += part.weight * parameters[part.index];
          break;
        case ArgumentPart::Source::one:
          sum += part.weight;
      }
    return sum;
  };
  const auto value = [&](const Factor& factor) {
    using Kind = CanonicalFactor::Kind;
    const CanonicalFactor& f = *factor.canonical;
    switch (f.kind) {
      case Kind::displacement:
        return integer_power(displacement[f.index], f.power);
      case Kind::velocity:
        return integer_power(velocity[f.index], f.power);
      case Kind::excitation: {
        const ExcitationSample& sample = excitation[f.index];
        return integer_power(f.derivative == 0   ? sample.value
                             : f.derivative == 1 ? sample.first_derivative
                                                 : sample.second_derivative,
                             f.power);
      }
      case Kind::absolute:
        return integer_power(std::abs(argument(factor)), f.power);
      case Kind::sign: {
        const double x = argument(factor);
        return static_cast<double>(x > 0) - static_cast<double>(x < 0);
      }
      case Kind::acceleration:
      case Kind::clock_cos:
      case Kind::clock_sin:
        break;
    }
    return 0.0;
  };
  thread_local std::vector<double> mass;
  mass.assign(modes * modes, 0.0);
  std::fill(acceleration, acceleration + modes, 0.0);
  for (const Term& term : terms_) {
    double product = coefficient[term.coefficient];
    for (const Factor& factor : term.factors) product *= value(factor);
    if (term.acceleration_of)
      mass[term.mode * modes + *term.acceleration_of] += product;
    else
      acceleration[term.mode] -= product;
  }
  solve_in_place(mass.data(), modes, acceleration);
}

}  // namespace secular
