#include "codegen/expression/cpp_expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <utility>

namespace secular {

namespace {

bool is_one(const std::string& digits) {
  return digits == "1" || digits == "-1";
}
std::string magnitude(const std::string& digits) {
  return digits.front() == '-' ? digits.substr(1) : digits;
}

}  // namespace

CppWriter::CppWriter(SymbolOrder order, std::string scalar)
    : order_(std::move(order)), scalar_(std::move(scalar)), highest_power_(order_.size(), 0) {}

std::string CppWriter::power(std::size_t symbol, int exponent) {
  highest_power_[symbol] = std::max(highest_power_[symbol], exponent);
  const std::string name = safe_identifier(order_[symbol]);
  return exponent == 1 ? name : name + "_" + std::to_string(exponent);
}

// "a * b - 2.0 * c"; `single` tells whether it is one product without a sum.
std::string CppWriter::polynomial(const std::vector<PolynomialTerm>& terms, bool& single) {
  single = terms.size() == 1;
  std::string text;
  for (const PolynomialTerm& term : terms) {
    const bool negative = term.coefficient.front() == '-';
    text += text.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
    std::string product;
    if (!is_one(term.coefficient)) product = magnitude(term.coefficient) + ".0";
    for (std::size_t i = 0; i < term.exponents.size(); ++i) {
      if (term.exponents[i] == 0) continue;
      product += (product.empty() ? "" : " * ") + power(i, term.exponents[i]);
    }
    text += product.empty() ? magnitude(term.coefficient) + ".0" : product;
  }
  return text;
}

std::size_t CppWriter::number_of(const std::shared_ptr<const std::vector<PolynomialTerm>>& divisor) {
  const auto [known, added] = number_of_.try_emplace(divisor, divisors_.size());
  if (added) {
    bool single = false;
    divisors_.push_back({divisor, polynomial(*divisor, single)});
  }
  return known->second;
}

std::string CppWriter::divided_by(const std::vector<DivisorPower>& divisors) {
  std::string text;
  for (const auto& [sum, power] : divisors) {
    const std::size_t number = number_of(sum);
    divisors_[number].highest_power = std::max(divisors_[number].highest_power, power);
    text += fmt::format(" * per_{}{}", number, power == 1 ? "" : "_" + std::to_string(power));
  }
  if (divisors.size() < 2) return text;
  const std::string product = text.substr(3);
  const auto known = std::find(products_.begin(), products_.end(), product);
  const auto number = static_cast<std::size_t>(known - products_.begin());
  if (known == products_.end()) products_.push_back(product);
  return fmt::format(" * over_{}", number);
}

// numerator * inverse divisors / denominator; a sign before a single product is drawn out.
std::string CppWriter::fraction(const Fraction& part, bool& negative) {
  bool single = false;
  std::string above = polynomial(part.numerator, single);
  negative = single && above.front() == '-';
  if (negative) above.erase(0, 1);
  if (part.is_plain()) return above;
  if (!single) above = "(" + above + ")";
  const std::string inverses = divided_by(part.divisors);
  if (above == "1.0" && !inverses.empty())
    above = inverses.substr(3);
  else
    above += inverses;
  if (part.denominator.size() == 1 && Fraction{{}, part.denominator, {}}.is_plain()) return above;
  bool single_below = false;
  std::string below = polynomial(part.denominator, single_below);
  if (!single_below || below.find(' ') != std::string::npos) below = "(" + below + ")";
  return above + " / " + below;
}

std::string CppWriter::expression(const RationalFunction& value) {
  if (value.is_zero()) return "0.0";
  std::string text;
  for (const Fraction& part : fractions(value)) {
    bool negative = false;
    const std::string one = fraction(part, negative);
    text += (text.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ")) + one;
  }
  return text;
}

std::vector<std::string> CppWriter::definitions() const {
  std::vector<std::string> lines;
  const auto powers = [&](const std::string& name, int highest) {
    for (int n = 2; n <= highest; ++n)
      lines.push_back(fmt::format("const {} {}_{} = {} * {};", scalar_, name, n,
                                  n == 2 ? name : fmt::format("{}_{}", name, n - 1), name));
  };
  for (std::size_t i = 0; i < order_.size(); ++i) powers(safe_identifier(order_[i]), highest_power_[i]);
  for (std::size_t d = 0; d < divisors_.size(); ++d) {
    lines.push_back(fmt::format("const {0} per_{1} = 1.0 / ({2});", scalar_, d, divisors_[d].text));
    powers(fmt::format("per_{}", d), divisors_[d].highest_power);
  }
  for (std::size_t p = 0; p < products_.size(); ++p)
    lines.push_back(fmt::format("const {} over_{} = {};", scalar_, p, products_[p]));
  return lines;
}

std::vector<std::string> CppWriter::used_symbols() const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < order_.size(); ++i)
    if (highest_power_[i] > 0) names.push_back(order_[i]);
  return names;
}

namespace {

std::string polynomial_text(const std::vector<PolynomialTerm>& terms, const SymbolOrder& order) {
  std::string text;
  for (const PolynomialTerm& term : terms) {
    const bool negative = term.coefficient.front() == '-';
    text += text.empty() ? (negative ? "-" : "") : (negative ? " - " : " + ");
    std::string product = is_one(term.coefficient) ? "" : magnitude(term.coefficient);
    for (std::size_t i = 0; i < term.exponents.size(); ++i) {
      if (term.exponents[i] == 0) continue;
      product += (product.empty() ? "" : "*") + (order[i] == "pi" ? std::string("Pi") : order[i]);
      if (term.exponents[i] != 1) product += "^" + std::to_string(term.exponents[i]);
    }
    text += product.empty() ? "1" : product;
  }
  return text;
}

// "8*omega1*(omega1 - 2*omega2)^2"
std::string divisors_text(const Fraction& part, const SymbolOrder& order) {
  const std::string number = polynomial_text(part.denominator, order);
  std::string text = number == "1" ? "" : part.denominator.size() > 1 ? "(" + number + ")" : number;
  for (const auto& [sum, power] : part.divisors)
    text += (text.empty() ? "(" : "*(") + polynomial_text(*sum, order) + ")" +
            (power == 1 ? "" : "^" + std::to_string(power));
  return text;
}

}  // namespace

std::string formula_text(const RationalFunction& value, const SymbolOrder& order) {
  if (value.is_zero()) return "0";
  std::string text;
  const std::vector<Fraction> parts = fractions(value);
  for (const Fraction& part : parts) {
    std::string above = polynomial_text(part.numerator, order);
    const bool negative = above.front() == '-' && part.numerator.size() == 1;
    if (!text.empty()) {
      if (negative) above.erase(0, 1);
      text += negative ? " - " : " + ";
    }
    if (part.is_plain()) {
      text += above;
      continue;
    }
    std::string below =
        part.divisors.empty() ? polynomial_text(part.denominator, order) : divisors_text(part, order);
    if (part.numerator.size() > 1) above = "(" + above + ")";
    const bool one = part.divisors.size() == 1 && below.front() == '(';  // one power of one sum
    if (!one && below.find_first_of("*+- ") != std::string::npos) below = "(" + below + ")";
    text += above + "/" + below;
  }
  return text;
}

}  // namespace secular
