#include "perturb/function_expansion.hpp"

#include "perturb/smooth_reading.hpp"

namespace secular {
namespace {

// Guard: some seconds of work. A function of ten coordinates to degree five takes 14,000.
constexpr std::size_t most_products = 200'000;

// f' = f2, f2' = sign * f from two values at zero: sin, cos, sinh, cosh, exp.
GiNaC::exvector of_second_order(int value, int slope, int sign, int highest) {
  GiNaC::exvector c{value, slope};
  for (int n = 2; n <= highest; ++n)
    c.push_back(c[static_cast<std::size_t>(n - 2)] * GiNaC::numeric(sign, n * (n - 1)));
  return c;
}

// f' = 1 + sign * f^2: tan, tanh.
GiNaC::exvector of_riccati(int sign, int highest) {
  GiNaC::exvector c{0};
  for (std::size_t n = 0; static_cast<int>(n) < highest; ++n) {
    GiNaC::ex square = 0;
    for (std::size_t i = 0; i <= n; ++i) square += c[i] * c[n - i];
    c.push_back(((n == 0 ? 1 : 0) + sign * square) / static_cast<int>(n + 1));
  }
  return c;
}

}  // namespace

int degree_in_coordinates(const FactorProduct& product) {
  int degree = 0;
  for (const auto& [factor, power] : product)
    if (factor.kind == Factor::Kind::coordinate || factor.kind == Factor::Kind::absolute) degree += power;
  return degree;
}

GiNaC::exvector taylor_coefficients(SmoothKind kind, std::pair<long, long> exponent, const GiNaC::ex& rest,
                                    int highest) {
  GiNaC::exvector c;
  switch (kind) {
    case SmoothKind::sine:
      return of_second_order(0, 1, -1, highest);
    case SmoothKind::cosine:
      return of_second_order(1, 0, -1, highest);
    case SmoothKind::exponential:
      return of_second_order(1, 1, 1, highest);
    case SmoothKind::hyperbolic_sine:
      return of_second_order(0, 1, 1, highest);
    case SmoothKind::hyperbolic_cosine:
      return of_second_order(1, 0, 1, highest);
    case SmoothKind::tangent:
      return of_riccati(1, highest);
    case SmoothKind::hyperbolic_tangent:
      return of_riccati(-1, highest);
    case SmoothKind::logarithm:
      for (int n = 0; n <= highest; ++n)
        c.emplace_back(n == 0 ? GiNaC::ex(0) : GiNaC::numeric(n % 2 == 0 ? -1 : 1, n));
      return c;
    case SmoothKind::arc_tangent:
      for (int n = 0; n <= highest; ++n)
        c.emplace_back(n % 2 == 0 ? GiNaC::ex(0) : GiNaC::numeric(n % 4 == 3 ? -1 : 1, n));
      return c;
    case SmoothKind::power:
      break;
  }
  const GiNaC::numeric p(exponent.first, exponent.second);
  c.push_back(exponent.second == 1 ? GiNaC::pow(rest, p) : 1);
  for (int n = 1; n <= highest; ++n) c.push_back(c.back() * (p - n + 1) / (n * rest));
  return c;
}

TermSum FunctionExpansions::times(const TermSum& a, const TermSum& b) {
  TermSum result;
  for (const auto& [left, x] : a.terms()) {
    const int degree = degree_in_coordinates(left);
    for (const auto& [right, y] : b.terms()) {
      if (degree + degree_in_coordinates(right) > highest_) continue;
      if (++products_ > most_products) throw ExpansionTooLong("has too many terms in its expansion");
      FactorProduct product = left;
      for (const auto& [factor, power] : right) product[factor] += power;
      result.add(product, (x * y).expand());
    }
  }
  return result;
}

const TermSum& FunctionExpansions::of(const SmoothFunction& function) {
  const auto known = known_.find(function);
  if (known != known_.end()) return known->second;
  const GiNaC::ex rest = value_at_rest(function.argument()).normal();
  TermSum moving = of(function.argument());
  moving += TermSum::constant(-moving.constant_part());
  const GiNaC::exvector c = taylor_coefficients(function.kind(), function.exponent(), rest, highest_);
  TermSum series;  // Horner's rule
  for (int n = highest_; n >= 0; --n) {
    series = times(series, moving);
    series += TermSum::constant(c[static_cast<std::size_t>(n)].expand());
  }
  return known_.emplace(function, std::move(series)).first->second;
}

TermSum FunctionExpansions::of(const FactorProduct& product, const GiNaC::ex& coefficient) {
  FactorProduct polynomial = product;
  std::erase_if(polynomial, [](const auto& entry) { return entry.first.kind == Factor::Kind::smooth; });
  TermSum result;
  if (degree_in_coordinates(polynomial) > highest_) return result;
  result.add(polynomial, coefficient);
  for (const auto& [factor, power] : product)
    for (int i = 0; factor.kind == Factor::Kind::smooth && i < power; ++i)
      result = times(result, of(factor.function));
  return result;
}

TermSum FunctionExpansions::of(const TermSum& sum) {
  TermSum result;
  for (const auto& [product, coefficient] : sum.terms()) result += of(product, coefficient);
  return result;
}

}  // namespace secular
