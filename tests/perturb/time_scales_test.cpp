// D_0 + eps D_1 + ... against difference quotients along a path on which phases and amplitudes move as stated.
#include "perturb/time_scales.hpp"

#include "field_value.hpp"
#include "perturb/derivation.hpp"

namespace secular {
namespace {

using namespace testing_fields;

// Two modes, an excitation at twice the first frequency, detuned at eps and at eps^2.
const std::string scales_text = R"model(
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
relations = ["w2 = 3*w1 + eps*sigma1", "Omega = 2*w1 + eps^2*sigma2"]
order = { g = 1, h = 1 }
)model";

class TimeScales : public testing::TestWithParam<bool> {};

TEST_P(TimeScales, TimeDerivativeIsThatOfTheNumbers) {
  const Model model = read_model_text(scales_text, "m");
  const ResonanceLattice lattice(model, model.cases[0]);
  const PhaseRates rates = phase_rates(model, model.cases[0], lattice, GetParam());
  const FieldLayout& layout = rates.layout;
  std::mt19937 random(5);
  AmplitudeRates amplitude_rates(2, FieldSeries(3));
  for (FieldSeries& of_mode : amplitude_rates)
    for (std::size_t n : {1U, 2U}) of_mode[n] = random_field(layout, 2, random);
  const FieldSeries series{random_field(layout, 4, random), {}, {}};

  GiNaC::exmap numbers;
  double next = 0.7;
  for (const std::string& name : model.symbols.names()) numbers[model.symbols.at(name)] = next += 0.13;
  const double eps = 0.3, step = 1e-5;
  // The point after a time, with constant rates: its error is of the order of the step.
  const Point start = [&] {
    Point at = random_point(layout, random);
    at.symbols = numbers;
    return at;
  }();
  const auto moved = [&](double time) {
    Point at = start;
    for (std::size_t i = 0; i < at.phases.size(); ++i) {
      FieldKey key(layout.size(), 0);
      key[i] = 1;
      at.phases[i] +=
          time * (value(rates.on_fast_scale(key), numbers) + eps * value(rates.on_slow_scale(key, 1), numbers) +
                  eps * eps * value(rates.on_slow_scale(key, 2), numbers))
                     .real();
    }
    for (std::size_t k = 0; k < 2; ++k)
      at.amplitudes[k] += time * (eps * value(amplitude_rates[k][1], layout, start) +
                                  eps * eps * value(amplitude_rates[k][2], layout, start));
    return at;
  };
  const Complex quotient =
      (value(series[0], layout, moved(step)) - value(series[0], layout, moved(-step))) / (2 * step);
  Complex derivative = 0;
  for (int order = 0; order <= 2; ++order)
    derivative +=
        std::pow(eps, order) * value(time_derivative(series, order, rates, amplitude_rates), layout, start);
  expect_near(derivative, quotient, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(ExcitationFrequency, TimeScales, testing::Bool(),
                         [](const auto& resonant) { return resonant.param ? "resonant" : "kept"; });

TEST(PhaseRates, TrueExcitationFrequencyIsTheSameHoweverItIsWritten) {
  const Model model = read_model_text(scales_text, "m");
  const ResonanceLattice lattice(model, model.cases[0]);
  const PhaseRates rates = phase_rates(model, model.cases[0], lattice, true);
  FieldKey key(rates.layout.size(), 0);
  key[2] = 1;  // Omega = 2 w1 + eps^2 sigma2
  EXPECT_TRUE((rates.on_fast_scale(key) - 2 * model.symbols.at("w1")).is_zero());
  EXPECT_TRUE(rates.on_slow_scale(key, 1).is_zero());
  EXPECT_TRUE((rates.on_slow_scale(key, 2) - model.symbols.at("sigma2")).is_zero());
  EXPECT_TRUE((phase_rates(model, model.cases[0], lattice, false).on_fast_scale(key) - model.symbols.at("Omega"))
                  .is_zero());
}

}  // namespace
}  // namespace secular
