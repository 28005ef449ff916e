#include "perturb/prime_field.hpp"

#include <stdexcept>
#include <string>

#include "numerics/splitmix64.hpp"

namespace secular {
namespace {

std::uint64_t residue(const GiNaC::numeric& integer) {
  static const GiNaC::numeric prime(static_cast<long>(PrimeFieldComplex::prime));
  return static_cast<std::uint64_t>(GiNaC::mod(integer, prime).to_long());
}

PrimeFieldComplex rational(const GiNaC::numeric& value) {
  const PrimeFieldComplex numerator(residue(value.numer()), std::uint64_t{0});
  if (value.is_integer()) return numerator;
  return numerator * PrimeFieldComplex(residue(value.denom()), std::uint64_t{0}).inverse();
}

}  // namespace

PrimeFieldComplex::PrimeFieldComplex(const GiNaC::numeric& value) {
  if (!value.is_crational()) throw std::domain_error("number is not a complex rational");
  if (value.is_real()) {
    *this = rational(value);
    return;
  }
  *this = rational(value.real()) + i() * rational(value.imag());
}

PrimeFieldComplex PrimeFieldComplex::power(std::uint64_t exponent) const {
  PrimeFieldComplex result = 1, square = *this;
  for (; exponent != 0; exponent >>= 1) {
    if (exponent & 1) result *= square;
    square *= square;
  }
  return result;
}

PrimeFieldComplex PrimeFieldComplex::inverse() const {
  if (is_zero()) throw std::domain_error("division by zero");
  const PrimeFieldComplex norm = *this * conjugate();  // real; its inverse is norm^(p-2)
  return conjugate() * norm.power(prime - 2);
}

PrimeFieldComplex random_value(const std::string& name, std::uint64_t draw) {
  std::uint64_t hash = splitmix64(draw + 0x5ec01a5ULL);
  for (const char c : name) hash = splitmix64(hash ^ static_cast<unsigned char>(c));
  return {hash >> 3, std::uint64_t{0}};
}

PrimeFieldComplex RandomPoint::value(
    const GiNaC::ex& e) {  // exact types: dynamic casts cost as much as all the rest
  if (GiNaC::is_exactly_a<GiNaC::numeric>(e)) return PrimeFieldComplex(GiNaC::ex_to<GiNaC::numeric>(e));
  if (GiNaC::is_exactly_a<GiNaC::add>(e)) {
    PrimeFieldComplex sum;
    for (std::size_t k = 0; k < e.nops(); ++k) sum += value(e.op(k));
    return sum;
  }
  if (GiNaC::is_exactly_a<GiNaC::mul>(e)) {
    PrimeFieldComplex product = 1;
    for (std::size_t k = 0; k < e.nops(); ++k) product *= value(e.op(k));
    return product;
  }
  const auto found = known_.find(e);
  if (found != known_.end()) return found->second;
  const auto named = [&](const std::string& name) { return random_value(name, draw_ ? draw_(name) : 0); };
  PrimeFieldComplex result;
  if (GiNaC::is_a<GiNaC::symbol>(e)) {
    result = named(GiNaC::ex_to<GiNaC::symbol>(e).get_name());
  } else if (GiNaC::is_exactly_a<GiNaC::constant>(e) && e.is_equal(GiNaC::Pi)) {
    result = named("Pi");
  } else if (GiNaC::is_exactly_a<GiNaC::power>(e) && GiNaC::is_exactly_a<GiNaC::numeric>(e.op(1)) &&
             GiNaC::ex_to<GiNaC::numeric>(e.op(1)).is_integer()) {
    const int exponent = GiNaC::ex_to<GiNaC::numeric>(e.op(1)).to_int();
    const PrimeFieldComplex base = value(e.op(0));
    result = exponent >= 0 ? base.power(static_cast<std::uint64_t>(exponent))
                           : base.inverse().power(static_cast<std::uint64_t>(-exponent));
  } else {
    throw std::domain_error("expression is not rational");
  }
  return known_[e] = result;
}

bool RandomPoint::vanishes(const GiNaC::ex& expression) {
  if (expression.is_zero()) return true;
  if (!GiNaC::is_exactly_a<GiNaC::add>(expression)) return false;
  return value(expression).is_zero();
}

PrimeFieldComplex value_at_random_point(const GiNaC::ex& expression) {
  return RandomPoint().value(expression);
}

bool vanishes(const GiNaC::ex& expression) {
  return RandomPoint().vanishes(expression);
}

}  // namespace secular
