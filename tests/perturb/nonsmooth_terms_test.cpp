#include "perturb/nonsmooth_terms.hpp"

#include <gtest/gtest.h>

#include "input/input_error.hpp"
#include "perturb/nonsmooth.hpp"
#include "textbook_models.hpp"

namespace secular {
namespace {

Model oscillator(const std::string& right, const std::string& order) {
  return read_model_text(
      textbook::one_mode("D2(x) + w^2*x = " + right, "excitation = false\norder = { " + order + " }"), "m");
}

NonsmoothTerms told_apart(const Model& model, bool sinusoidal) {
  const std::vector<OrderedEquation> equations = ordered_equations(model, model.cases[0]);
  return tell_nonsmooth_apart(equations[0], 0, model, model.cases[0], {sinusoidal});
}

TEST(NonsmoothTerms, WhatHasNoClosedSeriesGoesToQuadrature) {
  const Model model = oscillator("-g*x^3 - c*sgn(D(x)) - k*abs(x - gap)", "g = 1, c = 2, k = 2");
  const NonsmoothTerms one_harmonic = told_apart(model, true);
  EXPECT_EQ(one_harmonic.expanded.size(), 2U);  // x^3 and sgn(D(x))
  ASSERT_EQ(one_harmonic.quadratures.size(), 1U);
  EXPECT_EQ(to_string(one_harmonic.quadratures[0].factors, model), "abs(gap - x)");
  EXPECT_EQ(one_harmonic.quadratures[0].order, 2);
  // A leading motion of several harmonics leaves no closed series to sgn(D(x)) either.
  EXPECT_EQ(told_apart(model, false).quadratures.size(), 2U);
}

TEST(NonsmoothTerms, WhatWouldHaveToBeExpandedFurtherIsRefused) {
  EXPECT_THROW(told_apart(oscillator("-c*sgn(D(x))", "c = 1"), true), InputError);
  EXPECT_THROW(told_apart(oscillator("-k*abs(x - gap)", "k = 1"), true), InputError);
  EXPECT_THROW(told_apart(oscillator("-k*abs(x)*abs(D(x))", "k = 2"), true), InputError);
  EXPECT_NO_THROW(told_apart(oscillator("-k*abs(x)*x", "k = 2"), true));
}

TEST(NonsmoothTerms, HarmonicsAreCompleteUntilALaterTermMixesThem) {
  const auto complete = [](const std::string& right, const std::string& order, int expand_to) {
    Model model = oscillator(right, order);
    model.cases[0].expand_to = expand_to;
    return complete_harmonics(ordered_equations(model, model.cases[0]), model, model.cases[0]);
  };
  const int all = highest_nonsmooth_harmonic;
  EXPECT_EQ(complete("-g*x^3", "g = 1", 2), (std::vector<int>{all, all, all}));
  EXPECT_EQ(complete("-c*sgn(D(x))", "c = 2", 2), (std::vector<int>{all, all, all}));
  // A response to sgn at eps^2 times two leading oscillations: two harmonics less at eps^3.
  EXPECT_EQ(complete("-g*x^3 - c*x*abs(x)", "g = 1, c = 2", 3), (std::vector<int>{all, all, all, all - 2}));
}

}  // namespace
}  // namespace secular
