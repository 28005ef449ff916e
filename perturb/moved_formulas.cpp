#include "perturb/moved_formulas.hpp"

#include <algorithm>
#include <utility>

#include "perturb/expression_text.hpp"
#include "perturb/smooth_reading.hpp"

namespace secular {
namespace {

using Kind = Expression::Kind;

Expression symbol(const std::string& name, const SourcePlace& place) {
  return {Kind::symbol, place, name, {}};
}
Expression number(int value, const SourcePlace& place) {
  const Expression size{Kind::number, place, std::to_string(value < 0 ? -value : value), {}};
  return value < 0 ? Expression{Kind::negation, place, "-", {size}} : size;
}
Expression product_of(Expression a, Expression b) {
  return {Kind::product, a.place, "*", {std::move(a), std::move(b)}};
}
Expression quotient_of(Expression a, Expression b) {
  return {Kind::quotient, a.place, "/", {std::move(a), std::move(b)}};
}
Expression sum_of(Expression a, Expression b) {
  return {Kind::sum, a.place, "+", {std::move(a), std::move(b)}};
}
Expression minus(Expression a) {
  return {Kind::negation, a.place, "-", {std::move(a)}};
}
Expression call_of(const std::string& name, Expression argument) {
  return {Kind::call, argument.place, name, {std::move(argument)}};
}

bool is_derivative(const Expression& e) {
  return e.kind == Kind::call && (e.text == "D" || e.text == "D2");
}
bool has_corner(const Expression& e) {
  return e.kind == Kind::call && (e.text == "abs" || e.text == "sgn" || e.text == "max" || e.text == "min");
}
bool is_one_at_zero(const std::string& function) {
  return function == "cos" || function == "exp" || function == "cosh";
}

std::optional<SmoothKind> partner(SmoothKind kind) {
  switch (kind) {
    case SmoothKind::sine:
      return SmoothKind::cosine;
    case SmoothKind::cosine:
      return SmoothKind::sine;
    case SmoothKind::hyperbolic_sine:
      return SmoothKind::hyperbolic_cosine;
    case SmoothKind::hyperbolic_cosine:
      return SmoothKind::hyperbolic_sine;
    default:
      return std::nullopt;
  }
}

}  // namespace

Expression RestPosition::slope(const RestValue& value) const {
  const SourcePlace place = value.argument.place;
  const Expression self = symbol(value.name, place);
  const auto other = [&](SmoothKind kind) {
    for (const RestValue& v : values)
      if (v.kind == kind && expression_text(v.argument) == expression_text(value.argument))
        return symbol(v.name, place);
    return self;
  };
  switch (value.kind) {
    case SmoothKind::sine:
      return other(SmoothKind::cosine);
    case SmoothKind::cosine:
      return minus(other(SmoothKind::sine));
    case SmoothKind::hyperbolic_sine:
      return other(SmoothKind::hyperbolic_cosine);
    case SmoothKind::hyperbolic_cosine:
      return other(SmoothKind::hyperbolic_sine);
    case SmoothKind::exponential:
      return self;
    case SmoothKind::tangent:
      return sum_of(number(1, place), product_of(self, self));
    case SmoothKind::hyperbolic_tangent:
      return sum_of(number(1, place), minus(product_of(self, self)));
    case SmoothKind::logarithm:
      return quotient_of(number(1, place), value.argument);
    case SmoothKind::arc_tangent:
      return quotient_of(number(1, place), sum_of(number(1, place), product_of(value.argument, value.argument)));
    case SmoothKind::power:
      break;
  }
  Expression ratio = quotient_of(number(static_cast<int>(value.exponent.first), place),
                                 number(static_cast<int>(value.exponent.second), place));
  return product_of(std::move(ratio), quotient_of(self, value.argument));
}

Model MovedFormulas::moved(const Model& stated) {
  Model model = stated;
  for (Mode& mode : model.modes) {
    if (mode.equation) {
      mode.equation->left = moved(mode.equation->left, mode.source);
      mode.equation->right.front() = moved(mode.equation->right.front(), mode.source);
      mode.source.text =
          expression_text(mode.equation->left) + " = " + expression_text(mode.equation->right.front());
    } else {
      mode.force = moved(*mode.force, mode.source);
      mode.source.text = expression_text(*mode.force);
    }
  }
  if (model.lagrangian) {
    Lagrangian& l = *model.lagrangian;
    l.kinetic = moved(l.kinetic, l.kinetic_source);
    l.potential = moved(l.potential, l.potential_source);
    l.kinetic_source.text = expression_text(l.kinetic);
    l.potential_source.text = expression_text(l.potential);
  }
  return model;
}

Expression MovedFormulas::moved(const Expression& e, const FormulaSource& source) {
  if (e.kind == Kind::symbol) return moved_symbol(e);
  if (is_derivative(e) && e.operands[0].kind == Kind::symbol) return e;
  if (has_corner(e))
    for (const Expression& operand : e.operands)
      if (moves(operand)) refuse_corner(e, source);
  if (e.kind == Kind::call && moves(e.operands[0]) && (e.text == "sqrt" || smooth_kind(e.text)))
    return moved_call(e, source);
  if (e.kind == Kind::power && moves(e.operands[0])) {
    const std::pair<long, long> exponent = rational_exponent(e, source);
    if (exponent.second != 1) return moved_power(e, exponent, source);
  }
  Expression result = e;
  for (Expression& operand : result.operands) operand = moved(operand, source);
  return result;
}

Expression MovedFormulas::moved_symbol(const Expression& e) const {
  for (std::size_t k = 0; k < rest_.size(); ++k)
    if (!rest_[k].empty() && model_.modes[k].coordinate == e.text) return sum_of(symbol(rest_[k], e.place), e);
  const auto known = replaced_.find(e.text);
  return known == replaced_.end() ? e : known->second;
}

// Whether it holds a coordinate, no velocity, that does not rest at zero.
bool MovedFormulas::moves(const Expression& e) const {
  if (is_derivative(e) && e.operands[0].kind == Kind::symbol) return false;
  if (e.kind == Kind::symbol)
    for (std::size_t k = 0; k < rest_.size(); ++k)
      if (!rest_[k].empty() && model_.modes[k].coordinate == e.text) return true;
  return std::any_of(e.operands.begin(), e.operands.end(),
                     [&](const Expression& operand) { return moves(operand); });
}

void MovedFormulas::refuse_corner(const Expression& e, const FormulaSource& source) const {
  fail_at(source, e.place, e.text + " of a coordinate that does not rest at zero",
          "with reference = \"rest\" it is one of velocities and of coordinates that no constant force moves");
}

// Its value at rest, nothing for zero.
std::optional<Expression> MovedFormulas::at_rest(const Expression& e, const FormulaSource& source) {
  if (e.kind == Kind::number) return e;
  if (e.kind == Kind::symbol) {
    for (std::size_t k = 0; k < rest_.size(); ++k)
      if (model_.modes[k].coordinate == e.text)
        return rest_[k].empty() ? std::nullopt : std::optional(symbol(rest_[k], e.place));
    return moved_symbol(e);
  }
  if (is_derivative(e) || has_corner(e)) return std::nullopt;
  if (e.kind == Kind::call) {
    const std::optional<Expression> inside = at_rest(e.operands[0], source);
    if (!inside) return is_one_at_zero(e.text) ? std::optional(number(1, e.place)) : std::nullopt;
    if (e.text == "sqrt") return value_of(SmoothKind::power, {1, 2}, *inside, e.place);
    const std::optional<SmoothKind> kind = smooth_kind(e.text);
    return value_of(*kind, {1, 1}, *inside, e.place);
  }
  if (e.kind == Kind::power) {
    const std::pair<long, long> exponent = rational_exponent(e, source);
    std::optional<Expression> base = at_rest(e.operands[0], source);
    if (!base) return std::nullopt;
    if (exponent.second != 1) return value_of(SmoothKind::power, exponent, *base, e.place);
    return Expression{Kind::power, e.place, "^", {std::move(*base), e.operands[1]}};
  }
  Expression result = e;
  result.operands.clear();
  for (const Expression& operand : e.operands) {
    std::optional<Expression> value = at_rest(operand, source);
    if (!value && e.kind != Kind::sum) return std::nullopt;
    if (value) result.operands.push_back(std::move(*value));
  }
  if (result.operands.empty()) return std::nullopt;
  if (e.kind == Kind::sum && result.operands.size() == 1) return result.operands.front();
  return result;
}

// What it has beyond its value at rest.
Expression MovedFormulas::from_rest(const Expression& e, const FormulaSource& source) {
  if (e.kind == Kind::symbol && moves(e)) return e;
  if (e.kind == Kind::negation) return minus(from_rest(e.operands[0], source));
  const auto fixed = [&](const Expression& part) {
    const std::vector<std::string> names = identifiers(part);
    return std::none_of(names.begin(), names.end(), [&](const std::string& name) {
      return std::any_of(model_.modes.begin(), model_.modes.end(),
                         [&](const Mode& mode) { return mode.coordinate == name; });
    });
  };
  if (e.kind == Kind::sum) {
    Expression sum = e;
    sum.operands.clear();
    for (const Expression& operand : e.operands)
      if (!fixed(operand)) sum.operands.push_back(from_rest(operand, source));
    if (!sum.operands.empty()) return sum.operands.size() == 1 ? sum.operands.front() : sum;
  }
  if (e.kind == Kind::product || e.kind == Kind::quotient) {
    const auto moving = std::count_if(e.operands.begin(), e.operands.end(),
                                      [&](const Expression& operand) { return !fixed(operand); });
    if (moving == 1 && (e.kind == Kind::product || fixed(e.operands[1]))) {
      Expression whole = e;
      for (Expression& operand : whole.operands)
        operand = fixed(operand) ? moved(operand, source) : from_rest(operand, source);
      return whole;
    }
  }
  std::optional<Expression> value = at_rest(e, source);
  Expression whole = moved(e, source);
  return value ? sum_of(std::move(whole), minus(std::move(*value))) : whole;
}

// The symbol of a function's value. Sines and cosines come in pairs: each is the other's derivative.
Expression MovedFormulas::value_of(SmoothKind kind, std::pair<long, long> exponent, const Expression& argument,
                                   const SourcePlace& place) {
  const std::string text = expression_text(argument);
  const auto known = [&](SmoothKind wanted) {
    return std::find_if(values_.begin(), values_.end(), [&](const RestValue& value) {
      return value.kind == wanted && value.exponent == exponent && expression_text(value.argument) == text;
    });
  };
  const auto add = [&](SmoothKind added) {
    if (known(added) != values_.end()) return;
    const bool root = exponent == std::pair<long, long>(1, 2), power = added == SmoothKind::power;
    std::string name = !power ? std::string(name_of(added)) : root ? "sqrt" : "power";
    name += argument.kind == Kind::symbol && (root || !power) ? "_" + argument.text
                                                              : "_rest_" + std::to_string(values_.size() + 1);
    while (taken_.contains(name)) name += '_';
    values_.push_back({name, added, exponent, argument});
  };
  add(kind);
  if (const std::optional<SmoothKind> other = partner(kind)) add(*other);
  return symbol(known(kind)->name, place);
}

Expression MovedFormulas::moved_power(const Expression& e, std::pair<long, long> exponent,
                                      const FormulaSource& source) {
  const Expression& inside = e.operands[0];
  const std::optional<Expression> rest = at_rest(inside, source);
  if (!rest) return e;
  Expression ratio = sum_of(number(1, e.place), quotient_of(from_rest(inside, source), *rest));
  Expression power = e;
  power.operands[0] = std::move(ratio);
  return product_of(value_of(SmoothKind::power, exponent, *rest, e.place), std::move(power));
}

Expression MovedFormulas::moved_call(const Expression& e, const FormulaSource& source) {
  if (e.text == "sqrt") return moved_power(e, {1, 2}, source);
  const std::optional<Expression> rest = at_rest(e.operands[0], source);
  const auto of = [&](SmoothKind kind) { return value_of(kind, {1, 1}, *rest, e.place); };
  const auto beyond = [&](const char* function) { return call_of(function, from_rest(e.operands[0], source)); };
  if (!rest) return call_of(e.text, from_rest(e.operands[0], source));
  switch (*smooth_kind(e.text)) {
    case SmoothKind::sine:
      return sum_of(product_of(of(SmoothKind::sine), beyond("cos")),
                    product_of(of(SmoothKind::cosine), beyond("sin")));
    case SmoothKind::cosine:
      return sum_of(product_of(of(SmoothKind::cosine), beyond("cos")),
                    minus(product_of(of(SmoothKind::sine), beyond("sin"))));
    case SmoothKind::hyperbolic_sine:
      return sum_of(product_of(of(SmoothKind::hyperbolic_sine), beyond("cosh")),
                    product_of(of(SmoothKind::hyperbolic_cosine), beyond("sinh")));
    case SmoothKind::hyperbolic_cosine:
      return sum_of(product_of(of(SmoothKind::hyperbolic_cosine), beyond("cosh")),
                    product_of(of(SmoothKind::hyperbolic_sine), beyond("sinh")));
    case SmoothKind::exponential:
      return product_of(of(SmoothKind::exponential), beyond("exp"));
    case SmoothKind::tangent:
      return quotient_of(sum_of(of(SmoothKind::tangent), beyond("tan")),
                         sum_of(number(1, e.place), minus(product_of(of(SmoothKind::tangent), beyond("tan")))));
    case SmoothKind::hyperbolic_tangent:
      return quotient_of(
          sum_of(of(SmoothKind::hyperbolic_tangent), beyond("tanh")),
          sum_of(number(1, e.place), product_of(of(SmoothKind::hyperbolic_tangent), beyond("tanh"))));
    case SmoothKind::logarithm:
      return sum_of(
          of(SmoothKind::logarithm),
          call_of("log", sum_of(number(1, e.place), quotient_of(from_rest(e.operands[0], source), *rest))));
    case SmoothKind::arc_tangent:
    case SmoothKind::power:
      break;
  }
  fail_at(source, e.place, e.text + " of a coordinate that does not rest at zero",
          "its addition theorem has branches: only sin, cos, tan, exp, sinh, cosh, tanh, log, sqrt, powers and "
          "quotients move with the rest position");
}

}  // namespace secular
