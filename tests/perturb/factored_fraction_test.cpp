#include "perturb/factored_fraction.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "perturb/lump_equations.hpp"
#include "perturb/model.hpp"

namespace secular {
namespace {

using GiNaC::ex;

class FactoredFractions : public testing::Test {
 protected:
  static GiNaC::exvector terms(const ex& sum) {
    const ex expanded = sum.expand();
    if (!GiNaC::is_a<GiNaC::add>(expanded)) return {expanded};
    return {expanded.begin(), expanded.end()};
  }
  // What GiNaC's greatest common divisors make of it, up to a number.
  static void expect_lowest_terms(const ex& sum, const FactoredFraction& fraction, const FractionSums& sums) {
    const ex right = sum.normal().numer_denom(), found = sums.expression(fraction);
    EXPECT_TRUE((found - sum).normal().is_zero()) << sum << ": " << found;
    if (fraction.is_zero()) return;
    ex below = 1;
    for (std::size_t s = 0; s < fraction.powers.size(); ++s)
      if (fraction.powers[s] < 0) below *= GiNaC::pow(letters[s], -fraction.powers[s]);
    below *= sums.expression({{1, 0, std::vector<int>(letters.size(), 0), negative(fraction.divisors)}});
    ex ratio;
    EXPECT_TRUE(GiNaC::divide(below.expand(), right.op(1).expand(), ratio)) << sum;
    EXPECT_TRUE(GiNaC::is_a<GiNaC::numeric>(ratio)) << sum << ": " << below;
  }
  static DivisorPowers negative(const DivisorPowers& divisors) {
    DivisorPowers result;
    for (const auto& [divisor, power] : divisors)
      if (power > 0) result.emplace_back(divisor, -power);
    return result;
  }

  static inline const ex a = GiNaC::realsymbol("a"), b = GiNaC::realsymbol("b"), c = GiNaC::realsymbol("c"),
                         g = GiNaC::realsymbol("g");
  static inline const GiNaC::exvector letters = {a, b, c, g};
};

TEST_F(FactoredFractions, AreInLowestTerms) {
  const std::vector<ex> list = {
      ex(0), ex(7) / 3, a, 1 / a, a / b + b / a, 1 / (a - b) + 1 / (b - a), 1 / (a - b) - 1 / (a + b),
      // b cancels, then (a-b), then all
      1 / (b * (a - b)) - 1 / (a * (a - b)), 1 / (a * b) - 1 / (a * (a + b)) - 1 / (b * (a + b)),
      g / (2 * a - 4 * b) - 3 * g / pow(2 * b - a, 3), a / (pow(a, 2) - pow(b, 2)) + b / pow(a - b, 2),
      1 / (pow(a, 2) + pow(b, 2)) + 1 / (pow(a, 4) - pow(b, 4)), 1 / (1 + a) + 1 / (1 - a) - 2 / (1 - a * a),
      pow(a, 2) / ((a - b) * (a - c)) + pow(b, 2) / ((b - a) * (b - c)) + pow(c, 2) / ((c - a) * (c - b)),
      pow(a, 3) / ((a - b) * (a - c)) + pow(b, 3) / ((b - a) * (b - c)) + pow(c, 3) / ((c - a) * (c - b)),
      g / (6 * a * (3 * a + 2 * b - c)) + 5 * a / (4 * b * (c - 2 * b - 3 * a)) - b / (9 * c * pow(a, 2)),
      // fractions in denominators
      1 / (a + 1 / b) + g / (1 + 1 / (a - b)), 1 / (a / (a + b) + b / (a - b)) - 1 / a,
      // divisors that are products themselves, met before and after their factors
      1 / (a * b + b * b + a * c + b * c) + 1 / (a + b), c / (pow(a, 2) - 2 * a * b + pow(b, 2)) - 1 / (a - b),
      1 / (pow(a, 3) - pow(b, 3)) - 1 / (pow(a, 3) + pow(a, 2) * b - a * b * b - pow(b, 3)),
      // a numerator that has one factor of a divisor
      a / (a * b + a * a + c * a + b * c) + b / (a * b + a * a + c * a + b * c)};
  FractionSums together(letters);
  for (const ex& sum : list) {
    FractionSums alone(letters);
    for (FractionSums* sums : {&alone, &together}) {
      const auto parts = sums->terms(sum.expand());
      ASSERT_TRUE(parts) << sum;
      expect_lowest_terms(sum, sums->sum(*parts), *sums);
    }
  }
  // Quotients and products of them all.
  const auto fraction = [&](const ex& sum) { return together.sum(together.terms(sum.expand()).value()); };
  for (const ex& left : list)
    for (const ex& right : list) {
      expect_lowest_terms(left * right, together.product(fraction(left), fraction(right)), together);
      if (fraction(right).is_zero())
        EXPECT_THROW(together.quotient(fraction(left), fraction(right)), std::domain_error);
      else
        expect_lowest_terms(left / right, together.quotient(fraction(left), fraction(right)), together);
    }
}

// Factors of a single one of these polynomials may take minutes, what two have in common milliseconds.
TEST_F(FactoredFractions, DivisorsOfHighDegreeAreTakenApart) {
  const ex s = a + b + c + g;
  for (const ex& sum : {1 / (pow(s, 6) - 1) + 1 / (pow(s, 4) - 1), a / (pow(s, 8) - 1) - 1 / (pow(s, 6) - 1),
                        1 / (pow(s, 2) - 1) - 1 / (pow(s, 4) - 1) - 1 / (pow(s, 8) - 1)}) {
    FractionSums sums(letters);
    ex written = 0;  // divisors multiplied out
    for (const ex& term : terms(sum)) {
      const ex parts = term.numer_denom();
      written += parts.op(0) / parts.op(1).expand();
    }
    expect_lowest_terms(written, sums.sum(sums.terms(written).value()), sums);
  }
}

// What was taken apart before is taken apart further, wherever it is written.
TEST_F(FactoredFractions, FactorsAreTakenApartInTurn) {
  FractionSums sums(letters);
  const ex three = 1 / ((a + b) * (a - b) * (a + c)).expand();
  for (const ex& sum : {three + 1 / ((a - b) * (a + c)).expand(), three + 1 / (a + c), three + 1 / (a - b),
                        three * a, three / (a + b)})
    expect_lowest_terms(sum, sums.sum(sums.terms(sum).value()), sums);
}

TEST_F(FactoredFractions, DivisorsTooLongForWhatTheyHaveInCommonAreRefused) {
  FractionSums sums(letters);
  const ex s = a + b + c + g;
  const FractionTerms sum = sums.terms(1 / (pow(s, 21) - 1).expand() + 1 / (pow(s, 15) - 1).expand()).value();
  EXPECT_THROW(sums.sum(sum), PolynomialTooLarge);
}

TEST_F(FactoredFractions, RealAndImaginaryPartsAreApart) {
  FractionSums sums(letters);
  const ex sum = (a + 2 * GiNaC::I * b) * (3 - GiNaC::I) / (a - b) + GiNaC::I / c;
  const FractionTerms terms = sums.terms(sum.expand()).value();
  EXPECT_TRUE((sums.expression(sums.sum(real_part(terms))) - (3 * a + 2 * b) / (a - b)).normal().is_zero());
  EXPECT_TRUE(
      (sums.expression(sums.sum(imaginary_part(terms))) - (6 * b - a) / (a - b) - 1 / c).normal().is_zero());
}

TEST_F(FactoredFractions, WhatIsNoQuotientOfPolynomialsIsRefused) {
  FractionSums sums(letters);
  EXPECT_FALSE(sums.terms(GiNaC::sin(a)));
  EXPECT_FALSE(sums.terms(GiNaC::sqrt(a)));
  EXPECT_FALSE(sums.terms(a * 0.5));
  EXPECT_FALSE(sums.terms(1 / (b + GiNaC::sin(a))));
  EXPECT_FALSE(sums.terms(GiNaC::symbol("other")));
  EXPECT_TRUE(sums.terms(a / b));
}

// A local spring in physical coordinates: every mode meets every other, with all their small divisors.
std::string local_spring(int modes, int degree) {
  std::string text = "schema = 1\nname = \"m\"\n", sum, order;
  for (int i = 0; i < modes; ++i) {
    sum += fmt::format("{}v{}", i > 0 ? "+" : "", i);
    order += fmt::format(", mu{} = 2", i);
  }
  for (int i = 0; i < modes; ++i)
    text += fmt::format(
        "[[mode]]\ncoordinate = \"v{0}\"\nfrequency = \"w{0}\"\nequation = \"D2(v{0}) + w{0}^2*v{0} = "
        "-2*mu{0}*D(v{0}) "
        "- b*({1})^{2} + f*F*cos(Omega*t)\"\n",
        i, sum, degree);
  return text +
         fmt::format(
             "[[case]]\nname = \"c\"\nrelations = [\"Omega = w0 + eps^2*sigma\"]\norder = {{ f = 2, b = {}{} }}\n"
             "expand_to = 2\n",
             degree == 2 ? 1 : 2, order);
}

// 5*a - 4*b vanishes at a = 4, b = 5; of a zero nothing is a multiple.
TEST_F(FactoredFractions, LumpsThatVanishAtAPointAreFound) {
  for (const char* const force : {"c*a*b*(5*a-4*b)*x^3", "c*a*b*(b-a-1)*(5*a-4*b)*x^3", "c*a*b*(c-a)*(b-c)*x^3"}) {
    const Model model = read_model_text(
        fmt::format("schema = 1\nname = \"m\"\n[[mode]]\ncoordinate = \"x\"\nfrequency = \"w\"\n"
                    "equation = \"D2(x) + w^2*x = -2*mu*D(x) - {} + e*F*cos(Omega*t)\"\n[[case]]\nname = \"c\"\n"
                    "relations = [\"Omega = w + eps*sigma\"]\n"
                    "order = {{ mu = 1, c = 1, a = 0, b = 0, e = 1 }}\nexpand_to = 1\n",
                    force),
        "model.toml");
    const Derivation nominal = derive(model, model.find_case("c")),
                     kept = derive(model, model.find_case("c"), OmegaPolicy::kept);
    FractionSums sums(model.symbols.with_pi());
    EXPECT_EQ(lump_equations(nominal, kept, sums).lumps.size(), 3U) << force;
  }
}

TEST_F(FactoredFractions, LumpsOfThreeModesWithALocalSpringAreFound) {
  for (const int degree : {2, 3}) {
    const Model model = read_model_text(local_spring(3, degree), "model.toml");
    const Derivation nominal = derive(model, model.find_case("c")),
                     kept = derive(model, model.find_case("c"), OmegaPolicy::kept);
    FractionSums sums(model.symbols.with_pi());
    const LumpEquations seen = lump_equations(nominal, kept, sums);
    EXPECT_FALSE(seen.lumps.empty());
  }
}

}  // namespace
}  // namespace secular
