#include "perturb/expression_text.hpp"

namespace secular {
namespace {

enum class Binding { sum, product, power, atom };

Binding binding(const Expression& e) {
  switch (e.kind) {
    case Expression::Kind::sum:
    case Expression::Kind::negation:
      return Binding::sum;
    case Expression::Kind::product:
    case Expression::Kind::quotient:
      return Binding::product;
    case Expression::Kind::power:
      return Binding::power;
    default:
      return Binding::atom;
  }
}

// In parentheses where it binds less tightly than `needed`.
std::string within(const Expression& e, Binding needed) {
  const std::string text = expression_text(e);
  return binding(e) < needed ? "(" + text + ")" : text;
}

}  // namespace

std::string expression_text(const Expression& e) {
  std::string text;
  switch (e.kind) {
    case Expression::Kind::number:
    case Expression::Kind::symbol:
      return e.text;
    case Expression::Kind::sum:
      for (const Expression& operand : e.operands) {
        const bool minus = operand.kind == Expression::Kind::negation;
        const std::string part =
            minus ? within(operand.operands[0], Binding::product) : within(operand, Binding::sum);
        text += text.empty() ? (minus ? "-" : "") : (minus ? " - " : " + ");
        text += part;
      }
      return text;
    case Expression::Kind::product:
      for (const Expression& operand : e.operands)
        text += (text.empty() ? "" : "*") + within(operand, text.empty() ? Binding::product : Binding::power);
      return text;
    case Expression::Kind::quotient:
      return within(e.operands[0], Binding::product) + "/" + within(e.operands[1], Binding::power);
    case Expression::Kind::power:
      return within(e.operands[0], Binding::atom) + "^" + within(e.operands[1], Binding::atom);
    case Expression::Kind::negation:
      return "-" + within(e.operands[0], Binding::product);
    case Expression::Kind::call:
      break;
  }
  for (const Expression& operand : e.operands) text += (text.empty() ? "" : ", ") + expression_text(operand);
  return e.text + "(" + text + ")";
}

}  // namespace secular
