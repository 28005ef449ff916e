#include "perturb/motion_series.hpp"

#include <numbers>

#include "field_value.hpp"
#include "perturb/nonsmooth.hpp"
#include "textbook_models.hpp"

namespace secular {
namespace {

using namespace testing_fields;

struct Oscillator {
  Model model = read_model_text(
      textbook::one_mode("D2(x) + w^2*x = g*x^3 + e*F*cos(Omega*t)", "order = { g = 1, e = 1 }"), "m");
  ResonanceLattice lattice{model, model.cases[0]};
  PhaseRates rates = phase_rates(model, model.cases[0], lattice, true);
  FieldLayout layout = rates.layout;

  // x = A exp(i w t) + conj, nothing at higher orders.
  MotionSeries moving() const {
    FieldSeries position(3);
    for (const int sign : {1, -1}) {
      FieldKey key(layout.size(), 0);
      key[0] = sign;
      key[sign > 0 ? layout.amplitude(0) : layout.conjugate(0)] = 1;
      position[0].add(key, 1);
    }
    MotionSeries series(rates, 2, {false});
    for (int order = 0; order <= 2; ++order) series.update({position}, {FieldSeries(3)}, order);
    return series;
  }
};

TEST(MotionSeries, FactorsAreWhatTheySay) {
  const Oscillator o;
  const MotionSeries series = o.moving();
  std::mt19937 random(8);
  Point at = random_point(o.layout, random);
  const double w = 1.7, drive = 2.3;
  at.symbols = {{o.model.symbols.at("w"), w}, {o.model.symbols.at("Omega"), drive}};
  const Complex turned = at.amplitudes[0] * std::polar(1.0, at.phases[0]);
  const double x = 2 * turned.real(), velocity = -2 * w * turned.imag(), excitation_phase = at.phases[1];
  const auto factor = [](Factor::Kind kind, int derivative, int multiple = 1) {
    return Factor{kind, 0, derivative, multiple};
  };
  const auto expect_product = [&](const FactorProduct& factors, double expected) {
    expect_near(value(series.product(factors, 0), o.layout, at), expected, 1e-12);
    EXPECT_TRUE(series.product(factors, 1).empty());
  };
  expect_product({}, 1);
  expect_product({{factor(Factor::Kind::coordinate, 0), 3}}, x * x * x);
  expect_product({{factor(Factor::Kind::coordinate, 1), 2}, {factor(Factor::Kind::coordinate, 2), 1}},
                 -w * w * x * velocity * velocity);
  expect_product({{factor(Factor::Kind::excitation, 0), 1}, {factor(Factor::Kind::coordinate, 0), 1}},
                 at.forces[0] * std::cos(excitation_phase) * x);
  expect_product({{factor(Factor::Kind::excitation, 1), 1}}, -drive * at.forces[0] * std::sin(excitation_phase));
  expect_product({{factor(Factor::Kind::clock_sin, 0, 2), 1}}, std::sin(2 * excitation_phase));
  expect_product({{factor(Factor::Kind::clock_cos, 0, 3), 2}}, std::pow(std::cos(3 * excitation_phase), 2));
}

TEST(MotionSeries, HarmonicsOfANonsmoothProductAreItsFourierIntegrals) {
  const Oscillator o;
  const MotionSeries series = o.moving();
  const double w = 1.3;
  // x' |x'|, quadratic damping.
  const Field product =
      series.product({{Factor{Factor::Kind::absolute, 0, 1}, 1}, {Factor{Factor::Kind::coordinate, 0, 1}, 1}}, 0);
  Point at{{{o.model.symbols.at("w"), w}}, {0, 0}, {std::polar(0.8, 0.6)}, {1}};
  const int samples = 20000;
  for (int harmonic = 0; harmonic <= highest_nonsmooth_harmonic; ++harmonic) {
    Complex integral = 0;
    for (int s = 0; s < samples; ++s) {
      const double phase = 2 * std::numbers::pi * s / samples;
      const double velocity = -2 * w * (at.amplitudes[0] * std::polar(1.0, phase)).imag();
      integral += velocity * std::abs(velocity) * std::polar(1.0, -harmonic * phase) / double(samples);
    }
    Field of_harmonic;
    for (const auto& [key, coefficient] : product.terms())
      if (key[0] == harmonic) of_harmonic.add(key, coefficient);
    expect_near(value(of_harmonic, o.layout, at), integral, 1e-7);
  }
}

TEST(MotionSeries, NonsmoothFunctionsOfAModeAtRestAreLeftOut) {
  const Oscillator o;
  MotionSeries series(o.rates, 2, {true});
  EXPECT_TRUE(series.product({{Factor{Factor::Kind::absolute, 0, 0}, 1}}, 0).empty());
}

}  // namespace
}  // namespace secular
