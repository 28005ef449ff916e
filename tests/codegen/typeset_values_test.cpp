// The typeset equations as numbers: what is printed equals what was derived.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <filesystem>
#include <map>
#include <random>
#include <stdexcept>
#include <string>

#include "codegen/latex_math.hpp"
#include "codegen/typeset_equations.hpp"
#include "perturb/model.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Formula = typeset::Expression;
using Kind = Formula::Kind;

/// Values of symbols by how they are typeset.
class Values {
 public:
  void set(const Formula& symbol, Complex value) { values_[typeset::latex_math(symbol)] = value; }
  void set(const std::string& identifier, Complex value) { set(typeset::symbol(identifier), value); }
  Complex operator[](const std::string& identifier) const { return of(typeset::symbol(identifier)); }

  Complex of(const Formula& formula) const {
    const auto part = [&](std::size_t i) { return of(formula.parts[i]); };
    switch (formula.kind) {
      case Kind::number:
        return std::stod(formula.text);
      case Kind::symbol:
      case Kind::indexed:
        return values_.at(typeset::latex_math(formula));
      case Kind::constant:
        if (formula.text == "i") return {0, 1};
        break;
      case Kind::accent:
        if (formula.text == "bar") return std::conj(part(0));
        break;
      case Kind::product: {
        Complex product = 1;
        for (const Formula& factor : formula.parts) product *= of(factor);
        return product;
      }
      case Kind::sum: {
        Complex sum = 0;
        for (std::size_t i = 0; i < formula.parts.size(); ++i) sum += formula.negative[i] ? -part(i) : part(i);
        return sum;
      }
      case Kind::fraction:
        return part(0) / part(1);
      case Kind::power:
        return std::pow(part(0), formula.exponent);
      case Kind::bracket:
        return part(0);
      case Kind::modulus:
        return std::abs(part(0));
      case Kind::root:
        return std::sqrt(part(0));
      case Kind::function:
        return formula.text == "cos" ? std::cos(part(0)) : std::sin(part(0));
      case Kind::exponential:
        return std::exp(part(0));
      case Kind::words:
      case Kind::mean:
        break;
    }
    throw std::invalid_argument("no value: " + typeset::latex_math(formula));
  }

 private:
  std::map<std::string, Complex> values_;
};

double value_of(const RationalFunction& f, const SymbolOrder& order, const Values& values) {
  const auto polynomial = [&](const std::vector<PolynomialTerm>& terms) {
    double sum = 0;
    for (const PolynomialTerm& term : terms) {
      double product = std::stod(term.coefficient);
      for (std::size_t i = 0; i < order.size(); ++i)
        product *= std::pow(values[order[i]].real(), term.exponents[i]);
      sum += product;
    }
    return sum;
  };
  return polynomial(f.numerator) / polynomial(f.denominator);
}

Complex value_of(const CanonicalModel& model, const CanonicalCase& c, const CanonicalTerm& term,
                 const Values& values) {
  const CanonicalPowers& p = term.powers;
  Complex value{value_of(term.real, model.order, values), value_of(term.imaginary, model.order, values)};
  for (std::size_t k = 0; k < model.coordinates.size(); ++k) {
    const Complex a = values["A_" + model.coordinates[k]];
    value *=
        std::pow(a, p.amplitude[k]) * std::pow(std::conj(a), p.conjugate[k]) * std::pow(std::abs(a), p.modulus[k]);
  }
  for (std::size_t j = 0; j < model.excitations.size(); ++j)
    value *= std::pow(values[model.excitations[j]], p.forcing[j]);
  for (std::size_t r = 0; r < c.relations.size(); ++r) {
    const CanonicalRelation& relation = c.relations[r];
    if (relation.detuning.empty()) continue;
    const double rate = values[relation.detuning].real() * relation.coefficient.numerator /
                        static_cast<double>(relation.coefficient.denominator);
    value *= std::exp(Complex(0, p.slow_phase[r] * rate) * values["t"]);
  }
  return value;
}

void expect_near(Complex typeset, Complex derived, const std::string& where) {
  EXPECT_LT(std::abs(typeset - derived), 1e-9 * (1 + std::abs(derived)))
      << where << ": " << typeset << " " << derived;
}

// Random values for everything in the model; amplitudes in all their forms.
Values random_values(const CanonicalModel& model, const CanonicalCase& c, double t) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> draw(0.3, 1.7);
  Values values;
  for (const std::string& name : model.order) values.set(name, draw(random));
  for (const std::string& name : model.excitations) values.set(name, draw(random));
  for (const CanonicalRelation& relation : c.relations)
    if (!relation.detuning.empty()) values.set(relation.detuning, draw(random));
  values.set("pi", std::acos(-1.0));
  values.set("t", t);
  for (std::size_t k = 0; k < model.coordinates.size(); ++k) {
    const double a = draw(random), beta = draw(random);
    values.set(typeset::amplitude(model, k), std::polar(a / 2, beta));
    values.set(typeset::named("B", model, k), std::polar(a / 2, beta));  // at time 0
    values.set(typeset::named("a", model, k), a);
    values.set(typeset::named("beta", model, k), beta);
    values.set(typeset::named("x", model, k), a * std::cos(beta));
    values.set(typeset::named("y", model, k), a * std::sin(beta));
  }
  for (std::size_t i = 0; i < c.lumps.size(); ++i)
    values.set(typeset::lump_symbol(model, c, i), value_of(c.lumps[i].definition, model.order, values));
  return values;
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
      canonical_model(read_model(std::filesystem::path(SECULAR_SOURCE_DIR) / "models" / (GetParam() + ".toml")));
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
      read_model(std::filesystem::path(SECULAR_SOURCE_DIR) / "models/two_mass_mode1.toml"), "principal_parametric");
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
