// The typeset equations as numbers: what is printed equals what was derived.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <filesystem>
#include <string>

#include "codegen/document/typeset_equations.hpp"
#include "formula_values.hpp"
#include "perturb/model.hpp"
#include "tests/places.hpp"

namespace secular {
namespace {

void expect_near(Complex typeset, Complex derived, const std::string& where) {
  EXPECT_LT(std::abs(typeset - derived), 1e-9 * (1 + std::abs(derived)))
      << where << ": " << typeset << " " << derived;
}

void check_case(const CanonicalModel& model, const CanonicalCase& c) {
  const Values moving = random_values(model, c, 0.7), start = random_values(model, c, 0);
  for (std::size_t k = 0; k < model.coordinates.size(); ++k) {
    const std::string where = model.name + ", " + c.name + ", " + model.coordinates[k];
    const auto rate = [&](const Values& values) {
      Complex sum = 0;
      for (const CanonicalTerm& term : c.slow_derivative[k]) sum += value_of(model, c, term, values);
      return sum;
    };
    const auto right = [&](const typeset::Equation& equation, const Values& values) {
      return values.of(equation.right);
    };
    expect_near(right(typeset::complex_modulation(model, c, k), moving), rate(moving), where + ", complex");
    const Complex turned = 2.0 * rate(moving) * std::polar(1.0, -moving["beta_" + model.coordinates[k]].real());
    const auto [amplitude_rate, phase_rate] = typeset::polar_modulation(model, c, k);
    expect_near(right(amplitude_rate, moving), turned.real(), where + ", amplitude");
    expect_near(right(phase_rate, moving), turned.imag(), where + ", phase");
    for (const CanonicalTerm& term : c.harmonics[k])
      expect_near(moving.of(typeset::harmonic_coefficient(model, term)), value_of(model, c, term, moving),
                  where + ", harmonic");
    if (c.observed_frequency.empty()) continue;
    const Complex amplitude = start["A_" + model.coordinates[k]];
    const double offset =
        (right(typeset::observed_frequency(model, c, k), start) - start[model.natural_frequencies[k]]).real();
    const Complex in_frame = 2.0 * (rate(start) - Complex(0, offset) * amplitude);
    expect_near(right(typeset::frame_amplitude(model, c, k), start), amplitude, where + ", frame");
    expect_near(right(typeset::cartesian_amplitude(model, k), start), amplitude, where + ", x + i y");
    const auto [x_rate, y_rate] = typeset::cartesian_modulation(model, c, k);
    expect_near(right(x_rate, start), in_frame.real(), where + ", x");
    expect_near(right(y_rate, start), in_frame.imag(), where + ", y");
    for (const CanonicalBlock& block : c.blocks)
      if (block.modulation && block.mode == k)
        expect_near(right(typeset::block_equation(model, c, block), start), rate(start), where + ", lumps");
  }
  for (std::size_t i = 0; i < c.lumps.size(); ++i)
    expect_near(start.of(typeset::lump_definition(model, c, i).right),
                value_of(c.lumps[i].definition, model.order, start), c.lumps[i].name);
}

class TypesetValues : public testing::TestWithParam<std::string> {};

TEST_P(TypesetValues, AreThoseOfTheDerivation) {
  const CanonicalModel model =
      canonical_model(read_model(testing_support::source_folder() / "models" / (GetParam() + ".toml")));
  ASSERT_FALSE(model.cases.empty());
  for (const CanonicalCase& c : model.cases) check_case(model, c);
}

INSTANTIATE_TEST_SUITE_P(Models, TypesetValues, testing::Values("pendulum", "two_mass_mode1"),
                         [](const auto& instance) { return instance.param; });

TEST(TypesetValues, AreThoseOfTheDerivationForCoupledModes) {
  const CanonicalModel model = canonical_model(read_model_text(R"toml(schema = 1
name = "coupled"
[[mode]]
coordinate = "x"
frequency = "w"
equation = "D2(x) + w^2*x = -2*m*D(x) + d*x*z - p*abs(D(x))*D(x)"
[[mode]]
coordinate = "z"
frequency = "u"
equation = "D2(z) + u^2*z = -2*n*D(z) + h*x^2 + q*z^3 + g*F*cos(Omega*t)"
[[case]]
name = "internal"
relations = ["u = 2*w + eps*s", "Omega = u + 3*eps*r/2"]
order = { m = 1, n = 1, d = 1, h = 1, p = 1, q = 1, g = 1 }
expand_to = 1
)toml",
                                                               "coupled"));
  ASSERT_EQ(model.cases.size(), 1u);
  check_case(model, model.cases[0]);
  EXPECT_TRUE(typeset::steady_equations(model, model.cases[0]).empty());
}

// Left = right at an amplitude and an excitation frequency at which B does not move.
TEST(TypesetValues, FrequencyResponseHoldsWhereTheAmplitudeStandsStill) {
  const CanonicalModel model = canonical_model(
      read_model(testing_support::source_folder() / "models/two_mass_mode1.toml"), "principal_parametric");
  const CanonicalCase& c = model.cases[0];
  Values values = random_values(model, c, 0);
  const auto polar = typeset::polar_modulation(model, c, 0);
  const typeset::Equation response = typeset::steady_equations(model, c).at(0);
  // The phase from da/dt = 0, the forcing large enough that there is one; then Omega from the phase equation.
  values.set("F", 40.0);
  double low = -1, high = 1;  // of the angle 2*beta around the zero of da/dt
  const auto amplitude_rate = [&](double angle) {
    values.set("beta_v", angle / 2);
    return values.of(polar.first.right).real();
  };
  ASSERT_LT(amplitude_rate(low) * amplitude_rate(high), 0);
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (amplitude_rate(low) * amplitude_rate(middle) <= 0 ? high : low) = middle;
  }
  const double turning = (values.of(polar.second.right) / values["a_v"]).real();  // dbeta/dt = Omega/2 - omega0
  values.set("Omega", 2.0 * (values["omega0"] + turning));
  expect_near(values.of(response.left), values.of(response.right), "frequency response");
}

}  // namespace
}  // namespace secular
