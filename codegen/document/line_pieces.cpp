#include "codegen/document/line_pieces.hpp"

#include <algorithm>
#include <utility>

namespace secular::typeset {
namespace {

using Kind = Expression::Kind;

constexpr double thin_space = 0.17, fixed_pitch = 0.53, digit = 0.5, letter_width = 0.6, bracket_width = 0.6,
                 binary_operator = 1.25, script_scale = 0.72;

double name_width(const SymbolName& name) {
  const double wide = name.base.kind == NamePart::Kind::number     ? digit
                      : name.base.kind == NamePart::Kind::verbatim ? fixed_pitch
                                                                   : letter_width;
  const bool one_sign = name.base.kind == NamePart::Kind::letter || name.base.kind == NamePart::Kind::greek;
  double width = one_sign ? letter_width : wide * static_cast<double>(name.base.text.size());
  for (const SymbolName& subscript : name.subscripts) width += script_scale * (name_width(subscript) + 0.1);
  return width;
}

class Cutter {
 public:
  explicit Cutter(double widest) : widest_(widest) {}

  void sum(const Expression& formula) {
    if (formula.kind != Kind::sum) return term(formula, widest_);
    for (std::size_t i = 0; i < formula.parts.size(); ++i) {
      const bool negative = formula.negative[i];
      if (i > 0) {
        pieces_.emplace_back();
        add({negative ? Element::Kind::minus : Element::Kind::plus, {}, false, 1}, binary_operator);
      } else if (negative) {
        add({Element::Kind::minus, {}, false, 1}, binary_operator);
      }
      term(formula.parts[i], widest_);
    }
  }

  std::vector<Piece> pieces() && { return std::move(pieces_); }

 private:
  void add(Element element, double width) {
    pieces_.back().elements.push_back(std::move(element));
    pieces_.back().width += width;
  }

  void opened(const Expression& inner, int exponent) {
    const bool tall = is_tall(inner);
    add({Element::Kind::open, {}, tall, 1}, bracket_width);
    sum(inner);
    add({Element::Kind::close, {}, tall, exponent}, bracket_width);
  }

  void term(const Expression& formula, double limit) {
    const double width = estimated_width(formula);
    if (width <= limit) return add({Element::Kind::expression, formula, false, 1}, width);
    if (formula.kind == Kind::product) {
      // A factor stays whole where the others leave room for it.
      for (const Expression& factor : formula.parts)
        term(factor, std::max(widest_ / 4, limit - (width - estimated_width(factor))));
    } else if (formula.kind == Kind::bracket) {
      opened(formula.parts[0], 1);
    } else if (formula.kind == Kind::power && formula.parts[0].kind == Kind::bracket) {
      opened(formula.parts[0].parts[0], formula.exponent);
    } else if (formula.kind == Kind::fraction) {
      opened_fraction(formula.parts[0], formula.parts[1], limit);
    } else if (formula.kind == Kind::sum) {
      opened(formula, 1);
    } else {
      add({Element::Kind::expression, formula, false, 1}, width);
    }
  }

  void opened_fraction(const Expression& above, const Expression& below, double limit) {
    if (estimated_width(fraction(number(1), below)) > limit) {
      if (above != number(1)) term(above.kind == Kind::sum ? bracket(above) : above, limit);
      opened(below, -1);
    } else {
      if (above != number(1)) term(fraction(number(1), below), limit);
      term(above.kind == Kind::sum ? bracket(above) : above, limit);
    }
  }

  double widest_;
  std::vector<Piece> pieces_{1};
};

}  // namespace

double estimated_width(const Expression& formula) {
  double parts = 0;
  for (const Expression& part : formula.parts) parts += estimated_width(part);
  switch (formula.kind) {
    case Kind::number:
    case Kind::words:
      return digit * static_cast<double>(formula.text.size());
    case Kind::symbol:
      return name_width(name_of(formula));
    case Kind::constant:
      return digit;
    case Kind::indexed: {
      const double base = estimated_width(formula.parts[0]),
                   commas = 0.3 * static_cast<double>(formula.parts.size());
      return base + script_scale * (parts - base + commas);
    }
    case Kind::accent:
    case Kind::product:
      for (std::size_t i = 1; i < formula.parts.size(); ++i)
        if (is_word(formula.parts[i - 1]) || is_word(formula.parts[i])) parts += thin_space;
      return parts;
    case Kind::fraction:
      return std::max(estimated_width(formula.parts[0]), estimated_width(formula.parts[1])) + 0.3;
    case Kind::power:
      return parts + script_scale * digit * static_cast<double>(std::to_string(formula.exponent).size());
    case Kind::sum:
      return parts + binary_operator * static_cast<double>(formula.parts.size());
    case Kind::bracket:
    case Kind::modulus:
    case Kind::mean:
      return parts + 2 * bracket_width;
    case Kind::root:
      return parts + 1;
    case Kind::function:
      return parts + 2 * bracket_width + digit * static_cast<double>(formula.text.size());
    case Kind::exponential:
      return digit + script_scale * parts;
  }
  return parts;
}

std::vector<Piece> line_pieces(const Expression& formula, double widest) {
  Cutter cutter(widest);
  cutter.sum(formula);
  return std::move(cutter).pieces();
}

}  // namespace secular::typeset
