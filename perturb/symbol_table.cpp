#include "perturb/symbol_table.hpp"

#include <cstdlib>

namespace secular {

const GiNaC::ex& SymbolTable::add_real(const std::string& name) {
  const auto [position, added] = symbols_.try_emplace(name, GiNaC::realsymbol(name));
  if (added) names_.push_back(name);
  return position->second;
}

const GiNaC::ex& SymbolTable::add_positive(const std::string& name) {
  const auto [position, added] = symbols_.try_emplace(name, GiNaC::possymbol(name));
  if (added) names_.push_back(name);
  return position->second;
}

GiNaC::exvector SymbolTable::with_pi() const {
  GiNaC::exvector symbols;
  for (const std::string& name : names_) symbols.push_back(symbols_.at(name));
  symbols.push_back(GiNaC::Pi);
  return symbols;
}

GiNaC::numeric exact_number(const std::string& digits) {
  std::string mantissa;
  long exponent = 0;
  bool fraction = false;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const char c = digits[i];
    if (c == '.') {
      fraction = true;
    } else if (c == 'e' || c == 'E') {
      exponent += std::strtol(digits.c_str() + i + 1, nullptr, 10);
      break;
    } else {
      mantissa += c;
      if (fraction) --exponent;
    }
  }
  const GiNaC::numeric value(mantissa.c_str());
  return value * GiNaC::numeric(10).power(GiNaC::numeric(exponent));
}

}  // namespace secular
