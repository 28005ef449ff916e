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
    if (!is_one(term.coefficient)) product = fmt::format("{}({}.0)", scalar_, magnitude(term.coefficient));
    for (std::size_t i = 0; i < term.exponents.size(); ++i) {
      if (term.exponents[i] == 0) continue;
      if (!product.empty()) ++operations_;
      product += (product.empty() ? "" : " * ") + power(i, term.exponents[i]);
    }
    text += product.empty() ? fmt::format("{}({}.0)", scalar_, magnitude(term.coefficient)) : product;
  }
  operations_ += static_cast<int>(terms.size()) - 1;
  return text;
}

std::string CppWriter::expression(const RationalFunction& value) {
  if (value.is_zero()) return scalar_ + "(0.0)";
  bool single = false;
  std::string above = polynomial(value.numerator, single);
  const bool plain = value.denominator.size() == 1 && value.denominator.front().coefficient == "1" &&
                     value.denominator_is_number();
  if (plain) return above;
  if (!single) above = "(" + above + ")";
  bool single_below = false;
  std::string below = polynomial(value.denominator, single_below);
  if (!single_below || below.find(' ') != std::string::npos) below = "(" + below + ")";
  ++operations_;
  return above + " / " + below;
}

std::vector<std::string> CppWriter::definitions() const {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const std::string name = safe_identifier(order_[i]);
    for (int n = 2; n <= highest_power_[i]; ++n)
      lines.push_back(fmt::format("const {} {}_{} = {} * {};", scalar_, name, n,
                                  n == 2 ? name : fmt::format("{}_{}", name, n - 1), name));
  }
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

}  // namespace

std::string formula_text(const RationalFunction& value, const SymbolOrder& order) {
  if (value.is_zero()) return "0";
  std::string above = polynomial_text(value.numerator, order);
  if (value.denominator_is_number() && value.denominator.front().coefficient == "1") return above;
  std::string below = polynomial_text(value.denominator, order);
  if (value.numerator.size() > 1) above = "(" + above + ")";
  if (below.find_first_of("*+- ") != std::string::npos) below = "(" + below + ")";
  return above + "/" + below;
}

}  // namespace secular
