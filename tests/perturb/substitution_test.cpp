#include "perturb/substitution.hpp"

#include <gtest/gtest.h>

#include "textbook_models.hpp"

namespace secular {
namespace {

using Exact = Substitution<ExactArithmetic>;

constexpr std::uint64_t draw = 5;

// x = A exp(i w t) + conj with dA/dt given by hand: [n] is the factor of A at eps^n.
Derivation by_hand(const Model& model, const std::vector<GiNaC::ex>& rates) {
  Derivation d = derive(model, model.cases[0]);
  d.response[0] = FieldSeries{d.response[0][0], {}, {}};
  d.slow_derivative[0] = FieldSeries(3);
  FieldKey key(d.layout.size(), 0);
  key[d.layout.amplitude(0)] = 1;
  for (std::size_t n = 1; n < rates.size(); ++n) d.slow_derivative[0][n].add(key, rates[n]);
  return d;
}

// Coefficients that are not zero.
std::map<TrueTimePowers, PrimeFieldComplex> left_at(const Exact::Polynomial& residual, std::size_t order) {
  std::map<TrueTimePowers, PrimeFieldComplex> left;
  for (const auto& [powers, value] : residual.orders()[order])
    if (!value.is_zero()) left[powers] = value;
  return left;
}

TEST(Substitution, TheDampedLinearOscillatorIsSolvedByItsKnownMotion) {
  // x = exp(-mu t) cos(sqrt(w^2 - mu^2) t): dA/dt = (-mu - i mu^2/(2 w) + O(mu^4)) A.
  const Model model = read_model_text(
      textbook::one_mode("D2(x) + w^2*x = -2*mu*D(x)", "order = { mu = 1 }\nexcitation = false"), "m");
  const GiNaC::ex mu = model.symbols.at("mu"), w = model.symbols.at("w");
  const Derivation known = by_hand(model, {0, -mu, -GiNaC::I * mu * mu / (2 * w)});
  const auto residual = Exact(known, {draw}).residual(0);
  for (std::size_t n = 0; n <= 2; ++n) EXPECT_TRUE(left_at(residual, n).empty()) << n;
}

TEST(Substitution, TheResidualIsWhatAnIncompleteMotionLeaves) {
  // With dA/dt = -mu A: (i w - mu)^2 + w^2 + 2 mu (i w - mu) = -mu^2, times x.
  const Model model = read_model_text(
      textbook::one_mode("D2(x) + w^2*x = -2*mu*D(x)", "order = { mu = 1 }\nexcitation = false"), "m");
  const Derivation incomplete = by_hand(model, {0, -model.symbols.at("mu")});
  const auto residual = Exact(incomplete, {draw}).residual(0);
  EXPECT_TRUE(left_at(residual, 0).empty());
  EXPECT_TRUE(left_at(residual, 1).empty());
  const PrimeFieldComplex mu = random_value("mu", draw);
  const std::map<TrueTimePowers, PrimeFieldComplex> expected{{{1, 1, 0, 0, 0, 0}, -(mu * mu)},
                                                             {{-1, 0, 1, 0, 0, 0}, -(mu * mu)}};
  EXPECT_EQ(left_at(residual, 2), expected);
  EXPECT_EQ(to_string({1, 1, 0, 0, 0, 0}, model), "A_x*exp(i*(w)*t)");
}

TEST(Substitution, LagrangesEquationsAreThoseOfNewton) {
  // T = (1 + g x^2) x'^2/2, V = w^2 x^2/2 + a x^4/4: the same residual on a motion that solves neither.
  const std::string order = "order = { g = 1, a = 1 }\nexcitation = false";
  const Model newton =
      read_model_text(textbook::one_mode("D2(x) + g*x^2*D2(x) + g*x*D(x)^2 + w^2*x + a*x^3 = 0", order), "m");
  const Model lagrange = read_model_text(
      "schema = 1\nname = \"m\"\n[lagrangian]\nkinetic = \"(1 + g*x^2)*D(x)^2/2\"\npotential = \"w^2*x^2/2 + "
      "a*x^4/4\"\n[[mode]]\ncoordinate = \"x\"\nfrequency = \"w\"\n[[case]]\nname = \"c\"\n" +
          order + "\n",
      "m");
  const auto residual = [](const Model& model) {
    const Derivation wrong = by_hand(model, {0, GiNaC::I * model.symbols.at("a"), model.symbols.at("g")});
    return Exact(wrong, {draw}).residual(0);
  };
  const auto by_newton = residual(newton), by_lagrange = residual(lagrange);
  for (std::size_t n = 0; n <= 2; ++n) EXPECT_EQ(left_at(by_newton, n), left_at(by_lagrange, n)) << n;
  EXPECT_FALSE(left_at(by_newton, 1).empty());
}

TEST(Substitution, NonsmoothTermsAreSeenByNumbers) {
  const Model model = read_model_text(
      textbook::one_mode("D2(x) + w^2*x = -c*x*abs(x)", "order = { c = 2 }\nexcitation = false"), "m");
  const Derivation derivation = derive(model, model.cases[0]);
  Substitution<FloatingArithmetic> substitution(derivation, {draw});
  const auto residual = substitution.residual(0);
  EXPECT_TRUE(substitution.nonsmooth());
  const auto harmonics =
      at_amplitudes(residual.orders()[2], substitution.motion().variables(), substitution.amplitudes());
  EXPECT_LT(std::abs(harmonics.at({1})), 1e-13);
  EXPECT_LT(std::abs(harmonics.at({3})), 1e-13);
  EXPECT_GT(std::abs(harmonics.at({15})), 1e-6);  // beyond what the expansion claims
}

}  // namespace
}  // namespace secular
