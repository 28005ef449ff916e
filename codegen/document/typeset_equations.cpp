#include "codegen/document/typeset_equations.hpp"

#include <cstdlib>
#include <optional>
#include <string>

#include "codegen/canonical/cartesian_form.hpp"
#include "codegen/canonical/free_name.hpp"
#include "codegen/canonical/generated_lump.hpp"
#include "codegen/canonical/polar_form.hpp"
#include "codegen/canonical/steady_state.hpp"

namespace secular::typeset {
namespace {

Product& multiply_forcing(Product& product, const CanonicalModel& model, const std::vector<int>& forcing) {
  for (std::size_t j = 0; j < model.excitations.size(); ++j)
    product.times(symbol(model.excitations[j]), forcing[j]);
  return product;
}

// `letter` names the amplitudes: A, or B in the observed frame.
Product powers_product(const CanonicalModel& model, const CanonicalPowers& powers,
                       const std::string& letter = "A") {
  Product product;
  for (std::size_t k = 0; k < model.coordinates.size(); ++k) {
    const Expression one = named(letter, model, k);
    product.times(one, powers.amplitude[k]);
    product.times(accent("bar", one), powers.conjugate[k]);
    product.times(modulus(one), powers.modulus[k]);
  }
  return multiply_forcing(product, model, powers.forcing);
}

// ratio * factor as a term of the sum.
void add_ratio(Sum& sum, const CanonicalRatio& ratio, const Product& factors) {
  if (ratio.numerator == 0) return;
  Product above;
  if (std::abs(ratio.numerator) != 1) above.times(number(std::abs(ratio.numerator)));
  above.times(factors.expression());
  sum.add(ratio.denominator == 1 ? above.expression() : fraction(above.expression(), number(ratio.denominator)),
          ratio.numerator < 0);
}

Product symbol_product(const std::string& name) {
  return Product().times(symbol(name));
}

Sum frequency_sum(const CanonicalModel& model, const std::vector<CanonicalRatio>& multiples) {
  Sum sum(model.order);
  for (std::size_t i = 0; i < multiples.size(); ++i)
    if (multiples[i].numerator != 0) add_ratio(sum, multiples[i], symbol_product(model.frequency_name(i)));
  return sum;
}

// The detunings times t that a slow phase stands for.
void add_slow_angle(Sum& sum, const CanonicalCase& c, const std::vector<int>& slow_phase) {
  for (std::size_t r = 0; r < c.relations.size(); ++r) {
    const CanonicalRelation& relation = c.relations[r];
    if (relation.detuning.empty()) continue;
    add_ratio(sum, {slow_phase[r] * relation.coefficient.numerator, relation.coefficient.denominator},
              Product().times(symbol(relation.detuning)).times(symbol("t")));
  }
}

Expression times_i(const Expression& angle) {
  return Product().times(constant("i")).times(angle).expression();
}

Expression slow_exponential(const CanonicalModel& model, const CanonicalCase& c, const CanonicalPowers& powers) {
  Sum angle(model.order);
  add_slow_angle(angle, c, powers.slow_phase);
  return angle.empty() ? number(1) : exponential(times_i(angle.expression()));
}

Expression polar_sum(const CanonicalModel& model, const CanonicalCase& c, const std::vector<PolarTerm>& terms) {
  Sum sum(model.order);
  for (const PolarTerm& term : terms) {
    Product rest;
    for (std::size_t k = 0; k < model.coordinates.size(); ++k) rest.times(named("a", model, k), term.amplitude[k]);
    multiply_forcing(rest, model, term.forcing);
    if (term.function != PolarTerm::Trigonometric::one) {
      Sum angle(model.order);
      add_slow_angle(angle, c, term.slow_phase);
      for (std::size_t k = 0; k < model.coordinates.size(); ++k)
        add_ratio(angle, {term.beta[k], 1}, Product().times(named("beta", model, k)));
      rest.times(function(term.function == PolarTerm::Trigonometric::cosine ? "cos" : "sin", angle.expression()));
    }
    sum.add(term.coefficient, rest);
  }
  return sum.expression();
}

Expression cartesian_sum(const CanonicalModel& model, Sum sum, const std::vector<CartesianTerm>& terms) {
  for (const CartesianTerm& term : terms) {
    Product factors;
    for (std::size_t k = 0; k < model.coordinates.size(); ++k) {
      const auto norm_squared = [&] {
        return Sum(model.order)
            .add(power(named("x", model, k), 2), false)
            .add(power(named("y", model, k), 2), false)
            .expression();
      };
      factors.times(norm_squared(), term.norm_squared[k]);
      factors.times(root(norm_squared()), term.norm[k]);
    }
    multiply_forcing(factors, model, term.forcing);
    for (std::size_t k = 0; k < model.coordinates.size(); ++k) {
      factors.times(named("x", model, k), term.x[k]);
      factors.times(named("y", model, k), term.y[k]);
    }
    sum.add(term.coefficient, factors);
  }
  return sum.expression();
}

Sum steady_sum(const CanonicalModel& model, const std::vector<SteadyTerm>& terms) {
  Sum sum(model.order);
  for (const SteadyTerm& term : terms) {
    Product factors;
    factors.times(named("a", model, 0), term.degree);
    multiply_forcing(factors, model, term.forcing);
    sum.add(term.coefficient, factors);
  }
  return sum;
}

Expression coordinate(const CanonicalModel& model, std::size_t mode, int derivative) {
  Expression result = symbol(model.coordinates[mode]);
  return derivative == 0 ? result : accent(derivative == 1 ? "dot" : "ddot", std::move(result));
}

// What abs and sgn are taken of: "v", "v_1 - v_2/2 - gap".
Expression argument(const CanonicalModel& model, const CanonicalFactor& f) {
  if (f.argument.empty()) return coordinate(model, f.index, f.derivative);
  Sum sum(model.order);
  for (const auto& [name, ratio] : f.argument) {
    Product factors;
    if (name.starts_with("D("))
      factors.times(accent("dot", symbol(name.substr(2, name.size() - 3))));
    else if (name != "1")
      factors.times(symbol(name));
    if (!factors.empty()) {
      add_ratio(sum, ratio, factors);
    } else {
      const Expression size = number(std::abs(ratio.numerator));
      sum.add(ratio.denominator == 1 ? size : fraction(size, number(ratio.denominator)), ratio.numerator < 0);
    }
  }
  return sum.expression();
}

Expression clock_angle(const CanonicalModel& model, const CanonicalFactor& f) {
  Product angle;
  if (f.multiple != 1) angle.times(number(f.multiple));
  return angle.times(symbol(model.excitation_frequencies[f.index])).times(symbol("t")).expression();
}

void multiply_excitation(Product& product, const CanonicalModel& model, const CanonicalFactor& f) {
  const Expression strength = symbol(model.excitations[f.index]);
  const Expression wave = function("cos", clock_angle(model, f));
  if (f.derivative == 0) {
    product.times(strength, f.power).times(wave, f.power);
    return;
  }
  Product above, below;
  above.times(constant("d"), f.derivative);
  below.times(constant("d")).times(symbol("t"), f.derivative);
  const Expression derived = Product()
                                 .times(fraction(above.expression(), below.expression()))
                                 .times(bracket(Product().times(strength).times(wave).expression()))
                                 .expression();
  product.times(f.power == 1 ? derived : bracket(derived), f.power);
}

Expression expression_of(const CanonicalModel& model, const std::vector<CanonicalMotionTerm>& terms);

// e to the power ratio * exponent.
Expression exponential_of(const CanonicalRatio& ratio, Expression exponent) {
  const Expression size = number(std::abs(ratio.numerator));
  Product product;
  if (ratio.denominator != 1)
    product.times(fraction(size, number(ratio.denominator)));
  else if (std::abs(ratio.numerator) != 1)
    product.times(size);
  return exponential(product.times(std::move(exponent)).expression());
}

void multiply_function(Product& product, const CanonicalModel& model, const CanonicalFactor& f) {
  Expression inner = expression_of(model, f.inner);
  const auto [numerator, denominator] = f.exponent;
  switch (f.function) {
    case SmoothKind::exponential:
      product.times(exponential_of({f.power, 1}, std::move(inner)));
      return;
    case SmoothKind::power:
      if (denominator == 1)
        product.times(std::move(inner), numerator * f.power);
      else if (denominator == 2)
        product.times(root(std::move(inner)), numerator * f.power);
      else
        product.times(exponential_of({numerator * f.power, denominator}, function("ln", std::move(inner))),
                      numerator < 0 ? -1 : 1);
      return;
    case SmoothKind::logarithm:
      product.times(function("ln", std::move(inner)), f.power);
      return;
    case SmoothKind::arc_tangent:
      product.times(function("arctan", std::move(inner)), f.power);
      return;
    default:
      product.times(function(std::string(name_of(f.function)), std::move(inner)), f.power);
  }
}

void multiply_factor(Product& product, const CanonicalModel& model, const CanonicalFactor& f) {
  switch (f.kind) {
    case CanonicalFactor::Kind::displacement:
      product.times(coordinate(model, f.index, 0), f.power);
      return;
    case CanonicalFactor::Kind::velocity:
      product.times(coordinate(model, f.index, 1), f.power);
      return;
    case CanonicalFactor::Kind::acceleration:
      product.times(coordinate(model, f.index, 2), f.power);
      return;
    case CanonicalFactor::Kind::excitation:
      multiply_excitation(product, model, f);
      return;
    case CanonicalFactor::Kind::absolute:
      product.times(modulus(argument(model, f)), f.power);
      return;
    case CanonicalFactor::Kind::sign:
      product.times(function("sgn", argument(model, f)), f.power);
      return;
    case CanonicalFactor::Kind::clock_cos:
    case CanonicalFactor::Kind::clock_sin:
      product.times(function(f.kind == CanonicalFactor::Kind::clock_cos ? "cos" : "sin", clock_angle(model, f)),
                    f.power);
      return;
    case CanonicalFactor::Kind::smooth:
      multiply_function(product, model, f);
      return;
  }
}

Expression expression_of(const CanonicalModel& model, const std::vector<CanonicalMotionTerm>& terms) {
  Sum sum(model.order);
  for (const CanonicalMotionTerm& term : terms) {
    Product factors;
    for (const CanonicalFactor& factor : term.factors) multiply_factor(factors, model, factor);
    if (term.acceleration_of) factors.times(coordinate(model, *term.acceleration_of, 2));
    sum.add(term.coefficient, factors);
  }
  return sum.expression();
}

}  // namespace

Expression named(const std::string& letter, const CanonicalModel& model, std::size_t mode) {
  return symbol(letter + "_" + model.coordinates[mode]);
}

Expression amplitude(const CanonicalModel& model, std::size_t mode) {
  return named("A", model, mode);
}

Equation motion_equation(const CanonicalModel& model, std::size_t mode) {
  return {number(0), expression_of(model, model.motion[mode])};
}

Equation series_equation(const CanonicalModel& model, const CanonicalSeries& series) {
  Product left;
  multiply_factor(left, model, series.function);
  return {left.expression(), expression_of(model, series.terms)};
}

Equation quadrature_equation(const CanonicalModel& model, const CanonicalQuadrature& quadrature) {
  Product inner;
  for (const CanonicalFactor& factor : quadrature.factors) multiply_factor(inner, model, factor);
  const Expression turning = Product()
                                 .times(constant("i"))
                                 .times(symbol(model.natural_frequencies[quadrature.mode]))
                                 .times(symbol("t"))
                                 .expression();
  inner.times(exponential(Sum(model.order).add(turning, true).expression()));
  Product average;
  average.times(mean(inner.expression()));
  Sum sum(model.order);
  sum.add(words("..."), false);
  sum.add(quadrature.real, average).add(quadrature.imaginary, average, true);
  return {rate_of(amplitude(model, quadrature.mode)), sum.expression()};
}

Expression frequency_combination(const CanonicalModel& model, const std::vector<CanonicalRatio>& multiples) {
  return frequency_sum(model, multiples).expression();
}

Equation relation_equation(const CanonicalModel& model, const CanonicalRelation& relation) {
  const int orientation = relation.coefficient.numerator < 0 ? -1 : 1;
  Sum left(model.order), right(model.order);
  for (std::size_t i = 0; i < relation.multiples.size(); ++i) {
    const int multiple = orientation * relation.multiples[i];
    add_ratio(multiple > 0 ? left : right, {std::abs(multiple), 1}, symbol_product(model.frequency_name(i)));
  }
  if (!relation.detuning.empty())
    add_ratio(right, {std::abs(relation.coefficient.numerator), relation.coefficient.denominator},
              Product().times(symbol("eps"), relation.order).times(symbol(relation.detuning)));
  return {left.expression(), right.expression()};
}

Expression phase_sum(const CanonicalModel& model, const std::vector<int>& phase) {
  std::vector<CanonicalRatio> multiples;
  for (const int multiple : phase) multiples.push_back({multiple, 1});
  return frequency_sum(model, multiples).expression();
}

Expression harmonic(const CanonicalModel& model, const std::vector<int>& phase) {
  const Expression sum = phase_sum(model, phase);
  if (sum == number(0)) return number(1);
  return exponential(Product().times(constant("i")).times(sum).times(symbol("t")).expression());
}

Expression harmonic_coefficient(const CanonicalModel& model, const CanonicalTerm& term) {
  const Product powers = powers_product(model, term.powers);
  return Sum(model.order).add(term.real, powers).add(term.imaginary, powers, true).expression();
}

Equation complex_modulation(const CanonicalModel& model, const CanonicalCase& resonance, std::size_t mode) {
  Sum sum(model.order);
  for (const CanonicalTerm& term : resonance.slow_derivative[mode]) {
    Product factors = powers_product(model, term.powers);
    const Expression phase = slow_exponential(model, resonance, term.powers);
    if (phase != number(1)) factors.times(phase);
    sum.add(term.real, factors).add(term.imaginary, factors, true);
  }
  return {rate_of(amplitude(model, mode)), sum.expression()};
}

std::pair<Equation, Equation> polar_modulation(const CanonicalModel& model, const CanonicalCase& resonance,
                                               std::size_t mode) {
  const PolarEquations polar = polar_equations(model, resonance, mode);
  const Expression a = named("a", model, mode);
  return {{rate_of(a), polar_sum(model, resonance, polar.amplitude_rate)},
          {Product().times(a).times(rate_of(named("beta", model, mode))).expression(),
           polar_sum(model, resonance, polar.phase_rate)}};
}

std::pair<Equation, Equation> cartesian_modulation(const CanonicalModel& model, const CanonicalCase& resonance,
                                                   std::size_t mode) {
  const CartesianEquations cartesian = cartesian_equations(model, resonance, mode);
  const Expression x = named("x", model, mode), y = named("y", model, mode);
  Sum x_sum(model.order), y_sum(model.order);
  const Sum turning = frequency_sum(model, frame_offset(resonance, mode));
  if (!turning.empty()) {
    const Expression rotation = turning.expression();
    x_sum.add(Product().times(rotation).times(y).expression(), false);
    y_sum.add(Product().times(rotation).times(x).expression(), true);
  }
  return {{rate_of(x), cartesian_sum(model, std::move(x_sum), cartesian.x_rate)},
          {rate_of(y), cartesian_sum(model, std::move(y_sum), cartesian.y_rate)}};
}

Equation frame_amplitude(const CanonicalModel& model, const CanonicalCase& resonance, std::size_t mode) {
  std::vector<CanonicalRatio> backwards = frame_offset(resonance, mode);
  for (CanonicalRatio& multiple : backwards) multiple.numerator = -multiple.numerator;
  Product right;
  right.times(amplitude(model, mode));
  if (const Sum turning = frequency_sum(model, backwards); !turning.empty())
    right.times(
        exponential(Product().times(constant("i")).times(turning.expression()).times(symbol("t")).expression()));
  return {named("B", model, mode), right.expression()};
}

Equation cartesian_amplitude(const CanonicalModel& model, std::size_t mode) {
  const Expression imaginary = Product().times(constant("i")).times(named("y", model, mode)).expression();
  const Expression sum = Sum(model.order).add(named("x", model, mode), false).add(imaginary, false).expression();
  return {named("B", model, mode), fraction(sum, number(2))};
}

Expression observed_frequency_symbol(const CanonicalModel& model, std::size_t mode) {
  return symbol(observed_frequency_name(model, mode));
}

Equation observed_frequency(const CanonicalModel& model, const CanonicalCase& resonance, std::size_t mode) {
  return {observed_frequency_symbol(model, mode),
          frequency_sum(model, resonance.observed_frequency[mode]).expression()};
}

Expression lump_symbol(const CanonicalModel& model, const CanonicalCase& resonance, std::size_t lump) {
  const std::optional<GeneratedLump> generated = generated_lump(model, resonance, lump);
  if (!generated) return symbol(resonance.lumps[lump].name);
  const auto letter = [&] {
    switch (generated->kind) {
      case GeneratedLump::Kind::conservative:
        return "c";
      case GeneratedLump::Kind::dissipative:
        return "d";
      case GeneratedLump::Kind::harmonic_real:
        return "p";
      case GeneratedLump::Kind::harmonic_imaginary:
        break;
    }
    return "q";
  };
  return indexed(symbol(letter()),
                 {symbol(model.coordinates[generated->mode]), monomial(model, generated->powers)});
}

Expression monomial(const CanonicalModel& model, const CanonicalPowers& powers) {
  return powers_product(model, powers).expression();
}

Equation lump_definition(const CanonicalModel& model, const CanonicalCase& resonance, std::size_t lump) {
  return {lump_symbol(model, resonance, lump), expression_of(resonance.lumps[lump].definition, model.order)};
}

Equation block_equation(const CanonicalModel& model, const CanonicalCase& resonance, const CanonicalBlock& block) {
  Sum sum(model.order);
  for (const CanonicalBlock::Column& column : block.columns)
    for (const CanonicalColumnTerm& term : column.terms) {
      Product factors;
      factors.times(lump_symbol(model, resonance, column.lump));
      const Product powers = powers_product(model, term.powers, "B");
      if (!powers.empty()) factors.times(powers.expression());
      sum.add(term.factor, factors, term.imaginary);
    }
  if (!block.modulation)
    return {Product()
                .times(accent("hat", symbol(model.coordinates[block.mode])))
                .times(bracket(phase_sum(model, block.phase)))
                .expression(),
            sum.expression()};
  const Expression natural =
      Product().times(constant("i")).times(symbol(model.natural_frequencies[block.mode])).expression();
  const Expression distance = Sum(model.order).add(symbol("rate"), false).add(natural, true).expression();
  return {Product().times(distance).times(named("B", model, block.mode)).expression(), sum.expression()};
}

std::vector<Equation> steady_equations(const CanonicalModel& model, const CanonicalCase& resonance) {
  const SteadyState steady = steady_state(model, resonance);
  if (steady.kind == SteadyState::Kind::several_modes || steady.kind == SteadyState::Kind::several_angles)
    return {};
  const Expression a = named("a", model, 0);
  Sum in_phase = steady_sum(model, steady.still_imaginary);
  const Expression still_real = steady_sum(model, steady.still_real).expression();
  if (steady.kind == SteadyState::Kind::free) {
    const Expression difference = Sum(model.order)
                                      .add(observed_frequency_symbol(model, 0), false)
                                      .add(symbol(model.natural_frequencies[0]), true)
                                      .expression();
    return {{rate_of(a), still_real}, {Product().times(a).times(difference).expression(), in_phase.expression()}};
  }
  const Sum turning = frequency_sum(model, frame_offset(resonance, 0));
  if (!turning.empty()) in_phase.add(Product().times(a).times(bracket(turning.expression())).expression(), true);
  Sum left(model.order), right(model.order);
  left.add(power(bracket(still_real), 2), false).add(power(bracket(in_phase.expression()), 2), false);
  for (const std::vector<SteadyTerm>* terms : {&steady.turning_real, &steady.turning_imaginary})
    if (!terms->empty()) right.add(power(bracket(steady_sum(model, *terms).expression()), 2), false);
  return {{left.expression(), right.expression()}};
}

}  // namespace secular::typeset
