#include "codegen/canonical_form.hpp"

#include <map>
#include <sstream>
#include <stdexcept>

namespace secular {
namespace {

std::string digits(const GiNaC::numeric& integer) {
  std::ostringstream stream;
  stream << integer;
  return stream.str();
}

}  // namespace

CanonicalForm::CanonicalForm(const SymbolTable& symbols, const SymbolOrder& order) {
  for (const std::string& name : order) symbols_.push_back(name == "pi" ? GiNaC::ex(pi_) : symbols.at(name));
}

// Reads coefficients in the declared order of symbols and divides by their content (positive).
std::vector<PolynomialTerm> CanonicalForm::polynomial(const GiNaC::ex& expanded, GiNaC::numeric& content) const {
  std::map<std::vector<int>, GiNaC::numeric, std::greater<>> terms;
  const bool is_sum = GiNaC::is_a<GiNaC::add>(expanded);
  for (std::size_t i = 0; i < (is_sum ? expanded.nops() : 1); ++i) {
    GiNaC::ex rest = is_sum ? expanded.op(i) : expanded;
    std::vector<int> exponents;
    for (const GiNaC::ex& symbol : symbols_) {
      const int power = rest.degree(symbol);
      exponents.push_back(power);
      if (power != 0) rest = rest.coeff(symbol, power);
    }
    if (!GiNaC::is_a<GiNaC::numeric>(rest) || !GiNaC::ex_to<GiNaC::numeric>(rest).is_rational())
      throw std::logic_error("expression is not rational in its declared symbols");
    const auto [position, added] = terms.try_emplace(std::move(exponents), GiNaC::ex_to<GiNaC::numeric>(rest));
    if (!added) position->second = position->second + GiNaC::ex_to<GiNaC::numeric>(rest);
  }
  GiNaC::numeric common_divisor = 0, common_multiple = 1;
  for (const auto& [exponents, coefficient] : terms) {
    common_divisor = GiNaC::gcd(common_divisor, coefficient.numer());
    common_multiple = GiNaC::lcm(common_multiple, coefficient.denom());
  }
  content = common_divisor.is_zero() ? GiNaC::numeric(1) : common_divisor / common_multiple;
  std::vector<PolynomialTerm> result;
  for (const auto& [exponents, coefficient] : terms)
    if (!coefficient.is_zero()) result.push_back({digits(coefficient / content), exponents});
  return result;
}

RationalFunction CanonicalForm::of(const GiNaC::ex& expression) const {
  if (expression.is_zero()) return {{}, {{"1", std::vector<int>(symbols_.size(), 0)}}};
  const GiNaC::ex fraction = expression.subs(GiNaC::Pi == pi_).numer_denom();
  GiNaC::numeric above, below;
  RationalFunction result;
  result.numerator = polynomial(fraction.op(0).expand(), above);
  result.denominator = polynomial(fraction.op(1).expand(), below);
  if (result.numerator.empty()) return {{}, {{"1", std::vector<int>(symbols_.size(), 0)}}};
  GiNaC::numeric scale = above / below;
  if (result.denominator.front().coefficient.front() == '-') {
    scale = -scale;
    for (PolynomialTerm& term : result.denominator)
      term.coefficient = term.coefficient.front() == '-' ? term.coefficient.substr(1) : "-" + term.coefficient;
  }
  const auto multiply = [](std::vector<PolynomialTerm>& terms, const GiNaC::numeric& factor) {
    for (PolynomialTerm& term : terms) term.coefficient = digits(GiNaC::numeric(term.coefficient.c_str()) * factor);
  };
  multiply(result.numerator, scale.numer());
  multiply(result.denominator, scale.denom());
  return result;
}

}  // namespace secular
