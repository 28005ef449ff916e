#include "perturb/coefficient_text.hpp"

#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>

namespace secular {

std::optional<std::string> monomial_text(const GiNaC::ex& monomial) {
  std::map<std::string, int> powers;
  GiNaC::numeric number = 1;
  for (std::size_t i = 0; i < (GiNaC::is_a<GiNaC::mul>(monomial) ? monomial.nops() : 1); ++i) {
    const GiNaC::ex factor = GiNaC::is_a<GiNaC::mul>(monomial) ? monomial.op(i) : monomial;
    const bool power = GiNaC::is_a<GiNaC::power>(factor) && GiNaC::is_a<GiNaC::numeric>(factor.op(1));
    const GiNaC::ex base = power ? factor.op(0) : factor;
    if (GiNaC::is_a<GiNaC::numeric>(factor))
      number *= GiNaC::ex_to<GiNaC::numeric>(factor);
    else if (GiNaC::is_a<GiNaC::symbol>(base))
      powers[GiNaC::ex_to<GiNaC::symbol>(base).get_name()] +=
          power ? GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_int() : 1;
    else if (base.is_equal(GiNaC::Pi))
      powers["Pi"] += power ? GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_int() : 1;
    else
      return std::nullopt;
  }
  std::ostringstream text;
  if (number == -1 && !powers.empty())
    text << '-';
  else if (number != 1 || powers.empty())
    text << number << (powers.empty() ? "" : "*");
  bool first = true;
  for (const auto& [name, power] : powers) {
    if (!first) text << '*';
    first = false;
    text << name;
    if (power != 1) text << '^' << power;
  }
  return text.str();
}

std::optional<std::vector<std::string>> sum_terms(const GiNaC::ex& sum) {
  const bool several = GiNaC::is_a<GiNaC::add>(sum);
  std::vector<std::string> terms;
  for (std::size_t i = 0; i < (several ? sum.nops() : 1); ++i) {
    const std::optional<std::string> term = monomial_text(several ? sum.op(i) : sum);
    if (!term) return std::nullopt;
    terms.push_back(*term);
  }
  std::sort(terms.begin(), terms.end());
  return terms;
}

std::string joined_terms(const std::vector<std::string>& terms) {
  std::string text;
  for (const std::string& term : terms) {
    const bool minus = term.front() == '-' && !text.empty();
    text += (text.empty() ? "" : minus ? " - " : " + ") + (minus ? term.substr(1) : term);
  }
  return text.empty() ? "0" : text;
}

std::string rational_text(const GiNaC::ex& value) {
  const GiNaC::ex parts = value.normal().numer_denom();
  GiNaC::ex above = parts.op(0).expand(), below = parts.op(1).expand();
  const auto terms_of = [](const GiNaC::ex& sum) {
    const auto terms = sum_terms(sum);
    if (!terms) throw std::logic_error("a coefficient that is no rational function of symbols");
    return *terms;
  };
  // Of the two ways to put the sign, the one with fewer of them below.
  const auto minuses = [](const std::vector<std::string>& terms) {
    return std::count_if(terms.begin(), terms.end(), [](const std::string& t) { return t.front() == '-'; });
  };
  const auto plain = terms_of(below), turned = terms_of((-below).expand());
  if (minuses(turned) < minuses(plain) || (minuses(turned) == minuses(plain) && turned < plain)) {
    above = (-above).expand();
    below = (-below).expand();
  }
  const std::string numerator = joined_terms(terms_of(above));
  if (below.is_equal(1)) return numerator;
  return "(" + numerator + ")/(" + joined_terms(terms_of(below)) + ")";
}

}  // namespace secular
