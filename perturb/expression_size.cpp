#include "perturb/expression_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace secular {
namespace {

// Guards, no statements about models: a formula of a structure has some tens of terms of degree below ten (a
// quintic spring between ten modes 2002), and numbers of double precision. What stays below all three comes to an
// end within minutes, most of it at once.
constexpr double most_terms_by_degree = 5e4;
constexpr double highest_degree = 512;
constexpr double most_digits = 4000;

/// Bounds of a formula that is multiplied out.
struct Size {
  double terms = 1;
  double degree = 0;  ///< in all symbols together
  double digits = 0;  ///< of its largest number, numerator or denominator
};

// A formula of numbers alone; NaN with symbols.
double constant_value(const Expression& e) {
  const auto operand = [&](std::size_t i) { return constant_value(e.operands[i]); };
  double value = e.kind == Expression::Kind::product ? 1 : 0;
  switch (e.kind) {
    case Expression::Kind::number:
      return std::strtod(e.text.c_str(), nullptr);
    case Expression::Kind::sum:
      for (std::size_t i = 0; i < e.operands.size(); ++i) value += operand(i);
      return value;
    case Expression::Kind::product:
      for (std::size_t i = 0; i < e.operands.size(); ++i) value *= operand(i);
      return value;
    case Expression::Kind::quotient:
      return operand(0) / operand(1);
    case Expression::Kind::power:
      return std::pow(operand(0), operand(1));
    case Expression::Kind::negation:
      return -operand(0);
    default:
      return std::numeric_limits<double>::quiet_NaN();
  }
}

double digits_of(const std::string& number) {
  const std::size_t mark = std::min(number.find_first_of("eE"), number.size());
  const double exponent = mark < number.size() ? std::strtod(number.c_str() + mark + 1, nullptr) : 0;
  return static_cast<double>(mark) + std::abs(exponent);
}

// Of the n-th power of a sum of so many terms: (terms + n - 1 over n).
double terms_of_power(double terms, double n) {
  if (terms <= 1) return 1;
  return std::exp(std::lgamma(terms + n) - std::lgamma(n + 1) - std::lgamma(terms));
}

class Measure {
 public:
  explicit Measure(const FormulaSource& source) : source_(source) {}

  Size of(const Expression& e) const {
    const Size size = unchecked(e);
    if (size.terms * std::max(1.0, size.degree) > most_terms_by_degree)
      fail_at(source_, e.place,
              fmt::format("has {:.3g} terms of degree {:g} when it is multiplied out", size.terms, size.degree),
              "lower its powers, or name a part of it by a symbol");
    if (size.degree > highest_degree)
      fail_at(source_, e.place, fmt::format("has a degree beyond {}", highest_degree), "lower its powers");
    if (size.digits > most_digits)
      fail_at(source_, e.place, fmt::format("has a number of more than {} digits", most_digits),
              "numbers of double precision are enough");
    return size;
  }

 private:
  Size unchecked(const Expression& e) const {
    Size size;
    switch (e.kind) {
      case Expression::Kind::number:
        size.digits = digits_of(e.text);
        return size;
      case Expression::Kind::symbol:
        size.degree = 1;
        return size;
      case Expression::Kind::sum:
        return sum(e);
      case Expression::Kind::product:
      case Expression::Kind::quotient:
        return product(e);
      case Expression::Kind::power:
        return power(e);
      case Expression::Kind::negation:
        return of(e.operands[0]);
      case Expression::Kind::call:
        return call(e);
    }
    return size;
  }

  Size sum(const Expression& e) const {
    Size size{0, 0, 0};
    for (const Expression& operand : e.operands) {
      const Size part = of(operand);
      size.terms += part.terms;
      size.degree = std::max(size.degree, part.degree);
      size.digits = std::max(size.digits, part.digits);
    }
    return size;
  }

  Size product(const Expression& e) const {
    Size size;
    for (const Expression& operand : e.operands) {
      const Size part = of(operand);
      size.terms *= part.terms;
      size.degree += part.degree;
      size.digits += part.digits;
    }
    return size;
  }

  Size power(const Expression& e) const {
    const Size base = of(e.operands[0]);
    of(e.operands[1]);
    const double exponent = std::abs(constant_value(e.operands[1]));
    if (std::isnan(exponent)) return base;  // refused as no integer, with a better message
    return {terms_of_power(base.terms, exponent), exponent * base.degree, exponent * base.digits};
  }

  // A derivative with respect to a time: each factor of a term in turn. Of a printed source also the complex
  // conjugate beside what it is of.
  Size call(const Expression& e) const {
    Size size = sum(e);
    if (e.text == "D" || e.text == "D0" || e.text == "D1") size.terms *= std::max(1.0, size.degree);
    if (e.text == "D2") size.terms *= std::pow(std::max(1.0, size.degree), 2);
    if (e.text == "cc") size.terms *= 2;
    return size;
  }

  const FormulaSource& source_;
};

}  // namespace

void refuse_out_of_proportion(const Expression& expression, const FormulaSource& source) {
  Measure(source).of(expression);
}

}  // namespace secular
