#include "codegen/document/plain_text.hpp"

namespace secular::typeset {
namespace {

using Kind = Expression::Kind;

std::string in_brackets(const Expression& formula) {
  return "(" + plain_text(formula) + ")";
}

bool is_constant(const Expression& formula, const char* name) {
  return formula.kind == Kind::constant && formula.text == name;
}

// d(...) of a derivative's numerator or denominator: "dx", "d(dx/dt)"; empty if it is none.
std::string differential(const Expression& formula) {
  if (formula.kind != Kind::product || formula.parts.size() != 2) return {};
  if (!is_constant(formula.parts[0], "d") && !is_constant(formula.parts[0], "partial")) return {};
  const Expression& quantity = formula.parts[1];
  if (quantity.kind == Kind::accent && quantity.text == "dot")
    return "d(d" + plain_text(quantity.parts[0]) + "/dt)";
  return "d" + (quantity.kind == Kind::symbol ? quantity.text : in_brackets(quantity));
}

std::string fraction_text(const Expression& above, const Expression& below) {
  if (const std::string left = differential(above), right = differential(below); !left.empty() && !right.empty())
    return left + "/" + right;
  const bool simple = below.kind == Kind::number || below.kind == Kind::symbol || below.kind == Kind::power ||
                      below.kind == Kind::bracket || below.kind == Kind::root || below.kind == Kind::function;
  return (above.kind == Kind::sum ? in_brackets(above) : plain_text(above)) + "/" +
         (simple ? plain_text(below) : in_brackets(below));
}

}  // namespace

std::string plain_text(const Expression& formula) {
  switch (formula.kind) {
    case Kind::number:
    case Kind::constant:
    case Kind::words:
      return formula.text;
    case Kind::symbol:
      return formula.text == "pi" ? "Pi" : formula.text;
    case Kind::indexed: {
      std::string subscripts;
      for (std::size_t i = 1; i < formula.parts.size(); ++i)
        subscripts += (i > 1 ? ", " : "") + plain_text(formula.parts[i]);
      return plain_text(formula.parts[0]) + "[" + subscripts + "]";
    }
    case Kind::accent:
      if (formula.text == "dot") return "D(" + plain_text(formula.parts[0]) + ")";
      if (formula.text == "ddot") return "D2(" + plain_text(formula.parts[0]) + ")";
      return (formula.text == "bar" ? "conj(" : formula.text + "(") + plain_text(formula.parts[0]) + ")";
    case Kind::product: {
      std::string text;
      for (const Expression& factor : formula.parts) text += (text.empty() ? "" : "*") + plain_text(factor);
      return text;
    }
    case Kind::fraction:
      return fraction_text(formula.parts[0], formula.parts[1]);
    case Kind::power: {
      const Kind base = formula.parts[0].kind;
      const bool simple = base == Kind::number || base == Kind::symbol || base == Kind::constant ||
                          base == Kind::bracket || base == Kind::function || base == Kind::modulus ||
                          base == Kind::accent || base == Kind::root;
      return (simple ? plain_text(formula.parts[0]) : in_brackets(formula.parts[0])) + "^" +
             std::to_string(formula.exponent);
    }
    case Kind::sum: {
      std::string text;
      for (std::size_t i = 0; i < formula.parts.size(); ++i) {
        text += i > 0 ? (formula.negative[i] ? " - " : " + ") : (formula.negative[i] ? "-" : "");
        text += plain_text(formula.parts[i]);
      }
      return text;
    }
    case Kind::bracket:
      return in_brackets(formula.parts[0]);
    case Kind::modulus:
      return "abs(" + plain_text(formula.parts[0]) + ")";
    case Kind::mean:
      return "mean[" + plain_text(formula.parts[0]) + "]";
    case Kind::root:
      return "sqrt(" + plain_text(formula.parts[0]) + ")";
    case Kind::function:
      return formula.text + "(" + plain_text(formula.parts[0]) + ")";
    case Kind::exponential:
      return "exp(" + plain_text(formula.parts[0]) + ")";
  }
  return {};
}

}  // namespace secular::typeset
