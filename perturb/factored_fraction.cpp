#include "perturb/factored_fraction.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace secular {
namespace {

bool is_linear(const GiNaC::ex& sum) {
  for (const GiNaC::ex& term : sum) {
    const bool scaled = GiNaC::is_exactly_a<GiNaC::mul>(term) && term.nops() == 2 &&
                        GiNaC::is_exactly_a<GiNaC::numeric>(term.op(1));
    if (!GiNaC::is_a<GiNaC::symbol>(scaled ? term.op(0) : term)) return false;
  }
  return true;
}

bool is_rational_polynomial(const GiNaC::ex& e) {
  return e.info(GiNaC::info_flags::rational_polynomial);
}

// N/f if f divides N.
bool divide_out(GiNaC::ex& numerator, const GiNaC::ex& factor) {
  GiNaC::ex quotient;
  if (!GiNaC::divide(numerator, factor, quotient)) return false;
  numerator = quotient.expand();
  return true;
}

// For a linear factor: a point at which it vanishes, and N does not, settles the matter at once.
bool may_divide(const GiNaC::ex& numerator, const GiNaC::ex& factor) {
  if (!GiNaC::is_exactly_a<GiNaC::add>(factor) || !is_linear(factor)) return true;
  GiNaC::exset symbols;
  for (const GiNaC::ex& e : {numerator, factor})
    for (GiNaC::const_preorder_iterator part = e.preorder_begin(); part != e.preorder_end(); ++part)
      if (GiNaC::is_a<GiNaC::symbol>(*part)) symbols.insert(*part);
  GiNaC::exmap point;
  GiNaC::numeric next = 1009;  // far apart: nothing that small integers relate
  for (const GiNaC::ex& symbol : symbols) {
    point[symbol] = next;
    next = next * 7 + 13;
  }
  for (const GiNaC::ex& symbol : symbols) {
    const GiNaC::ex slope = factor.coeff(symbol, 1);
    if (slope.is_zero()) continue;
    GiNaC::exmap others = point;
    others.erase(symbol);
    point[symbol] = -factor.coeff(symbol, 0).subs(others, GiNaC::subs_options::no_pattern) / slope;
    break;
  }
  return numerator.subs(point, GiNaC::subs_options::no_pattern).expand().is_zero();
}

}  // namespace

GiNaC::ex expanded_product(GiNaC::ex begin, const FactorPowers& factors) {
  for (const auto& [factor, power] : factors)
    for (int i = 0; i < power; ++i) begin = (begin * factor).expand();
  return begin;
}

bool FractionSums::add_irreducible(const GiNaC::ex& factor, int power, Part& part) {
  if (GiNaC::is_exactly_a<GiNaC::numeric>(factor)) {
    part.above /= GiNaC::pow(factor, power);
    return true;
  }
  GiNaC::ex primitive = factor;
  if (GiNaC::is_exactly_a<GiNaC::add>(factor)) {
    const GiNaC::numeric content = factor.integer_content();
    primitive = (factor / content).expand();
    part.above /= GiNaC::pow(content, power);
    if (!known_.contains(primitive) && known_.contains((-primitive).expand())) {
      primitive = (-primitive).expand();
      if (power % 2 != 0) part.above = -part.above;
    }
  } else if (!GiNaC::is_a<GiNaC::symbol>(factor)) {
    return false;
  }
  known_[primitive] = 1;
  part.below[primitive] += power;
  return true;
}

bool FractionSums::add_divisor(const GiNaC::ex& base, int power, Part& part) {
  if (!is_rational_polynomial(base)) return false;
  if (!GiNaC::is_exactly_a<GiNaC::add>(base) || is_linear(base)) return add_irreducible(base, power, part);
  const auto [known, is_new] = factored_.try_emplace(base);
  if (is_new) known->second = GiNaC::factor(base);
  const GiNaC::ex product = known->second;
  const bool several = GiNaC::is_exactly_a<GiNaC::mul>(product);
  for (std::size_t i = 0; i < (several ? product.nops() : 1); ++i) {
    const GiNaC::ex factor = several ? product.op(i) : product;
    const bool repeated = GiNaC::is_exactly_a<GiNaC::power>(factor);
    const int times = repeated ? GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_int() : 1;
    if (!add_irreducible(repeated ? factor.op(0) : factor, times * power, part)) return false;
  }
  return true;
}

std::optional<FractionSums::Part> FractionSums::taken_apart(const GiNaC::ex& product) {
  Part part;
  const bool several = GiNaC::is_exactly_a<GiNaC::mul>(product);
  for (std::size_t i = 0; i < (several ? product.nops() : 1); ++i) {
    const GiNaC::ex factor = several ? product.op(i) : product;
    if (GiNaC::is_exactly_a<GiNaC::power>(factor) && factor.op(1).info(GiNaC::info_flags::negint)) {
      if (!add_divisor(factor.op(0), -GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_int(), part))
        return std::nullopt;
    } else if (is_rational_polynomial(factor)) {
      part.above *= factor;
    } else {
      return std::nullopt;
    }
  }
  return part;
}

// Over a denominator that has the factors of both.
FractionSums::Part FractionSums::merged(const Part& a, const Part& b) {
  Part sum{0, a.below};
  for (const auto& [factor, power] : b.below) sum.below[factor] = std::max(sum.below[factor], power);
  for (const Part* part : {&a, &b}) {
    FactorPowers missing = sum.below;
    for (const auto& [factor, power] : part->below) missing[factor] -= power;
    sum.above += expanded_product(part->above, missing);
  }
  sum.above = sum.above.expand();
  return sum;
}

std::optional<FactoredFraction> FractionSums::sum(const GiNaC::exvector& parts) {
  std::vector<Part> fractions;
  for (const GiNaC::ex& product : parts) {
    std::optional<Part> part = taken_apart(product);
    if (!part) return std::nullopt;
    part->above = part->above.expand();
    fractions.push_back(std::move(*part));
  }
  // A factor that but one part has in its highest power divides all of the sum except that part.
  FactorPowers highest, times;
  for (const Part& part : fractions)
    for (const auto& [factor, power] : part.below) {
      if (power > highest[factor]) times[factor] = 0;
      highest[factor] = std::max(highest[factor], power);
      if (power == highest[factor]) ++times[factor];
    }
  for (; fractions.size() > 1; fractions.resize((fractions.size() + 1) / 2))  // by pairs: small products first
    for (std::size_t i = 0; i < fractions.size(); i += 2)
      fractions[i / 2] = i + 1 < fractions.size() ? merged(fractions[i], fractions[i + 1]) : fractions[i];
  FactoredFraction result{fractions.front().above, fractions.front().below};
  if (result.numerator.is_zero()) return FactoredFraction{0, {}};
  for (auto& [factor, power] : result.denominator)
    while (times[factor] > 1 && power > 0 && may_divide(result.numerator, factor) &&
           divide_out(result.numerator, factor))
      --power;
  return result;
}

}  // namespace secular
