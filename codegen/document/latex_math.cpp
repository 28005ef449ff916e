#include "codegen/document/latex_math.hpp"

#include <fmt/format.h>

#include "codegen/document/symbol_name.hpp"

namespace secular::typeset {
namespace {

using Kind = Expression::Kind;

std::string base_latex(const NamePart& part, bool subscript) {
  switch (part.kind) {
    case NamePart::Kind::greek:
      return "\\" + std::string(greek_letter(part.text)->latex);
    case NamePart::Kind::word:
      return fmt::format("\\{}{{{}}}", subscript ? "mathrm" : "mathit", part.text);
    case NamePart::Kind::verbatim:
      return "\\texttt{" + latex_text(part.text) + "}";
    case NamePart::Kind::letter:
    case NamePart::Kind::number:
      return part.text;
  }
  return part.text;
}

std::string subscripts_latex(const SymbolName& name);

std::string name_latex(const SymbolName& name, bool subscript) {
  return base_latex(name.base, subscript) + subscripts_latex(name);
}

std::string subscripts_latex(const SymbolName& name) {
  if (name.subscripts.empty()) return {};
  std::string list;
  for (const SymbolName& subscript : name.subscripts)
    list += (list.empty() ? "" : ",") + name_latex(subscript, true);
  return "_{" + list + "}";
}

std::string accent_latex(const Expression& formula) {
  const SymbolName name = name_of(formula.parts[0]);
  const std::string command = formula.text == "bar" ? "overline" : formula.text;
  return fmt::format("\\{}{{{}}}{}", command, base_latex(name.base, false), subscripts_latex(name));
}

// A command that ends in a letter would swallow a letter after it.
std::string joined(const std::string& left, const std::string& right) {
  return left.empty() ? right : left + " " + right;
}

std::string product_latex(const std::vector<Expression>& factors) {
  std::string text;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    if (i > 0 && (is_word(factors[i]) || is_word(factors[i - 1]))) text += " \\,";
    text = joined(text, latex_math(factors[i]));
  }
  return text;
}

std::string sum_latex(const Expression& formula) {
  std::string text;
  for (std::size_t i = 0; i < formula.parts.size(); ++i) {
    const bool negative = formula.negative[i];
    text += i > 0 ? (negative ? " - " : " + ") : (negative ? "-" : "");
    text += latex_math(formula.parts[i]);
  }
  return text;
}

std::string delimited(const char* left, const Expression& inner, const char* right) {
  const bool tall = is_tall(inner);
  return fmt::format("{}{}{}{}{}", tall ? "\\left" : "", left, latex_math(inner), tall ? "\\right" : "", right);
}

}  // namespace

std::string latex_symbol(std::string_view identifier) {
  return name_latex(symbol_name(identifier), false);
}

std::string latex_math(const Expression& formula) {
  switch (formula.kind) {
    case Kind::number:
      return formula.text;
    case Kind::symbol:
      return name_latex(name_of(formula), false);
    case Kind::constant:
      return formula.text == "partial" ? "\\partial" : "\\mathrm{" + formula.text + "}";
    case Kind::words:
      return "\\text{" + latex_text(formula.text) + "}";
    case Kind::indexed: {
      std::string subscripts;
      for (std::size_t i = 1; i < formula.parts.size(); ++i)
        subscripts += (i > 1 ? "," : "") + latex_math(formula.parts[i]);
      return fmt::format("{}_{{{}}}", latex_math(formula.parts[0]), subscripts);
    }
    case Kind::accent:
      return accent_latex(formula);
    case Kind::product:
      return product_latex(formula.parts);
    case Kind::fraction:
      return fmt::format("\\frac{{{}}}{{{}}}", latex_math(formula.parts[0]), latex_math(formula.parts[1]));
    case Kind::power:
      if (formula.parts[0].kind == Kind::function) {
        const Expression& f = formula.parts[0];
        const std::string name = f.text == "sgn" ? "\\operatorname{sgn}" : "\\" + f.text;
        return fmt::format("{}^{{{}}}{}", name, formula.exponent, delimited("(", f.parts[0], ")"));
      }
      return fmt::format("{}^{{{}}}", latex_math(formula.parts[0]), formula.exponent);
    case Kind::sum:
      return sum_latex(formula);
    case Kind::bracket:
      return delimited("(", formula.parts[0], ")");
    case Kind::modulus:
      return delimited("\\lvert ", formula.parts[0], "\\rvert ");
    case Kind::mean:
      return delimited("\\langle ", formula.parts[0], "\\rangle ");
    case Kind::root:
      return "\\sqrt{" + latex_math(formula.parts[0]) + "}";
    case Kind::function:
      return (formula.text == "sgn" ? "\\operatorname{sgn}" : "\\" + formula.text) +
             delimited("(", formula.parts[0], ")");
    case Kind::exponential:
      return "\\mathrm{e}^{" + latex_math(formula.parts[0]) + "}";
  }
  return {};
}

std::string latex_math(const Piece& piece, bool first) {
  std::string text;
  const Element* before = nullptr;
  for (const Element& element : piece.elements) {
    switch (element.kind) {
      case Element::Kind::plus:
        text = joined(text, "+");
        break;
      case Element::Kind::minus:
        text = joined(text, text.empty() && first ? "{-}" : "-");  // a sign, no operator, behind an alignment mark
        break;
      case Element::Kind::open:
        text = joined(text, element.tall ? "\\biggl(" : "\\bigl(");
        break;
      case Element::Kind::close:
        text += element.tall ? "\\biggr)" : "\\bigr)";
        if (element.exponent != 1) text += fmt::format("^{{{}}}", element.exponent);
        break;
      case Element::Kind::expression:
        if (before != nullptr && before->kind == Element::Kind::expression &&
            (is_word(before->expression) || is_word(element.expression)))
          text += " \\,";
        text = joined(text, latex_math(element.expression));
        break;
    }
    before = &element;
  }
  return text;
}

}  // namespace secular::typeset
