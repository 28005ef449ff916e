// The certificate's functions of true time against numbers.
#include "perturb/true_time_motion.hpp"

#include <algorithm>
#include <filesystem>
#include <numbers>

#include "field_value.hpp"
#include "perturb/fourier_quadrature.hpp"
#include "perturb/solved_frequencies.hpp"
#include "tests/places.hpp"

namespace secular {
namespace {

using testing_fields::Complex;
using testing_fields::expect_near;

TEST(SolvedFrequencies, FulfilAllRelationsOfEveryShippedCase) {
  const ExactArithmetic arithmetic{1};
  int relations = 0;
  for (const auto& entry : std::filesystem::directory_iterator(testing_support::source_folder() / "models")) {
    if (entry.path().extension() != ".toml") continue;
    const Model model = read_model(entry.path());
    for (const ResonanceCase& resonance : model.cases) {
      const auto frequencies = solved_frequencies(model, resonance, arithmetic);
      for (const ResonanceRelation& relation : resonance.relations) {
        ++relations;
        for (std::size_t n = 0; n < frequencies[0].size(); ++n) {
          PrimeFieldComplex left = 0, right = 0;
          for (std::size_t i = 0; i < relation.multiples.size(); ++i)
            left += arithmetic.number(relation.multiples[i]) * frequencies[i][n];
          if (!relation.detuning.empty() && static_cast<int>(n) == relation.order)
            right = arithmetic.number(relation.coefficient) * arithmetic.symbol(relation.detuning);
          EXPECT_EQ(left, right) << model.name << " " << resonance.name << " " << relation.text;
        }
      }
    }
  }
  EXPECT_GT(relations, 15);
}

const std::string true_time_text = R"model(
schema = 1
name = "m"
[[mode]]
coordinate = "x"
frequency = "w1"
equation = "D2(x) + w1^2*x = -2*mu*D(x) + g*x*y - h*x^3"
[[mode]]
coordinate = "y"
frequency = "w2"
equation = "D2(y) + w2^2*y = -2*mu*D(y) + g*x^2 + c*F*cos(Omega*t)"
[[case]]
name = "c"
relations = ["w2 = 2*w1 + eps*sigma1", "Omega = w2 + eps*sigma2"]
order = { g = 1, h = 1, mu = 1, c = 1 }
)model";

using Motion = TrueTimeMotion<FloatingArithmetic>;

struct State {
  std::vector<double> phases;
  std::vector<Complex> amplitudes;
};

Complex value(const Motion::Polynomial& p, const TrueTimeVariables& variables, const State& at, double eps) {
  Complex sum = 0;
  for (std::size_t n = 0; n < p.orders().size(); ++n)
    for (const auto& [waves, coefficient] : at_amplitudes(p.orders()[n], variables, at.amplitudes)) {
      double phase = 0;
      for (std::size_t i = 0; i < waves.size(); ++i) phase += waves[i] * at.phases[i];
      sum += std::pow(eps, static_cast<double>(n)) * coefficient * std::polar(1.0, phase);
    }
  return sum;
}

// Error of the velocity against the difference quotient of the position, while frequencies and amplitudes move as
// the expansion says.
double velocity_error(const Motion& motion, const Model& model, std::size_t mode, double eps) {
  const TrueTimeVariables& variables = motion.variables();
  const State start{{0.3, 1.1, 2.0}, {std::polar(0.7, 0.4), std::polar(0.5, -1.0)}};
  const double step = 1e-5;
  const auto moved = [&](double time) {
    State at = start;
    for (std::size_t i = 0; i < variables.frequencies; ++i) {
      const Motion::Series frequency = motion.symbol(model.frequency_name(i));
      for (std::size_t n = 0; n < frequency.size(); ++n)
        at.phases[i] += time * frequency[n].real() * std::pow(eps, static_cast<double>(n));
    }
    for (std::size_t k = 0; k < variables.modes; ++k) {
      TrueTimePowers amplitude(variables.size(), 0);
      amplitude[variables.amplitude(k)] = 1;
      Motion::Polynomial alone = motion.zero();
      alone.add(0, amplitude, 1);
      at.amplitudes[k] += time * value(motion.time_derivative(alone), variables, start, eps);
    }
    return at;
  };
  const auto position = [&](double time) { return value(motion.of_mode(mode, 0), variables, moved(time), eps); };
  return std::abs((position(step) - position(-step)) / (2 * step) -
                  value(motion.of_mode(mode, 1), variables, start, eps));
}

TEST(TrueTimeMotion, VelocityIsTheDerivativeOfThePositionUpToTheTruncation) {
  const Model model = read_model_text(true_time_text, "m");
  const Derivation derivation = derive(model, model.cases[0]);
  const Motion motion(derivation, FloatingArithmetic{3});
  for (std::size_t mode = 0; mode < 2; ++mode) {
    // Cut off after eps^2: what is missing falls with the third power of eps.
    const double coarse = velocity_error(motion, model, mode, 0.04),
                 fine = velocity_error(motion, model, mode, 0.02);
    EXPECT_GT(coarse, 1e-6);
    EXPECT_GT(coarse / fine, 6);
    EXPECT_LT(coarse / fine, 12);
  }
}

TEST(TrueTimeMotion, FindsTheModeOfAMultipleAndOfNothingElse) {
  const Model model = read_model_text(true_time_text, "m");
  const Derivation derivation = derive(model, model.cases[0]);
  const TrueTimeMotion<ExactArithmetic> motion(derivation, ExactArithmetic{3});
  const auto three = motion.constant(3);
  EXPECT_EQ(motion.mode_of(motion.of_mode(1, 0) * three), 1U);
  EXPECT_EQ(motion.mode_of(motion.of_mode(0, 1) * three), 0U);
  auto sum = motion.of_mode(0, 0);
  sum += motion.of_mode(1, 0);
  EXPECT_EQ(motion.mode_of(sum), std::nullopt);
}

TEST(TrueTimeVariables, NormalFormAndConjugateHaveTheSameValues) {
  const TrueTimeVariables variables{1, 1};
  GradedPolynomial<Complex> p(1);
  p.add(0, {1, 2, 0, 3, 1, 0}, Complex(0.3, 1));
  p.add(0, {-2, 0, 1, -2, 2, 1}, Complex(-1, 0.5));
  p.add(0, {1, 1, 0, 0, 3, 0}, Complex(0.7, 0));
  p.add(1, {0, 1, 1, 1, 0, 0}, Complex(2, 0));
  const State at{{0.9}, {std::polar(0.8, 0.7)}};
  const double eps = 0.5;
  const Complex plain = value(p, variables, at, eps);
  expect_near(value(conjugated<FloatingArithmetic>(p, variables), variables, at, eps), std::conj(plain), 1e-14);
  // The term of degree 2 that came out of a function carries one power of eps more, by degree that of degree 3 two,
  // which is beyond the polynomial's end.
  const Complex moved = plain - (1 - eps) * Complex(-1, 0.5) * std::polar(1.0, -2 * at.phases[0]) *
                                    std::conj(at.amplitudes[0]) / std::norm(at.amplitudes[0]);
  expect_near(value(normal_form(p, variables, false), variables, at, eps), moved, 1e-14);
  const Complex without = moved - 0.7 * std::polar(1.0, at.phases[0]) * at.amplitudes[0];
  expect_near(value(normal_form(p, variables, true), variables, at, eps), without, 1e-14);
}

TEST(FourierQuadrature, GivesTheClosedSeries) {
  // |cos| = 2/pi + (4/pi) sum_m (-1)^(m+1) cos(2 m theta)/(4 m^2 - 1), sgn(cos) = (4/pi) sum_m (-1)^m
  // cos((2m+1) theta)/(2m+1).
  const Complex phasor = std::polar(1.7, 0.8);
  for (int n = -12; n <= 12; ++n) {
    const Complex turned = std::polar(1.0, n * std::arg(phasor));
    const int m = std::abs(n) / 2;
    const double sign = m % 2 == 0 ? 1 : -1;
    const double absolute = n % 2 != 0 ? 0 : -sign * 2 / std::numbers::pi / (4.0 * m * m - 1);
    const double signum = n % 2 == 0 ? 0 : sign * 2 / std::numbers::pi / (2.0 * m + 1);
    expect_near(fourier_by_quadrature(phasor, true, n), std::abs(phasor) * absolute * turned, 1e-13);
    expect_near(fourier_by_quadrature(phasor, false, n), signum * turned, 1e-13);
  }
}

}  // namespace
}  // namespace secular
