#include "perturb/inverse_sums.hpp"

namespace secular {

GiNaC::ex InverseSums::inverse(const GiNaC::ex& frequency) {
  const GiNaC::ex reciprocal = 1 / frequency;  // number * (sum with coefficients in lowest terms)^-1
  if (!GiNaC::is_a<GiNaC::add>(frequency)) return reciprocal;
  const bool scaled = GiNaC::is_a<GiNaC::mul>(reciprocal);
  const GiNaC::ex power = scaled ? reciprocal.op(0) : reciprocal;
  const auto [position, added] = symbol_of_.try_emplace(power);
  if (added) {
    const GiNaC::realsymbol symbol;
    position->second = symbol;
    sum_behind_[symbol] = power;
    point_.define(symbol, power);
  }
  return (scaled ? reciprocal.op(1) : GiNaC::ex(1)) * position->second;
}

GiNaC::ex InverseSums::cleaned(const GiNaC::ex& coefficient) {
  const GiNaC::ex expanded = coefficient.expand();
  return point_.vanishes(expanded) ? GiNaC::ex(0) : expanded;
}

Field InverseSums::cleaned(const Field& field) {
  Field result;
  for (const auto& [key, coefficient] : field.terms()) {
    const GiNaC::ex clean = cleaned(coefficient);
    if (!clean.is_zero()) result.add(key, clean);
  }
  return result;
}

Field InverseSums::written_out(const Field& field) const {
  return sum_behind_.empty() ? field : field.with_symbols(sum_behind_);
}

}  // namespace secular
