#include "perturb/polynomial.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <vector>

namespace secular {
namespace {

using Terms = std::map<std::vector<int>, cln::cl_I>;

Terms terms_of(const Polynomial& p) {
  Terms terms;
  for (std::size_t t = 0; t < p.size(); ++t) terms[p.powers(t)] = p.coefficient(t);
  return terms;
}

Polynomial random_polynomial(std::size_t symbols, std::size_t terms, std::mt19937_64& random) {
  std::vector<Polynomial::Term> list;
  for (std::size_t t = 0; t < terms; ++t) {
    std::vector<int> powers;
    for (std::size_t s = 0; s < symbols; ++s) powers.push_back(static_cast<int>(random() % 4));
    list.push_back({powers, cln::cl_I(static_cast<long>(random() % 2001) - 1000)});
  }
  return {symbols, list};
}

Terms product_by_definition(const Polynomial& a, const Polynomial& b) {
  Terms product;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) {
      std::vector<int> powers = a.powers(i);
      for (std::size_t s = 0; s < powers.size(); ++s) powers[s] += b.power(j, s);
      product[powers] = product[powers] + a.coefficient(i) * b.coefficient(j);
    }
  std::erase_if(product, [](const auto& term) { return cln::zerop(term.second); });
  return product;
}

TEST(Polynomials, MultiplyAddAndDivideAsByDefinition) {
  std::mt19937_64 random(1);
  for (int draw = 0; draw < 300; ++draw) {
    const std::size_t symbols = random() % 6;  // none, one word, two
    const Polynomial a = random_polynomial(symbols, random() % 12, random),
                     b = random_polynomial(symbols, random() % 20, random);
    const Polynomial product = a * b;
    EXPECT_EQ(terms_of(product), product_by_definition(a, b));
    Terms sum = terms_of(a);
    for (const auto& [powers, value] : terms_of(b)) sum[powers] = sum[powers] + value;
    std::erase_if(sum, [](const auto& term) { return cln::zerop(term.second); });
    EXPECT_EQ(terms_of(a + b), sum);
    for (std::size_t t = 0; t + 1 < product.size(); ++t) EXPECT_GT(product.powers(t), product.powers(t + 1));
    if (b.is_zero()) continue;
    const auto quotient = divided(product, b);
    ASSERT_TRUE(quotient);
    EXPECT_EQ(*quotient, a);
    // One term more is no multiple, unless the divisor is a number.
    const Polynomial one(symbols, {{std::vector<int>(symbols, 0), 1}});
    if (b.size() > 1) {
      EXPECT_FALSE(divided(product + one, b) && divided(product + one + one, b));
    }
  }
}

TEST(Polynomials, NumbersAndMonomialsAreTakenOut) {
  Polynomial p(2, {{{3, 1}, -6}, {{1, 2}, 4}, {{1, 1}, -10}});
  EXPECT_EQ(p.make_primitive(), -2);
  EXPECT_EQ(p.take_out_monomial(), (std::vector<int>{1, 1}));
  EXPECT_EQ(terms_of(p), (Terms{{{2, 0}, 3}, {{0, 1}, -2}, {{0, 0}, 5}}));
  EXPECT_EQ(terms_of(p.renumbered({0, 2}, 3)), (Terms{{{2, 0, 0}, 3}, {{0, 0, 1}, -2}, {{0, 0, 0}, 5}}));
}

TEST(Polynomials, WhatDoesNotFitIsRefused) {
  const Polynomial high(1, {{{Polynomial::highest_power}, 1}, {{0}, 1}}), one(1, {{{1}, 1}, {{0}, 1}});
  EXPECT_THROW(high * one, PolynomialTooLarge);
  EXPECT_THROW(Polynomial(1, {{{Polynomial::highest_power + 1}, 1}}), PolynomialTooLarge);
  EXPECT_THROW(Polynomial(1, {{{-1}, 1}}), PolynomialTooLarge);
  // Powers of x times powers of y: no two products are the same monomial.
  std::vector<Polynomial::Term> of_x, of_y;
  for (int n = 0; n <= 1000; ++n) {
    of_x.push_back({{n, 0}, 1});
    of_y.push_back({{0, n}, 1});
  }
  const Polynomial x(2, of_x), y(2, of_y);
  static_assert(1001 * 1001 > Polynomial::most_terms);
  EXPECT_THROW(x * y, PolynomialTooLarge);
}

}  // namespace
}  // namespace secular
