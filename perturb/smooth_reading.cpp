#include "perturb/smooth_reading.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "perturb/expression_text.hpp"
#include "perturb/formula_value.hpp"

namespace secular {
namespace {

constexpr long largest_denominator = 1000;

// "sin", "sqrt", "a denominator", "a power": as a message calls it.
std::string called(const SmoothCall& call) {
  if (call.whole->kind == Expression::Kind::call) return call.whole->text;
  if (call.whole->kind == Expression::Kind::quotient) return "a denominator";
  return call.exponent.second == 1 ? "a negative power" : "a power that is no integer";
}

std::string rest_position(const Model& model) {
  std::string text;
  for (const Mode& mode : model.modes) text += (text.empty() ? "" : " = ") + mode.coordinate;
  return text + " = 0";
}

void refuse_factor(const SmoothCall& call, const FormulaSource& source, const Factor& factor) {
  const auto refuse = [&](const std::string& what, const std::string& right) {
    fail_at(source, call.whole->place, what + " in " + called(call), right);
  };
  switch (factor.kind) {
    case Factor::Kind::coordinate:
      if (factor.derivative > 1) refuse("an acceleration", "equations of motion are linear in accelerations");
      return;
    case Factor::Kind::excitation:
    case Factor::Kind::clock_cos:
    case Factor::Kind::clock_sin:
      refuse("an excitation",
             "a function is one of coordinates and velocities: give the excitation a term or a factor of its own");
      return;
    case Factor::Kind::absolute:
    case Factor::Kind::sign:
      refuse("abs, sgn, max or min",
             "a smooth function is one of coordinates and velocities: c*abs(x)*tanh(x) "
             "multiplies both");
      return;
    case Factor::Kind::smooth:
      return;
  }
}

void require_smooth_at_rest(const SmoothCall& call, const Model& model, const FormulaSource& source) {
  const GiNaC::ex rest = value_at_rest(call.inside).normal();
  const std::string where = " at the rest position " + rest_position(model);
  const auto refuse = [&](const std::string& wrong, const std::string& right) {
    fail_at(source, call.whole->place, wrong, right);
  };
  const bool logarithm = call.kind == SmoothKind::logarithm, power = call.kind == SmoothKind::power;
  if (!power && !logarithm) {
    if (!rest.is_zero())
      refuse(
          fmt::format("the argument of {} is not 0{}", called(call), where),
          "its expansion has no coefficients that are rational: write b*exp(x) for exp(a + x), s*cos(x) + c*sin(x) "
          "for sin(a + x), with symbols for the constants");
    return;
  }
  if (rest.is_zero()) {
    if (power && call.exponent.second == 1 && call.exponent.first < 0)
      refuse(fmt::format("{} is 0{}", called(call), where),
             "a function that is smooth there was expected, as 1/(1 + x); coordinates count from rest");
    refuse(fmt::format("{} is not smooth{}: its argument is 0 there", called(call), where),
           "a function that is smooth there was expected, as sqrt(1 + x) or log(1 + x); abs(x) is sqrt(x^2)");
  }
  if ((logarithm || call.exponent.second != 1) && !(rest - 1).normal().is_zero())
    refuse(fmt::format("the argument of {} is not 1{}", called(call), where),
           "take its value at rest out: a*sqrt(1 + (x/a)^2) for sqrt(a^2 + x^2), b + log(1 + x/a) for log(a + x)");
}

// base^power. GiNaC's own error for 0^-1 leaves its object behind.
GiNaC::ex finite_power(const GiNaC::ex& base, int power) {
  if (power < 0 && base.is_zero()) throw GiNaC::pole_error("division by zero", -power);
  return GiNaC::pow(base, power);
}

}  // namespace

GiNaC::ex value_at_rest(const SmoothFunction& function) {
  switch (function.kind()) {
    case SmoothKind::cosine:
    case SmoothKind::exponential:
    case SmoothKind::hyperbolic_cosine:
      return 1;
    case SmoothKind::power: {
      const auto [numerator, denominator] = function.exponent();
      return denominator == 1 ? finite_power(value_at_rest(function.argument()), static_cast<int>(numerator)) : 1;
    }
    default:
      return 0;
  }
}

GiNaC::ex value_at_rest(const TermSum& sum) {
  GiNaC::ex whole = 0;
  for (const auto& [product, coefficient] : sum.terms()) {
    GiNaC::ex value = coefficient;
    for (const auto& [factor, power] : product)
      value *= factor.kind == Factor::Kind::smooth ? finite_power(value_at_rest(factor.function), power) : 0;
    whole += value;
  }
  return whole.expand();
}

TermSum smooth_term(const SmoothCall& call, const Model& model, const FormulaSource& source) {
  bool moves = false;
  for (const auto& [product, ignored] : call.inside.terms())
    for (const auto& [factor, power] : product) {
      refuse_factor(call, source, factor);
      moves = true;
    }
  if (!moves)
    fail_at(source, call.whole->place, called(call) + " of a constant",
            "name the number by a symbol of its own: a coordinate or its velocity was expected in it");
  if (model.rests_at_zero) require_smooth_at_rest(call, model, source);
  Factor factor{Factor::Kind::smooth, 0, 0, 1};
  factor.function = SmoothFunction(call.kind, call.exponent, call.inside, expression_text(*call.argument));
  return TermSum::factor(factor);
}

std::pair<long, long> rational_exponent(const Expression& power, const FormulaSource& source) {
  const Expression& exponent = power.operands[1];
  const GiNaC::ex value = formula_value(exponent, source, [&](const Expression& symbol) -> GiNaC::ex {
    fail_at(source, symbol.place, "symbol '" + symbol.text + "' in an exponent",
            "exponents are numbers; exp(n*log(1 + x)) is the n-th power of 1 + x");
  });
  if (GiNaC::is_a<GiNaC::numeric>(value)) {
    const GiNaC::numeric number = GiNaC::ex_to<GiNaC::numeric>(value);
    if (number.is_rational() && GiNaC::abs(number) <= largest_exponent && number.denom() <= largest_denominator)
      return {number.numer().to_long(), number.denom().to_long()};
  }
  fail_at(source, exponent.place,
          fmt::format("the exponent is not a rational number between -{0} and {0} with a denominator up to {1}",
                      largest_exponent, largest_denominator),
          "write an integer or a fraction, as 3/2");
}

}  // namespace secular
