#include "codegen/document/mathml.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "codegen/document/symbol_name.hpp"
#include "input/markup.hpp"

namespace secular::typeset {
namespace {

using Kind = Expression::Kind;

constexpr std::string_view thin_space_tag = "<mspace width=\"0.17em\"></mspace>";
constexpr const char* comma = "<mo separator=\"true\">,</mo>";
constexpr std::string_view minus_sign = "\u2212";

std::string element(std::string_view name, std::string_view content) {
  return fmt::format("<{0}>{1}</{0}>", name, content);
}

std::string base_mathml(const NamePart& part, bool subscript) {
  switch (part.kind) {
    case NamePart::Kind::greek:
      return element("mi", greek_letter(part.text)->utf8);
    case NamePart::Kind::number:
      return element("mn", part.text);
    case NamePart::Kind::word:
      return subscript ? element("mi", escape_markup(part.text))
                       : fmt::format("<mi class=\"word\">{}</mi>", escape_markup(part.text));
    case NamePart::Kind::verbatim:
      return fmt::format("<mi class=\"verbatim\">{}</mi>", escape_markup(part.text));
    case NamePart::Kind::letter:
      break;
  }
  return element("mi", escape_markup(part.text));
}

// Base with what its subscripts and power make of it.
struct Scripted {
  std::string base, below, above;
  std::string text() const {
    if (below.empty() && above.empty()) return base;
    if (above.empty()) return element("msub", base + below);
    if (below.empty()) return element("msup", base + above);
    return element("msubsup", base + below + above);
  }
};

Scripted scripted(const SymbolName& name, bool subscript) {
  Scripted result{base_mathml(name.base, subscript), {}, {}};
  for (const SymbolName& one : name.subscripts)
    result.below += (result.below.empty() ? "" : comma) + scripted(one, true).text();
  if (name.subscripts.size() > 1) result.below = element("mrow", result.below);
  return result;
}

std::string_view accent_mark(const std::string& name) {
  if (name == "bar") return "\u00AF";
  if (name == "dot") return "\u02D9";
  if (name == "ddot") return "\u00A8";
  return "\u02C6";
}

Scripted scripted(const Expression& formula) {
  if (formula.kind == Kind::symbol) return scripted(name_of(formula), false);
  if (formula.kind == Kind::accent) {
    Scripted name = scripted(name_of(formula.parts[0]), false);
    name.base = fmt::format("<mover accent=\"true\">{}<mo stretchy=\"false\">{}</mo></mover>", name.base,
                            accent_mark(formula.text));
    return name;
  }
  if (formula.kind == Kind::indexed) {
    Scripted name{mathml(formula.parts[0]), {}, {}};
    for (std::size_t i = 1; i < formula.parts.size(); ++i)
      name.below += (i > 1 ? comma : "") + mathml(formula.parts[i]);
    name.below = element("mrow", name.below);
    return name;
  }
  return {mathml(formula), {}, {}};
}

bool needs_space(const Expression& left, const Expression& right) {
  return is_word(left) || is_word(right) || left.kind == Kind::function || right.kind == Kind::function;
}

std::string operator_mathml(bool negative, std::string_view attributes) {
  return fmt::format("<mo {}>{}</mo>", attributes, negative ? minus_sign : std::string_view("+"));
}

constexpr std::string_view infix = "form=\"infix\"", prefix = "form=\"prefix\"",
                           infix_after_gap = "form=\"infix\" lspace=\"0\"";  // the gap is between two <math>

std::string row(std::string_view content) {
  return element("mrow", content);
}

std::string product_mathml(const std::vector<Expression>& factors) {
  std::string text;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    if (i > 0 && needs_space(factors[i - 1], factors[i])) text += thin_space_tag;
    text += mathml(factors[i]);
  }
  return row(text);
}

std::string sum_mathml(const Expression& formula) {
  std::string text;
  for (std::size_t i = 0; i < formula.parts.size(); ++i) {
    if (i > 0 || formula.negative[i]) text += operator_mathml(formula.negative[i], i > 0 ? infix : prefix);
    text += mathml(formula.parts[i]);
  }
  return row(text);
}

// Some fonts have looser brackets where they may stretch, so that only tall formulas ask for it.
std::string fence(std::string_view sign, bool opening, bool tall) {
  return fmt::format("<mo form=\"{}\" stretchy=\"{}\">{}</mo>", opening ? "prefix" : "postfix", tall, sign);
}

std::string fenced(std::string_view left, const Expression& inner, std::string_view right) {
  const bool tall = is_tall(inner);
  return row(fence(left, true, tall) + mathml(inner) + fence(right, false, tall));
}

// A bracket whose partner stands in another <math>: it has nothing to stretch to.
std::string lone_bracket(const Element& bracket, bool opening) {
  return fmt::format("<mo form=\"{}\" {}>{}</mo>", opening ? "prefix" : "postfix",
                     bracket.tall ? "stretchy=\"true\" minsize=\"2.4em\"" : "stretchy=\"false\"",
                     opening ? "(" : ")");
}

std::string function_mathml(const Expression& formula, std::string_view name) {
  return row(std::string(name) + "<mo>\u2061</mo>" + fenced("(", formula.parts[0], ")"));
}

}  // namespace

std::string mathml(const Expression& formula) {
  switch (formula.kind) {
    case Kind::number:
      return element("mn", formula.text);
    case Kind::symbol:
    case Kind::indexed:
    case Kind::accent:
      return scripted(formula).text();
    case Kind::constant:
      return fmt::format("<mi mathvariant=\"normal\">{}</mi>",
                         formula.text == "partial" ? std::string("\u2202") : formula.text);
    case Kind::words:
      return element("mtext", escape_markup(formula.text));
    case Kind::product:
      return product_mathml(formula.parts);
    case Kind::fraction:
      return element("mfrac", mathml(formula.parts[0]) + mathml(formula.parts[1]));
    case Kind::power: {
      const std::string exponent = element("mn", std::to_string(formula.exponent));
      const Expression& base = formula.parts[0];
      if (base.kind == Kind::function)
        return function_mathml(base, element("msup", element("mi", base.text) + exponent));
      Scripted name = scripted(base);
      name.above = exponent;
      return name.text();
    }
    case Kind::sum:
      return sum_mathml(formula);
    case Kind::bracket:
      return fenced("(", formula.parts[0], ")");
    case Kind::modulus:
      return fenced("|", formula.parts[0], "|");
    case Kind::mean:
      return fenced("\u27E8", formula.parts[0], "\u27E9");
    case Kind::root:
      return element("msqrt", mathml(formula.parts[0]));
    case Kind::function:
      return function_mathml(formula, element("mi", formula.text));
    case Kind::exponential:
      return element("msup", "<mi mathvariant=\"normal\">e</mi>" + mathml(formula.parts[0]));
  }
  return {};
}

std::string mathml(const Piece& piece, bool first) {
  std::string text;
  const Element* before = nullptr;
  for (const Element& element_of_piece : piece.elements) {
    switch (element_of_piece.kind) {
      case Element::Kind::plus:
      case Element::Kind::minus:
        text += operator_mathml(element_of_piece.kind == Element::Kind::minus,
                                text.empty() && !first ? infix_after_gap : prefix);
        break;
      case Element::Kind::open:
        text += lone_bracket(element_of_piece, true);
        break;
      case Element::Kind::close: {
        const std::string bracket = lone_bracket(element_of_piece, false);
        text += element_of_piece.exponent == 1
                    ? bracket
                    : element("msup", bracket + element("mn", std::to_string(element_of_piece.exponent)));
        break;
      }
      case Element::Kind::expression:
        if (before != nullptr && before->kind == Element::Kind::expression &&
            needs_space(before->expression, element_of_piece.expression))
          text += thin_space_tag;
        text += mathml(element_of_piece.expression);
        break;
    }
    before = &element_of_piece;
  }
  return text;
}

}  // namespace secular::typeset
