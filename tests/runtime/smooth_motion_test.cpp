// Equations of motion with functions of coordinates: compiled, interpreted and written by hand.
#include <gtest/gtest.h>

#include <complex>
#include <string>
#include <vector>

#include "codegen/canonical/canonical_model.hpp"
#include "codegen/runtime/canonical_json.hpp"
#include "codegen/runtime/interpreted_model.hpp"
#include "codegen/runtime/runtime_model.hpp"
#include "perturb/model.hpp"
#include "tests/campaign/temporary_folder.hpp"
#include "tests/places.hpp"
#include "tests/runtime/compare_lanes.hpp"

namespace secular {
namespace {

// Every function once, of several coordinates, of velocities, of one another and with parameters inside. Symbols
// have names that generated code uses itself.
constexpr const char* smooth_text = R"toml(schema = 1
name = "smooth"
[[mode]]
coordinate = "x"
frequency = "w1"
equation = """exp(b*x)*D2(x) + c*tanh(y)*D2(y) + w1^2*sin(x)
  = -p*x/(1 + q*y^2)^2 - tanh(sin_of*D(x)) - atan(p*x*y + y)*sqrt(1 + q*x^2) + e*F*cos(Omega*t)*cos(x - y/2)"""
[[mode]]
coordinate = "y"
frequency = "w2"
equation = """D2(y) + w2^2*sinh(y) = -p*y*(1 + x^2 + y^2)^(-3/2) - cosh(y)*log(1 + q*x^2) + tan(q*x*y)^3
  - (1 + x^2*function_0)^(1/3)*D(y) - b*sin(exp(x*D(y)) - 1)/(2 - cos(c*D(x))) + e*F*cos(Omega*t)"""
[[case]]
name = "none"
)toml";

// Parameters in the model's order: w1, w2, b, c, p, q, sin_of, e, function_0.
template <class Scalar>
std::vector<Scalar> by_hand(const std::vector<Scalar>& a, double force, const std::vector<Scalar>& q,
                            const std::vector<Scalar>& v) {
  const Scalar w1 = a[0], w2 = a[1], b = a[2], c = a[3], p = a[4], r = a[5], s = a[6], e = a[7], f = a[8];
  const Scalar x = q[0], y = q[1], u = v[0], z = v[1];
  const Scalar first = -w1 * w1 * sin(x) - p * x / pow(1.0 + r * y * y, 2) - tanh(s * u) -
                       atan(p * x * y + y) * sqrt(1.0 + r * x * x) + e * force * cos(x - y / 2.0);
  const Scalar second = -w2 * w2 * sinh(y) - p * y / pow(1.0 + x * x + y * y, 1.5) -
                        cosh(y) * log(1.0 + r * x * x) + pow(tan(r * x * y), 3) -
                        pow(1.0 + x * x * f, 1.0 / 3) * z - b * sin(exp(x * z) - 1.0) / (2.0 - cos(c * u)) +
                        e * force;
  return {(first - c * tanh(y) * second) / exp(b * x), second};
}

using Complex = std::complex<double>;

std::vector<Complex> as_complex(const std::vector<double>& values) {
  return {values.begin(), values.end()};
}

class SmoothMotion : public TemporaryFolder {
 protected:
  RuntimeModel loaded(bool interpret) const {
    RuntimeModelOptions options;
    options.cases = std::vector<std::string>{};
    options.header_folders = {testing_support::source_folder()};
    options.cache_folder = folder_ / "cache";
    options.interpret = interpret;
    return load_runtime_model(write("smooth.toml", smooth_text), options);
  }
};

// Accelerations, and slopes by the complex step: f(x + i h) = f(x) + i h f'(x).
void expect_law(const CompiledModel& model) {
  ASSERT_EQ(model.symbols.back().name, "function_0");
  std::mt19937_64 random(8);
  constexpr double h = 1e-30;
  for (int draw = 0; draw < 10; ++draw) {
    const test::Point point = test::random_point(model, random);
    const auto outputs = test::outputs(model, point);
    const double force = point.excitation[0].value;
    const std::vector<double> expected = by_hand(point.parameters, force, point.displacement, point.velocity);
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_NEAR(outputs[0][k], expected[k], 1e-13 * std::abs(expected[k]) + 1e-14);
    std::vector<Complex> a = as_complex(point.parameters), q = as_complex(point.displacement),
                         v = as_complex(point.velocity);
    const auto expect_slopes = [&](Complex& variable, std::size_t column, std::size_t columns, std::size_t output) {
      variable += Complex(0, h);
      const std::vector<Complex> moved = by_hand(a, force, q, v);
      variable = variable.real();
      for (std::size_t k = 0; k < 2; ++k) {
        const double slope = moved[k].imag() / h;
        EXPECT_NEAR(outputs[output][k * columns + column], slope, 1e-12 * std::abs(slope) + 1e-13)
            << "output " << output << " equation " << k << " column " << column;
      }
    };
    for (std::size_t k = 0; k < 2; ++k) {
      expect_slopes(q[k], k, 4, 2);
      expect_slopes(v[k], 2 + k, 4, 2);
    }
    for (std::size_t p = 0; p < a.size(); ++p) expect_slopes(a[p], p, a.size(), 3);
  }
}

TEST_F(SmoothMotion, CodeComputesTheLawAndItsDerivatives) {
  const RuntimeModel compiled = loaded(false);
  ASSERT_EQ(compiled.origin, RuntimeModel::Origin::compiled);
  expect_law(*compiled.model);
  test::expect_lanes_of_each(*compiled.model, test::points_of_lanes(*compiled.model, 7));
}

TEST_F(SmoothMotion, InterpretationDoesAsWell) {
  const RuntimeModel interpreted = loaded(true);
  ASSERT_EQ(interpreted.origin, RuntimeModel::Origin::interpreted);
  expect_law(*interpreted.model);
}

TEST(SmoothModels, AreTheSameAfterACache) {
  Model read = read_model_text(smooth_text, "smooth.toml");
  read.cases.clear();
  const CanonicalModel model = canonical_model(read);
  const auto again = canonical_from_json(canonical_json(model));
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(canonical_json(*again), canonical_json(model));
  const auto first = interpreted_model(model), second = interpreted_model(*again);
  EXPECT_EQ(test::largest_difference(*first, *second, 5), 0);
}

TEST(SmoothModels, EveryPartOfAFunctionIsInTheFingerprint) {
  const auto fingerprint = [](const std::string& term) {
    return canonical_model(read_model_text("schema = 1\nname = \"m\"\n[[mode]]\ncoordinate = \"x\"\nfrequency = "
                                           "\"w\"\nequation = \"D2(x) + w^2*x = -g*x^2*" +
                                               term +
                                               "\"\n[[case]]\nname = \"c\"\nordering = \"degree\"\nexpand_to = 3\n",
                                           "m"))
        .fingerprint;
  };
  const char* const terms[] = {"sin(x)",      "atan(x)",       "sin(x)^2", "sin(2*x)",
                               "sqrt(1 + x)", "(1 + x)^(1/3)", "x/(1 + x)"};
  for (std::size_t i = 0; i < std::size(terms); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(fingerprint(terms[i]), fingerprint(terms[j])) << i << " " << j;
}

}  // namespace
}  // namespace secular
