#include "codegen/document/typeset.hpp"

#include <algorithm>
#include <utility>

#include "codegen/canonical/polar_form.hpp"

namespace secular::typeset {
namespace {

using Kind = Expression::Kind;

Expression of_kind(Kind kind, std::string text, std::vector<Expression> parts = {}) {
  return {kind, std::move(text), std::move(parts), {}, 1, false};
}

Expression product_of(std::vector<Expression> factors) {
  if (factors.empty()) return number(1);
  if (factors.size() == 1) return std::move(factors.front());
  for (Expression& factor : factors)
    if (factor.kind == Kind::sum) factor = bracket(std::move(factor));
  return of_kind(Kind::product, {}, std::move(factors));
}

bool is_negative(const PolynomialTerm& term) {
  return term.coefficient.front() == '-';
}

// Digits, pi, i, then the other symbols in their order; no sign.
Expression monomial(const PolynomialTerm& term, const SymbolOrder& order, bool imaginary) {
  const std::string digits = is_negative(term) ? term.coefficient.substr(1) : term.coefficient;
  std::vector<Expression> factors;
  if (digits != "1") factors.push_back(of_kind(Kind::number, digits));
  const auto add = [&](std::size_t i) {
    if (term.exponents[i] != 0) factors.push_back(power(symbol(order[i]), term.exponents[i]));
  };
  for (std::size_t i = 0; i < term.exponents.size(); ++i)
    if (order[i] == "pi") add(i);
  if (imaginary) factors.push_back(constant("i"));
  for (std::size_t i = 0; i < term.exponents.size(); ++i)
    if (order[i] != "pi") add(i);
  return product_of(std::move(factors));
}

Expression polynomial(const std::vector<PolynomialTerm>& terms, const SymbolOrder& order) {
  Expression sum = of_kind(Kind::sum, {});
  for (const PolynomialTerm& term : terms) {
    sum.parts.push_back(monomial(term, order, false));
    sum.negative.push_back(is_negative(term));
  }
  return terms.size() == 1 && !sum.negative.front() ? sum.parts.front() : sum;
}

void append_factors(std::vector<Expression>& factors, Expression expression) {
  if (expression.kind == Kind::product)
    for (Expression& part : expression.parts) factors.push_back(std::move(part));
  else
    factors.push_back(std::move(expression));
}

}  // namespace

Expression number(long value) {
  return of_kind(Kind::number, std::to_string(value));
}
Expression symbol(std::string identifier) {
  return of_kind(Kind::symbol, std::move(identifier));
}
Expression constant(std::string name) {
  return of_kind(Kind::constant, std::move(name));
}
Expression words(std::string text) {
  return of_kind(Kind::words, std::move(text));
}
Expression indexed(Expression symbol, std::vector<Expression> subscripts) {
  subscripts.insert(subscripts.begin(), std::move(symbol));
  return of_kind(Kind::indexed, {}, std::move(subscripts));
}
Expression accent(std::string mark, Expression symbol) {
  return of_kind(Kind::accent, std::move(mark), {std::move(symbol)});
}
Expression fraction(Expression above, Expression below) {
  return of_kind(Kind::fraction, {}, {std::move(above), std::move(below)});
}
Expression bracket(Expression inner) {
  return of_kind(Kind::bracket, {}, {std::move(inner)});
}
Expression modulus(Expression inner) {
  return of_kind(Kind::modulus, {}, {std::move(inner)});
}
Expression mean(Expression inner) {
  return of_kind(Kind::mean, {}, {std::move(inner)});
}
Expression root(Expression inner) {
  return of_kind(Kind::root, {}, {std::move(inner)});
}
Expression function(std::string name, Expression argument) {
  return of_kind(Kind::function, std::move(name), {std::move(argument)});
}
Expression exponential(Expression exponent) {
  return of_kind(Kind::exponential, {}, {std::move(exponent)});
}

Expression power(Expression base, int exponent) {
  if (exponent == 1) return base;
  if (base.kind == Kind::sum || base.kind == Kind::product || base.kind == Kind::fraction)
    base = bracket(std::move(base));
  Expression result = of_kind(Kind::power, {}, {std::move(base)});
  result.exponent = exponent;
  return result;
}

SymbolName name_of(const Expression& symbol) {
  return symbol.verbatim ? verbatim_name(symbol.text) : symbol_name(symbol.text);
}

bool is_word(const Expression& formula) {
  if (formula.kind == Kind::power) return is_word(formula.parts[0]);
  if (formula.kind != Kind::symbol) return formula.kind == Kind::words;
  const NamePart::Kind base = name_of(formula).base.kind;
  return base == NamePart::Kind::word || base == NamePart::Kind::verbatim;
}

bool is_tall(const Expression& formula) {
  if (formula.kind == Kind::exponential || formula.kind == Kind::indexed) return false;
  return formula.kind == Kind::fraction || std::any_of(formula.parts.begin(), formula.parts.end(), is_tall);
}

Expression rate_of(Expression quantity) {
  return fraction(product_of({constant("d"), std::move(quantity)}), product_of({constant("d"), symbol("t")}));
}

Product& Product::times(Expression factor, int exponent) {
  if (exponent == 1)
    append_factors(above_, std::move(factor));
  else if (exponent > 0)
    above_.push_back(power(std::move(factor), exponent));
  if (exponent < 0) below_.push_back(power(std::move(factor), -exponent));
  return *this;
}

Expression Product::expression() const {
  return below_.empty() ? product_of(above_) : fraction(product_of(above_), product_of(below_));
}

Sum& Sum::add(Expression term, bool negative) {
  sum_.parts.push_back(term.kind == Kind::sum ? bracket(std::move(term)) : std::move(term));
  sum_.negative.push_back(negative);
  return *this;
}

Sum& Sum::add(const RationalFunction& coefficient, const Product& factors, bool imaginary) {
  if (coefficient.is_zero()) return *this;
  const std::vector<Fraction> parts = fractions(coefficient);
  if (parts.size() == 1) return add(parts.front(), factors, imaginary);
  if (factors.empty() && !imaginary) {
    for (const Fraction& part : parts) add(part, factors, false);
    return *this;
  }
  Sum bracketed(*order_);
  for (const Fraction& part : parts) bracketed.add(part, {}, false);
  std::vector<Expression> product;
  if (imaginary) product.push_back(constant("i"));
  product.push_back(bracketed.expression());
  if (!factors.empty()) append_factors(product, factors.expression());
  return add(product_of(std::move(product)), false);
}

Sum& Sum::add(const Fraction& value, const Product& factors, bool imaginary) {
  if (factors.empty() && !imaginary && value.is_plain()) {
    for (const PolynomialTerm& term : value.numerator) add(monomial(term, *order_, false), is_negative(term));
    return *this;
  }
  const bool negative = is_negative(value.numerator.front());
  std::vector<PolynomialTerm> numerator = value.numerator;
  if (negative)
    for (PolynomialTerm& term : numerator)
      term.coefficient = is_negative(term) ? term.coefficient.substr(1) : "-" + term.coefficient;
  const bool single = numerator.size() == 1;
  std::vector<Expression> product;
  if (imaginary && !single) product.push_back(constant("i"));
  Expression above = single ? monomial(numerator.front(), *order_, imaginary) : polynomial(numerator, *order_);
  if (!value.is_plain()) {
    Product below;
    if (value.divisors.empty() || !Fraction{{}, value.denominator, {}}.is_plain())
      below.times(polynomial(value.denominator, *order_));
    for (const auto& [sum, power] : value.divisors) below.times(polynomial(*sum, *order_), power);
    product.push_back(fraction(std::move(above), below.expression()));
  } else if (above != number(1)) {
    append_factors(product, std::move(above));
  }
  if (!factors.empty()) append_factors(product, factors.expression());
  return add(product_of(std::move(product)), negative);
}

Expression Sum::expression() const {
  if (sum_.parts.empty()) return number(0);
  return sum_.parts.size() == 1 && !sum_.negative.front() ? sum_.parts.front() : sum_;
}

Expression expression_of(const RationalFunction& value, const SymbolOrder& order) {
  return Sum(order).add(value).expression();
}

}  // namespace secular::typeset
