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
  static void expect_lowest_terms(const ex& sum) {
    FractionSums sums;
    const auto fraction = sums.sum(terms(sum));
    ASSERT_TRUE(fraction) << sum;
    const ex below = expanded_product(1, fraction->denominator), right = sum.normal().numer_denom();
    EXPECT_TRUE((fraction->numerator * right.op(1) - right.op(0) * below).expand().is_zero()) << sum;
    ex ratio;
    EXPECT_TRUE(right.op(0).is_zero() || GiNaC::divide(below, right.op(1).expand(), ratio)) << sum;
    EXPECT_TRUE(right.op(0).is_zero() || GiNaC::is_a<GiNaC::numeric>(ratio)) << sum << ": " << below;
  }

  const GiNaC::symbol a{"a"}, b{"b"}, c{"c"}, g{"g"};
};

TEST_F(FactoredFractions, AreInLowestTerms) {
  const std::vector<ex> sums = {
      ex(0), ex(7) / 3, a, 1 / a, a / b + b / a, 1 / (a - b) + 1 / (b - a), 1 / (a - b) - 1 / (a + b),
      // b cancels, then (a-b), then all
      1 / (b * (a - b)) - 1 / (a * (a - b)), 1 / (a * b) - 1 / (a * (a + b)) - 1 / (b * (a + b)),
      g / (2 * a - 4 * b) - 3 * g / pow(2 * b - a, 3), a / (pow(a, 2) - pow(b, 2)) + b / pow(a - b, 2),
      1 / (pow(a, 2) + pow(b, 2)) + 1 / (pow(a, 4) - pow(b, 4)), 1 / (1 + a) + 1 / (1 - a) - 2 / (1 - a * a),
      pow(a, 2) / ((a - b) * (a - c)) + pow(b, 2) / ((b - a) * (b - c)) + pow(c, 2) / ((c - a) * (c - b)),
      pow(a, 3) / ((a - b) * (a - c)) + pow(b, 3) / ((b - a) * (b - c)) + pow(c, 3) / ((c - a) * (c - b)),
      g / (6 * a * (3 * a + 2 * b - c)) + 5 * a / (4 * b * (c - 2 * b - 3 * a)) - b / (9 * c * pow(a, 2))};
  for (const ex& sum : sums) expect_lowest_terms(sum);
}

TEST_F(FactoredFractions, WhatIsNoProductOfPolynomialsIsLeftAlone) {
  FractionSums sums;
  EXPECT_FALSE(sums.sum({GiNaC::pow(a + 1 / b, -1)}));
  EXPECT_FALSE(sums.sum({GiNaC::sin(a)}));
  EXPECT_TRUE(sums.sum({a / b}));
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

TEST_F(FactoredFractions, LumpsOfThreeModesWithALocalSpringAreFound) {
  for (const int degree : {2, 3}) {
    const Model model = read_model_text(local_spring(3, degree), "model.toml");
    const Derivation nominal = derive(model, model.find_case("c")),
                     kept = derive(model, model.find_case("c"), OmegaPolicy::kept);
    const LumpEquations seen = lump_equations(nominal, kept);
    EXPECT_FALSE(seen.lumps.empty());
  }
}

}  // namespace
}  // namespace secular
