#include "perturb/factored_fraction.hpp"

#include <cln/integer_io.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace secular {
namespace {

void multiply(DivisorPowers& powers, std::size_t divisor, int power) {
  const auto place = std::lower_bound(powers.begin(), powers.end(), divisor,
                                      [](const auto& entry, std::size_t number) { return entry.first < number; });
  if (place == powers.end() || place->first != divisor)
    powers.insert(place, {divisor, power});
  else if ((place->second += power) == 0)
    powers.erase(place);
}

int power_of(const DivisorPowers& powers, std::size_t divisor) {
  const auto place = std::lower_bound(powers.begin(), powers.end(), divisor,
                                      [](const auto& entry, std::size_t number) { return entry.first < number; });
  return place == powers.end() || place->first != divisor ? 0 : place->second;
}

GiNaC::numeric number(const cln::cl_RA& value) {
  return GiNaC::numeric(static_cast<const cln::cl_N&>(value));
}

PrimeFieldComplex residue(const cln::cl_I& value) {
  if (cln::integer_length(value) < 62)
    return PrimeFieldComplex(static_cast<std::int64_t>(cln::cl_I_to_long(value)));
  static const cln::cl_I prime = static_cast<long>(PrimeFieldComplex::prime);
  return PrimeFieldComplex(static_cast<std::int64_t>(cln::cl_I_to_long(cln::mod(value, prime))));
}

// Powers of the values of symbols, each computed once.
class PowerTable {
 public:
  explicit PowerTable(const std::vector<PrimeFieldComplex>& values) {
    for (const PrimeFieldComplex& value : values) powers_.push_back({1, value});
  }
  const PrimeFieldComplex& operator()(std::size_t symbol, int power) {
    std::vector<PrimeFieldComplex>& known = powers_[symbol];
    while (known.size() <= static_cast<std::size_t>(power)) known.push_back(known.back() * known[1]);
    return known[static_cast<std::size_t>(power)];
  }

 private:
  std::vector<std::vector<PrimeFieldComplex>> powers_;
};

PrimeFieldComplex value_at(const Polynomial& p, const std::vector<PrimeFieldComplex>& values) {
  PowerTable point(values);
  PrimeFieldComplex sum;
  for (std::size_t t = 0; t < p.size(); ++t) {
    PrimeFieldComplex product = residue(p.coefficient(t));
    for (std::size_t s = 0; s < p.symbols(); ++s)
      if (const int power = p.power(t, s); power != 0) product *= point(s, power);
    sum += product;
  }
  return sum;
}

// A symbol in which the factor is linear with a number as its slope: its term, which holds nothing else.
std::optional<std::size_t> linear_symbol(const Polynomial& factor) {
  for (std::size_t s = 0; s < factor.symbols(); ++s) {
    std::size_t holding = 0;
    bool alone = false;
    for (std::size_t t = 0; t < factor.size(); ++t) {
      if (factor.power(t, s) == 0) continue;
      ++holding;
      const std::vector<int> powers = factor.powers(t);
      alone = std::count(powers.begin(), powers.end(), 0) + 1 == static_cast<std::ptrdiff_t>(powers.size()) &&
              powers[s] == 1;
    }
    if (holding == 1 && alone) return s;
  }
  return std::nullopt;
}

// False only where the factor does not divide: at a point of the prime field at which it vanishes, all of its
// multiples with integer coefficients vanish.
bool may_divide(const Polynomial& numerator, const Polynomial& factor) {
  const std::optional<std::size_t> solved = linear_symbol(factor);
  if (!solved) return true;
  std::vector<PrimeFieldComplex> point;
  for (std::size_t s = 0; s < factor.symbols(); ++s) point.push_back(random_value("divisor", s));
  point[*solved] = 0;
  PrimeFieldComplex slope;
  for (std::size_t t = 0; t < factor.size(); ++t)
    if (factor.power(t, *solved) != 0) slope = residue(factor.coefficient(t));
  if (slope.is_zero()) return true;
  point[*solved] = -(value_at(factor, point) * slope.inverse());
  return value_at(numerator, point).is_zero();
}

// --- polynomials in one symbol modulo the prime, from the constant upward

using Image = std::vector<PrimeFieldComplex>;

void drop_zeros(Image& p) {
  while (!p.empty() && p.back().is_zero()) p.pop_back();
}

// At a point for all symbols but one.
Image image(const Polynomial& p, std::size_t kept, PowerTable& point) {
  Image result;
  for (std::size_t t = 0; t < p.size(); ++t) {
    PrimeFieldComplex product = residue(p.coefficient(t));
    for (std::size_t s = 0; s < p.symbols(); ++s)
      if (const int power = p.power(t, s); power != 0 && s != kept) product *= point(s, power);
    const auto degree = static_cast<std::size_t>(p.power(t, kept));
    if (result.size() <= degree) result.resize(degree + 1);
    result[degree] += product;
  }
  return result;
}

std::size_t degree_of_common_divisor(Image a, Image b) {
  while (!b.empty()) {
    const PrimeFieldComplex lead = b.back().inverse();
    while (a.size() >= b.size()) {
      const PrimeFieldComplex share = a.back() * lead;
      for (std::size_t i = 0; i < b.size(); ++i) {
        PrimeFieldComplex& term = a[a.size() - b.size() + i];
        term = term - share * b[i];
      }
      drop_zeros(a);
    }
    std::swap(a, b);
  }
  return a.size() - 1;
}

// True only where it is certain, of primitive polynomials. A common divisor keeps its degree in a symbol wherever
// the leading coefficient of one of the two does not vanish: what is of degree zero at such a point of the prime
// field is of degree zero.
bool coprime(const Polynomial& a, const Polynomial& b) {
  std::vector<PrimeFieldComplex> values;
  for (std::size_t s = 0; s < a.symbols(); ++s) values.push_back(random_value("coprime", s));
  PowerTable point(values);
  for (std::size_t s = 0; s < a.symbols(); ++s) {
    Image left = image(a, s, point), right = image(b, s, point);
    if (left.size() == 1 || right.size() == 1) continue;  // the symbol is not in both
    if (right.back().is_zero()) return false;
    drop_zeros(left);
    if (left.empty() || degree_of_common_divisor(std::move(left), std::move(right)) > 0) return false;
  }
  return true;
}

int degree(const Polynomial& p, std::size_t term) {
  int sum = 0;
  for (std::size_t s = 0; s < p.symbols(); ++s) sum += p.power(term, s);
  return sum;
}

// Without a common number and a common symbol such a polynomial has no factors.
bool of_first_degree(const Polynomial& p) {
  for (std::size_t t = 0; t < p.size(); ++t)
    if (degree(p, t) > 1) return false;
  return true;
}

Polynomial one(std::size_t variables) {
  return {variables, {{std::vector<int>(variables, 0), 1}}};
}

PrimeFieldComplex to_power(const PrimeFieldComplex& base, const PrimeFieldComplex& inverse, int power) {
  PrimeFieldComplex result = 1;
  for (int n = std::abs(power); n > 0; --n) result *= power > 0 ? base : inverse;
  return result;
}

FractionTerms part_of(const FractionTerms& terms, cln::cl_RA FractionTerm::*part) {
  FractionTerms result;
  for (const FractionTerm& term : terms)
    if (!cln::zerop(term.*part)) result.push_back({term.*part, 0, term.powers, term.divisors});
  return result;
}

}  // namespace

std::vector<std::size_t> united(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b) {
  std::vector<std::size_t> result;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

FractionTerms real_part(const FractionTerms& terms) {
  return part_of(terms, &FractionTerm::real);
}

FractionTerms imaginary_part(const FractionTerms& terms) {
  return part_of(terms, &FractionTerm::imaginary);
}

Polynomial in_variables(const Polynomial& polynomial, const std::vector<std::size_t>& own,
                        const std::vector<std::size_t>& variables) {
  if (own == variables) return polynomial;
  std::vector<std::size_t> place;
  for (const std::size_t variable : own)
    place.push_back(static_cast<std::size_t>(std::lower_bound(variables.begin(), variables.end(), variable) -
                                             variables.begin()));
  return polynomial.renumbered(place, variables.size());
}

FractionSums::FractionSums(const GiNaC::exvector& symbols) : symbols_(symbols) {
  for (std::size_t i = 0; i < symbols.size(); ++i) place_[symbols[i]] = i;
}

// --- from expressions

std::optional<FractionTerms> FractionSums::terms(const GiNaC::ex& expression) {
  const bool is_sum = GiNaC::is_exactly_a<GiNaC::add>(expression);
  FractionTerms result(is_sum ? expression.nops() : 1);
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i].real = 1;
    result[i].powers.assign(symbols_.size(), 0);
    if (!read_product(is_sum ? expression.op(i) : expression, result[i])) return std::nullopt;
  }
  return result;
}

bool FractionSums::read_product(const GiNaC::ex& product, FractionTerm& term) {
  const bool several = GiNaC::is_exactly_a<GiNaC::mul>(product);
  for (std::size_t i = 0; i < (several ? product.nops() : 1); ++i) {
    const GiNaC::ex factor = several ? product.op(i) : product;
    if (GiNaC::is_exactly_a<GiNaC::numeric>(factor)) {
      const auto& value = GiNaC::ex_to<GiNaC::numeric>(factor);
      if (!value.is_crational()) return false;
      const cln::cl_RA real = cln::the<cln::cl_RA>(value.real().to_cl_N()),
                       imaginary = cln::the<cln::cl_RA>(value.imag().to_cl_N());
      const cln::cl_RA turned = term.real * imaginary + term.imaginary * real;
      term.real = term.real * real - term.imaginary * imaginary;
      term.imaginary = turned;
      continue;
    }
    const bool power = GiNaC::is_exactly_a<GiNaC::power>(factor);
    if (power && !factor.op(1).info(GiNaC::info_flags::integer)) return false;
    const int exponent = power ? GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_int() : 1;
    if (!read_power(power ? factor.op(0) : factor, exponent, term)) return false;
  }
  return true;
}

bool FractionSums::read_power(const GiNaC::ex& base, int exponent, FractionTerm& term) {
  if (const auto place = place_.find(base); place != place_.end()) {
    term.powers[place->second] += exponent;
    return true;
  }
  if (!GiNaC::is_exactly_a<GiNaC::add>(base)) return false;
  if (exponent > 0 && !is_linear(base)) return false;
  const std::optional<Product>& product = factors_of(base);
  if (!product) return false;
  const cln::cl_RA scale = cln::expt(product->scale, exponent);
  term.real = term.real * scale;
  term.imaginary = term.imaginary * scale;
  for (std::size_t s = 0; s < symbols_.size(); ++s) term.powers[s] += exponent * product->powers[s];
  for (const auto& [divisor, power] : product->divisors) multiply(term.divisors, divisor, exponent * power);
  return true;
}

bool FractionSums::is_linear(const GiNaC::ex& sum) const {
  return std::all_of(sum.begin(), sum.end(), [&](const GiNaC::ex& term) {
    const bool scaled = GiNaC::is_exactly_a<GiNaC::mul>(term) && term.nops() == 2 &&
                        GiNaC::is_exactly_a<GiNaC::numeric>(term.op(1));
    return GiNaC::is_exactly_a<GiNaC::numeric>(term) || place_.contains(scaled ? term.op(0) : term);
  });
}

const std::optional<FractionSums::Product>& FractionSums::factors_of(const GiNaC::ex& base) {
  if (const auto known = products_.find(base); known != products_.end()) return known->second;
  std::optional<FractionTerms> parts = terms(base);
  if (!parts) parts = terms(base.expand());
  std::optional<Product> product;
  if (parts && std::all_of(parts->begin(), parts->end(), [](const auto& t) { return cln::zerop(t.imaginary); }))
    product = factored(sum(*parts));
  return products_[base] = std::move(product);
}

// The fraction with its numerator among the divisors; these divide: hence the signs of their powers.
std::optional<FractionSums::Product> FractionSums::factored(const FactoredFraction& fraction) {
  if (fraction.is_zero()) return std::nullopt;
  Product product{fraction.scale, fraction.powers, fraction.divisors};
  if (!fraction.numerator.is_one()) multiply(product.divisors, divisor(fraction.numerator, fraction.variables), -1);
  return product;
}

// What they have in common beyond numbers; by GiNaC, whose factors of a single polynomial may take minutes where
// greatest common divisors take milliseconds.
FractionSums::Common FractionSums::common_factor(std::size_t number, const Polynomial& other,
                                                 const std::vector<std::size_t>& variables) {
  const Polynomial& polynomial = divisors_[number].polynomial;
  if (polynomial.size() * other.size() > most_common_work)
    throw PolynomialTooLarge(fmt::format("polynomials of {} and {} terms that may have a factor in common",
                                         polynomial.size(), other.size()));
  const GiNaC::ex common = GiNaC::gcd(divisors_[number].expression, expression(other, variables));
  FactoredFraction found = sum(terms(common.expand()).value());
  return {std::move(found.numerator), std::move(found.variables)};
}

// The factor and what is left take the divisor's place from now on; false if nothing is left.
bool FractionSums::take_apart(std::size_t number, const Common& factor) {
  const std::vector<std::size_t> variables = divisors_[number].variables;
  const Polynomial rest =
      divided(divisors_[number].polynomial, in_variables(factor.polynomial, factor.variables, variables)).value();
  if (rest.is_one()) return false;
  DivisorPowers factors;
  multiply(factors, divisor(factor.polynomial, factor.variables), 1);
  multiply(factors, divisor(rest, variables), 1);
  divisors_[number].apart = std::move(factors);
  return true;
}

// The factors of divisors that were taken apart in their place, and the factors of these.
void FractionSums::bring_up_to_date(DivisorPowers& divisors) const {
  while (true) {
    const auto old = std::find_if(divisors.begin(), divisors.end(),
                                  [&](const auto& entry) { return divisors_[entry.first].apart.has_value(); });
    if (old == divisors.end()) return;
    const auto [number, power] = *old;
    divisors.erase(old);
    for (const auto& [factor, times] : *divisors_[number].apart) multiply(divisors, factor, times * power);
  }
}

FractionTerms FractionSums::up_to_date(FractionTerms terms) const {
  for (FractionTerm& term : terms) bring_up_to_date(term.divisors);
  return terms;
}

// Takes one of two divisors that have a factor in common apart; false if there are none.
bool FractionSums::separated(const DivisorPowers& divisors) {
  for (std::size_t a = 0; a < divisors.size(); ++a)
    for (std::size_t b = 0; b < a; ++b) {
      const std::size_t x = divisors[a].first, y = divisors[b].first;
      if (share_no_factor(x, y)) continue;
      const Common common = common_factor(x, divisors_[y].polynomial, divisors_[y].variables);
      if (!common.polynomial.is_one()) return take_apart(x, common) || take_apart(y, common);
      coprime_[std::minmax(x, y)] = true;
    }
  return false;
}

bool FractionSums::share_no_factor(std::size_t a, std::size_t b) {
  const Divisor &left = divisors_[a], &right = divisors_[b];
  if (left.irreducible && right.irreducible) return true;
  const auto [known, added] = coprime_.try_emplace(std::minmax(a, b));
  if (added) {
    const std::vector<std::size_t> variables = united(left.variables, right.variables);
    known->second = coprime(in_variables(left.polynomial, left.variables, variables),
                            in_variables(right.polynomial, right.variables, variables));
  }
  return known->second;
}

// In symbols that occur alone, so that one divisor has one number.
std::size_t FractionSums::divisor(const Polynomial& primitive, const std::vector<std::size_t>& variables) {
  Divisor found;
  for (std::size_t s = 0; s < variables.size(); ++s)
    for (std::size_t t = 0; t < primitive.size(); ++t)
      if (primitive.power(t, s) != 0) {
        found.variables.push_back(variables[s]);
        break;
      }
  std::vector<Polynomial::Term> terms;
  std::vector<std::string> name;
  for (std::size_t t = 0; t < primitive.size(); ++t) {
    std::ostringstream text;
    Polynomial::Term term{{}, primitive.coefficient(t)};
    text << term.coefficient;
    for (std::size_t s = 0; s < variables.size(); ++s) {
      const int power = primitive.power(t, s);
      if (std::binary_search(found.variables.begin(), found.variables.end(), variables[s]))
        term.powers.push_back(power);
      if (power != 0) text << ' ' << variables[s] << ' ' << power;
    }
    terms.push_back(std::move(term));
    name.push_back(text.str());
  }
  const auto [known, added] = number_of_.try_emplace(std::move(name), divisors_.size());
  if (added) {
    found.polynomial = Polynomial(found.variables.size(), terms);
    found.expression = expression(found.polynomial, found.variables);
    found.irreducible = of_first_degree(found.polynomial);
    divisors_.push_back(std::move(found));
  }
  return known->second;
}

// --- sums

struct FractionSums::Part {
  cln::cl_I coefficient;
  std::vector<int> powers;   // of the variables
  std::vector<int> missing;  // of each divisor, to the common denominator
};

// sum of coefficient * monomial * product of missing divisors, by Horner's rule divisor by divisor: the one that
// most parts miss multiplies all of them together, last.
class FractionSums::Combination {
 public:
  Combination(std::vector<Part> parts, std::vector<Polynomial> divisors, std::size_t variables, std::size_t& work)
      : parts_(std::move(parts)), divisors_(std::move(divisors)), variables_(variables), work_(work) {}

  Polynomial all() {
    std::vector<std::size_t> members(parts_.size()), open(divisors_.size());
    for (std::size_t i = 0; i < members.size(); ++i) members[i] = i;
    for (std::size_t i = 0; i < open.size(); ++i) open[i] = i;
    return of(members, open);
  }

 private:
  Polynomial of(const std::vector<std::size_t>& members, const std::vector<std::size_t>& open) {
    std::size_t most = 0, chosen = 0;
    std::vector<std::size_t> wanted;
    for (const std::size_t d : open) {
      const auto count = static_cast<std::size_t>(
          std::count_if(members.begin(), members.end(), [&](std::size_t m) { return parts_[m].missing[d] > 0; }));
      if (count > 0) wanted.push_back(d);
      if (count > most) {
        most = count;
        chosen = d;
      }
    }
    if (most == 0) {
      std::vector<Polynomial::Term> terms;
      for (const std::size_t m : members) terms.push_back({parts_[m].powers, parts_[m].coefficient});
      return counted(Polynomial(variables_, terms));
    }
    std::erase(wanted, chosen);
    std::map<int, std::vector<std::size_t>, std::greater<>> groups;
    for (const std::size_t m : members) groups[parts_[m].missing[chosen]].push_back(m);
    Polynomial sum(variables_);
    int power = groups.begin()->first;
    for (const auto& [missing, group] : groups) {
      for (; power > missing; --power) sum = counted(sum * divisors_[chosen]);
      sum = counted(sum + of(group, wanted));
    }
    for (; power > 0; --power) sum = counted(sum * divisors_[chosen]);
    return sum;
  }

  Polynomial counted(Polynomial p) {
    work_ += p.size();
    return p;
  }

  std::vector<Part> parts_;
  std::vector<Polynomial> divisors_;
  std::size_t variables_;
  std::size_t& work_;
};

// Divisors are taken for irreducible until it matters: where two of them have something in common, or one and a
// numerator, the one is taken apart, and the sum begun again.
FactoredFraction FractionSums::sum(const FractionTerms& terms) {
  FractionTerms current = up_to_date(terms);
  while (true) {
    std::optional<FactoredFraction> result = sum_if_apart(current);
    if (result) return std::move(*result);
    current = up_to_date(std::move(current));
  }
}

// None where a divisor had to be taken apart.
std::optional<FactoredFraction> FractionSums::sum_if_apart(const FractionTerms& terms) {
  FactoredFraction result;
  result.powers.assign(symbols_.size(), 0);
  std::vector<const FractionTerm*> present;
  for (const FractionTerm& term : terms)
    if (!cln::zerop(term.real)) present.push_back(&term);
  if (present.empty()) return result;
  if (present.size() == 1) {
    result.scale = present.front()->real;
    result.powers = present.front()->powers;
    result.divisors = present.front()->divisors;
    result.numerator = one(0);
    if (separated(result.divisors)) return std::nullopt;
    return result;
  }

  // The common denominator: the highest power of every divisor, and how many terms have it; the lowest of symbols.
  DivisorPowers highest;
  for (const FractionTerm* term : present)
    for (const auto& [divisor, power] : term->divisors)
      if (power_of(highest, divisor) == 0) multiply(highest, divisor, power);
  if (separated(highest)) return std::nullopt;
  std::vector<std::size_t> times(highest.size(), 0);
  for (std::size_t d = 0; d < highest.size(); ++d) {
    auto& [divisor, power] = highest[d];
    power = std::numeric_limits<int>::min();
    for (const FractionTerm* term : present) power = std::max(power, power_of(term->divisors, divisor));
    for (const FractionTerm* term : present) times[d] += power_of(term->divisors, divisor) == power ? 1U : 0U;
  }
  result.powers = present.front()->powers;
  std::vector<bool> varies(symbols_.size(), false);
  for (const FractionTerm* term : present)
    for (std::size_t s = 0; s < symbols_.size(); ++s) {
      varies[s] = varies[s] || term->powers[s] != result.powers[s];
      result.powers[s] = std::min(result.powers[s], term->powers[s]);
    }
  for (const auto& [divisor, power] : highest)
    for (const std::size_t variable : divisors_[divisor].variables) varies[variable] = true;
  for (std::size_t s = 0; s < symbols_.size(); ++s)
    if (varies[s]) result.variables.push_back(s);

  cln::cl_I common = 1;
  for (const FractionTerm* term : present)
    if (const cln::cl_I denominator = cln::denominator(term->real); denominator != 1)
      common = cln::lcm(common, denominator);
  std::vector<Part> parts;
  for (const FractionTerm* term : present) {
    Part part{cln::numerator(term->real) * cln::exquo(common, cln::denominator(term->real)), {}, {}};
    for (const std::size_t s : result.variables) part.powers.push_back(term->powers[s] - result.powers[s]);
    for (const auto& [divisor, power] : highest) part.missing.push_back(power - power_of(term->divisors, divisor));
    parts.push_back(std::move(part));
  }
  std::vector<Polynomial> polynomials;
  for (const auto& [divisor, power] : highest)
    polynomials.push_back(
        in_variables(divisors_[divisor].polynomial, divisors_[divisor].variables, result.variables));
  result.numerator = Combination(std::move(parts), std::move(polynomials), result.variables.size(), work_).all();
  if (result.numerator.is_zero())
    return FactoredFraction{0, std::vector<int>(symbols_.size(), 0), {}, Polynomial(), {}};
  result.scale = result.numerator.make_primitive() / common;
  const std::vector<int> monomial = result.numerator.take_out_monomial();
  for (std::size_t v = 0; v < result.variables.size(); ++v) result.powers[result.variables[v]] += monomial[v];
  // A divisor that but one term has in its highest power divides all of the numerator except that term's share.
  DivisorPowers may_cancel;
  for (std::size_t d = 0; d < highest.size(); ++d) {
    if (highest[d].second != 0) result.divisors.push_back(highest[d]);
    if (highest[d].second > 0 && times[d] > 1) may_cancel.push_back(highest[d]);
  }
  if (!reduced(result, may_cancel)) return std::nullopt;
  return result;
}

// Cancels what of these divisors cancels, up to their powers; false once one that does so in part was taken apart.
bool FractionSums::reduced(FactoredFraction& fraction, const DivisorPowers& by) {
  for (const auto& [number, most] : by) {
    const Divisor& divisor = divisors_[number];
    if (std::any_of(divisor.variables.begin(), divisor.variables.end(), [&](std::size_t v) {
          return !std::binary_search(fraction.variables.begin(), fraction.variables.end(), v);
        }))
      continue;
    const Polynomial factor = in_variables(divisor.polynomial, divisor.variables, fraction.variables);
    const auto may_cancel = [&] {
      return divisor.irreducible ? may_divide(fraction.numerator, factor) : !coprime(fraction.numerator, factor);
    };
    for (int power = most; power > 0 && may_cancel(); --power) {
      std::optional<Polynomial> quotient = divided(fraction.numerator, factor);
      if (!quotient) {
        if (divisor.irreducible) break;
        const Common common = common_factor(number, fraction.numerator, fraction.variables);
        if (common.polynomial.is_one()) break;
        take_apart(number, common);
        return false;
      }
      work_ += quotient->size();
      fraction.numerator = std::move(*quotient);
      multiply(fraction.divisors, number, -1);
    }
  }
  return true;
}

Polynomial FractionSums::expanded(const DivisorPowers& divisors, const std::vector<std::size_t>& variables) const {
  Polynomial product = one(variables.size());
  for (const auto& [divisor, power] : divisors) {
    if (power <= 0) continue;
    const Polynomial factor = in_variables(divisors_[divisor].polynomial, divisors_[divisor].variables, variables);
    for (int n = 0; n < power; ++n) product = product * factor;
  }
  return product;
}

// --- sums of fractions

std::vector<FactoredFraction> FractionSums::parts(const FractionTerms& terms) {
  std::map<DivisorPowers, FractionTerms> alike;
  for (const FractionTerm& term : up_to_date(terms)) alike[term.divisors].push_back(term);
  std::vector<FactoredFraction> result;
  std::size_t apart = 0;
  for (const auto& [divisors, group] : alike) {
    FactoredFraction part = sum(group);
    if (part.is_zero()) continue;
    apart += part.numerator.size() + part.divisors.size();
    result.push_back(std::move(part));
  }
  if (result.size() < 2) return result;
  if (joining_work(result) > most_joined) return vanishes(terms) ? std::vector<FactoredFraction>{} : result;
  FactoredFraction together = sum(terms);
  if (together.is_zero()) return {};
  if (together.numerator.size() + together.divisors.size() <= apart) return {std::move(together)};
  return result;
}

// A bound on the terms of the products that one denominator takes: of each part and what it misses.
std::size_t FractionSums::joining_work(const std::vector<FactoredFraction>& parts) const {
  std::map<std::size_t, int> highest;
  for (const FactoredFraction& part : parts)
    for (const auto& [divisor, power] : part.divisors) highest[divisor] = std::max(highest[divisor], power);
  std::size_t work = 0;
  for (const FactoredFraction& part : parts) {
    std::map<std::size_t, int> missing = highest;
    for (const auto& [divisor, power] : part.divisors) missing[divisor] -= power;
    std::size_t terms = part.numerator.size();
    for (const auto& [divisor, power] : missing)
      for (int n = 0; n < power && terms <= most_joined; ++n) terms *= divisors_[divisor].polynomial.size();
    work += terms;
    if (work > most_joined) break;
  }
  return work;
}

// Decided at a random point of the prime field.
bool FractionSums::vanishes(const FractionTerms& terms) const {
  std::vector<PrimeFieldComplex> values;
  for (std::size_t s = 0; s < symbols_.size(); ++s) values.push_back(random_value("parts", s));
  return FractionPoint(*this, std::move(values)).value(terms).is_zero();
}

// --- products

FactoredFraction FractionSums::in_lowest_terms(FactoredFraction fraction) {
  while (true) {
    bring_up_to_date(fraction.divisors);
    if (separated(fraction.divisors)) continue;
    DivisorPowers dividing;
    std::copy_if(fraction.divisors.begin(), fraction.divisors.end(), std::back_inserter(dividing),
                 [](const auto& entry) { return entry.second > 0; });
    if (reduced(fraction, dividing)) return fraction;
  }
}

FactoredFraction FractionSums::product(const FactoredFraction& a, const FactoredFraction& b) {
  if (a.is_zero()) return a;
  if (b.is_zero()) return b;
  FactoredFraction result = a;
  result.scale = a.scale * b.scale;
  for (std::size_t s = 0; s < symbols_.size(); ++s) result.powers[s] += b.powers[s];
  for (const auto& [divisor, power] : b.divisors) multiply(result.divisors, divisor, power);
  result.variables = united(a.variables, b.variables);
  result.numerator = in_variables(a.numerator, a.variables, result.variables) *
                     in_variables(b.numerator, b.variables, result.variables);
  return in_lowest_terms(std::move(result));
}

// Where one numerator divides the other one it is no divisor by itself: that would have to be taken apart.
FactoredFraction FractionSums::quotient(const FactoredFraction& above, const FactoredFraction& below) {
  if (below.is_zero()) throw std::domain_error("division by zero");
  FactoredFraction left = above, inverse = below;
  left.variables = inverse.variables = united(above.variables, below.variables);
  left.numerator = in_variables(above.numerator, above.variables, left.variables);
  Polynomial denominator = in_variables(below.numerator, below.variables, left.variables);
  if (!above.is_zero()) {
    if (std::optional<Polynomial> whole = divided(left.numerator, denominator)) {
      left.numerator = std::move(*whole);
      denominator = one(left.variables.size());
    } else if (std::optional<Polynomial> part = divided(denominator, left.numerator)) {
      left.numerator = one(left.variables.size());
      denominator = std::move(*part);
    }
  }
  inverse.scale = 1 / below.scale;
  for (int& power : inverse.powers) power = -power;
  for (auto& entry : inverse.divisors) entry.second = -entry.second;
  inverse.numerator = one(left.variables.size());
  if (!denominator.is_one()) multiply(inverse.divisors, divisor(denominator, left.variables), 1);
  return product(left, inverse);
}

// --- back to expressions

GiNaC::ex FractionSums::expression(const Polynomial& polynomial, const std::vector<std::size_t>& variables) const {
  GiNaC::exvector terms;
  for (std::size_t t = 0; t < polynomial.size(); ++t) {
    GiNaC::exvector factors = {number(polynomial.coefficient(t))};
    for (std::size_t v = 0; v < variables.size(); ++v)
      if (const int power = polynomial.power(t, v); power != 0)
        factors.push_back(GiNaC::pow(symbols_[variables[v]], power));
    terms.push_back(GiNaC::mul(factors));
  }
  return GiNaC::add(terms);
}

GiNaC::ex FractionSums::expression(const FractionTerms& terms) const {
  GiNaC::exvector sum;
  for (const FractionTerm& term : terms) {
    GiNaC::exvector factors = {number(term.real) + GiNaC::I * number(term.imaginary)};
    for (std::size_t s = 0; s < symbols_.size(); ++s)
      if (term.powers[s] != 0) factors.push_back(GiNaC::pow(symbols_[s], term.powers[s]));
    for (const auto& [divisor, power] : term.divisors)
      factors.push_back(GiNaC::pow(divisors_[divisor].expression, -power));
    sum.push_back(GiNaC::mul(factors));
  }
  return GiNaC::add(sum);
}

GiNaC::ex FractionSums::expression(const FactoredFraction& fraction) const {
  if (fraction.is_zero()) return 0;
  return expression({{fraction.scale, 0, fraction.powers, fraction.divisors}}) *
         expression(fraction.numerator, fraction.variables);
}

bool FractionSums::has(const FractionTerms& terms, std::size_t symbol) const {
  return std::any_of(terms.begin(), terms.end(), [&](const FractionTerm& term) {
    return term.powers[symbol] != 0 ||
           std::any_of(term.divisors.begin(), term.divisors.end(), [&](const auto& entry) {
             const std::vector<std::size_t>& variables = divisors_[entry.first].variables;
             return std::binary_search(variables.begin(), variables.end(), symbol);
           });
  });
}

// --- values

FractionPoint::FractionPoint(const FractionSums& sums, std::vector<PrimeFieldComplex> values)
    : sums_(sums), values_(std::move(values)) {
  for (const PrimeFieldComplex& value : values_) inverses_.push_back(value.inverse());
}

PrimeFieldComplex FractionPoint::value(const FractionTerms& terms) {
  for (std::size_t d = divisors_.size(); d < sums_.divisors(); ++d) {
    std::vector<PrimeFieldComplex> point;
    for (const std::size_t variable : sums_.variables(d)) point.push_back(values_[variable]);
    divisors_.push_back(value_at(sums_.divisor(d), point));
    inverse_divisors_.push_back(divisors_.back().inverse());
  }
  PrimeFieldComplex sum;
  for (const FractionTerm& term : terms) {
    PrimeFieldComplex product = residue(cln::numerator(term.real));
    if (const cln::cl_I denominator = cln::denominator(term.real); denominator != 1)
      product *= residue(denominator).inverse();
    for (std::size_t s = 0; s < values_.size(); ++s)
      if (term.powers[s] != 0) product *= to_power(values_[s], inverses_[s], term.powers[s]);
    for (const auto& [divisor, power] : term.divisors)
      product *= to_power(inverse_divisors_[divisor], divisors_[divisor], power);
    sum += product;
  }
  return sum;
}

}  // namespace secular
