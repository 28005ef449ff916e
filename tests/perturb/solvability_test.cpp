#include "perturb/solvability.hpp"

#include "field_value.hpp"
#include "perturb/inverse_sums.hpp"

namespace secular {
namespace {

using namespace testing_fields;

const std::string model_text = R"model(
schema = 1
name = "m"
[[mode]]
coordinate = "x"
frequency = "w1"
equation = "D2(x) + w1^2*x = g*x*y + h*x*F*cos(Omega*t)"
[[mode]]
coordinate = "y"
frequency = "w2"
equation = "D2(y) + w2^2*y = g*x^2"
[[case]]
name = "c"
relations = ["w2 = 2*w1 + eps*sigma1", "Omega = w1 + w2 + eps*sigma2"]
order = { g = 1, h = 1 }
)model";

// Forcing whose phases stand for some two dozen frequencies, a few of them resonant.
Field forcing(const FieldLayout& layout) {
  std::mt19937 random(6);
  Field sum = random_field(layout, 60, random);
  for (const Phase& phase : {Phase{1, 0, 0}, Phase{-1, 1, 0}, Phase{0, -1, 1}, Phase{2, 0, 0}, Phase{-1, 0, 1}}) {
    FieldKey key(layout.size(), 0);
    std::copy(phase.begin(), phase.end(), key.begin());
    Field one;
    one.add(key, GiNaC::numeric(3, 7) + GiNaC::I);
    sum += one;
    sum += one.conjugated(layout);
  }
  return sum;
}

TEST(Solvability, SecularAndOscillatingPartsAddUpToTheForcing) {
  const Model model = read_model_text(model_text, "m");
  const ResonanceLattice lattice(model, model.cases[0]);
  const FieldLayout layout{2, 1, 2};
  const Field whole = forcing(layout);
  std::mt19937 random(7);
  for (std::size_t mode = 0; mode < 2; ++mode) {
    const SplitForcing split = split_forcing(whole, mode, layout, lattice);
    EXPECT_FALSE(split.secular.empty());
    Point at = random_point(layout, random);
    // Slow phases are what the relations leave of the fast ones: w2 - 2 w1 and Omega - w1 - w2.
    at.phases[3] = at.phases[1] - 2 * at.phases[0];
    at.phases[4] = at.phases[2] - at.phases[0] - at.phases[1];
    const Complex secular = value(split.secular, layout, at) * std::polar(1.0, at.phases[mode]);
    expect_near(value(split.oscillating, layout, at) + 2 * secular.real(), value(whole, layout, at), 1e-12);
    for (const auto& [key, ignored] : split.secular.terms())
      for (std::size_t i = 0; i < layout.frequencies(); ++i) EXPECT_EQ(key[i], 0);
  }
}

TEST(Solvability, WhatIsLeftHasAnotherFrequency) {
  const Model model = read_model_text(model_text, "m");
  const ResonanceLattice lattice(model, model.cases[0]);
  const FieldLayout layout{2, 1, 2};
  const std::vector<double> resonant{1, 2, 3};
  for (std::size_t mode = 0; mode < 2; ++mode) {
    const Field oscillating = split_forcing(forcing(layout), mode, layout, lattice).oscillating;
    for (const auto& [key, ignored] : oscillating.terms()) {
      double frequency = 0;
      for (std::size_t i = 0; i < 3; ++i) frequency += key[i] * resonant[i];
      EXPECT_NE(std::abs(frequency), resonant[mode]);
    }
  }
}

TEST(InverseSums, AreInversesOnceWrittenOut) {
  const GiNaC::realsymbol a("a"), b("b");
  InverseSums inverses;
  const std::vector<GiNaC::ex> frequencies{a + b, 2 * a + 4 * b, a - b, 3 * a, b, GiNaC::ex(5)};
  for (const GiNaC::ex& frequency : frequencies) {
    Field field;
    field.add({0}, inverses.inverse(frequency));
    const Field written = inverses.written_out(field);
    EXPECT_TRUE((written.terms().at({0}) * frequency - 1).normal().is_zero()) << frequency;
  }
}

TEST(InverseSums, ZeroesBehindDenominatorsAreFoundAndNothingElse) {
  const GiNaC::realsymbol a("a"), b("b");
  InverseSums inverses;
  const GiNaC::ex sum = inverses.inverse(a + b), difference = inverses.inverse(a - b);
  // 1/(a-b) - 1/(a+b) = 2b/(a^2-b^2)
  const GiNaC::ex zero = difference - sum - 2 * b * sum * difference;
  EXPECT_TRUE(inverses.cleaned(zero).is_zero());
  EXPECT_FALSE(inverses.cleaned(zero + sum / 1000).is_zero());
  Field field;
  field.add({1}, zero);
  field.add({2}, sum);
  EXPECT_EQ(inverses.cleaned(field).terms().size(), 1U);
}

}  // namespace
}  // namespace secular
