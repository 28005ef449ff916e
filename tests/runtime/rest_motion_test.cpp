// Models about their rest position: equations of motion and lumps, compiled, interpreted and by hand.
#include <gtest/gtest.h>

#include <algorithm>
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

// The load g and the stiffnesses k and l follow from the rest position of x and the natural frequencies. y rests at
// zero, and stiffens with x.
constexpr const char* resting_text = R"toml(schema = 1
name = "resting"
reference = "rest"
[[mode]]
coordinate = "x"
frequency = "w1"
equation = """(1 + m*x)*D2(x) + k*sin(d*x) + h*(exp(b*x^2) - 1) + r*sqrt(2 + x) + s*tanh(x) + q/(3 - x)^2
  + z*log(1 + x) = g + e*F*cos(Omega*t) - v*x*D(x)"""
[[mode]]
coordinate = "y"
frequency = "w2"
equation = "D2(y) + l*y + c*y*x^2 = 0"
[[case]]
name = "free"
excitation = false
expand_to = 1
order = { v = 1 }
modes_at_rest = ["y"]
)toml";

template <class Scalar>
std::vector<Scalar> accelerations_by_hand(const CompiledModel& model, const std::vector<Scalar>& a, double force,
                                          const std::vector<Scalar>& displacement, const std::vector<Scalar>& u) {
  const auto p = [&](std::string_view name) {
    return a[static_cast<std::size_t>(
        std::find_if(model.symbols.begin(), model.symbols.end(), [&](const auto& s) { return s.name == name; }) -
        model.symbols.begin())];
  };
  const Scalar d = p("d"), h = p("h"), b = p("b"), r = p("r"), s = p("s"), q = p("q"), z = p("z"), m = p("m"),
               c = p("c"), rest = p("x_rest"), w1 = p("w1"), w2 = p("w2");
  const auto others = [&](const Scalar& x) {
    return h * (exp(b * x * x) - 1.0) + r * sqrt(2.0 + x) + s * tanh(x) + q / ((3.0 - x) * (3.0 - x)) +
           z * log(1.0 + x);
  };
  const Scalar cosh_rest = cosh(rest), far = 3.0 - rest;
  const Scalar slope = 2.0 * h * b * rest * exp(b * rest * rest) + r / (2.0 * sqrt(2.0 + rest)) +
                       s / (cosh_rest * cosh_rest) + 2.0 * q / (far * far * far) + z / (1.0 + rest);
  const Scalar k = (w1 * w1 * (1.0 + m * rest) - slope) / (d * cos(d * rest));
  const Scalar g = k * sin(d * rest) + others(rest);
  const Scalar x = rest + displacement[0], y = displacement[1];
  return {(g + p("e") * force - p("v") * x * u[0] - k * sin(d * x) - others(x)) / (1.0 + m * x),
          -(w2 * w2 - c * rest * rest) * y - c * y * x * x};
}

class RestingMotion : public TemporaryFolder {
 protected:
  std::shared_ptr<const CompiledModel> loaded(bool interpret) const {
    RuntimeModelOptions options;
    options.cases = {"free"};
    options.header_folders = {testing_support::source_folder()};
    options.cache_folder = folder_ / "cache";
    options.interpret = interpret;
    RuntimeModel model = load_runtime_model(write("resting.toml", resting_text), options);
    EXPECT_EQ(model.origin, interpret ? RuntimeModel::Origin::interpreted : RuntimeModel::Origin::compiled)
        << (model.notes.empty() ? "" : model.notes.front());
    return model.model;
  }
};

// Accelerations, their slopes by the complex step, and those of lumps by differences.
void expect_stated_law(const CompiledModel& model) {
  using Complex = std::complex<double>;
  std::mt19937_64 random(8);
  constexpr double h = 1e-30;
  for (int draw = 0; draw < 5; ++draw) {
    const test::Point point = test::random_point(model, random);
    const auto outputs = test::outputs(model, point);
    const double force = point.excitation[0].value;
    const auto expected = accelerations_by_hand(model, point.parameters, force, point.displacement, point.velocity);
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_NEAR(outputs[0][k], expected[k], 1e-11 * (1 + std::abs(expected[k])));
    std::vector<Complex> a(point.parameters.begin(), point.parameters.end()),
        q(point.displacement.begin(), point.displacement.end()), v(point.velocity.begin(), point.velocity.end());
    const auto expect_slopes = [&](Complex& variable, std::size_t column, std::size_t columns, std::size_t output) {
      variable += Complex(0, h);
      const std::vector<Complex> moved = accelerations_by_hand(model, a, force, q, v);
      variable = variable.real();
      for (std::size_t k = 0; k < 2; ++k)
        EXPECT_NEAR(outputs[output][k * columns + column], moved[k].imag() / h,
                    1e-10 * (1 + std::abs(moved[k].imag() / h)))
            << "output " << output << " equation " << k << " column " << column;
    };
    for (std::size_t k = 0; k < 2; ++k) expect_slopes(q[k], k, 4, 2);
    for (std::size_t p = 0; p < a.size(); ++p) expect_slopes(a[p], p, a.size(), 3);
    const CompiledCase& c = model.cases[0];
    std::vector<double> jacobian(c.lumps.size() * a.size()), high(c.lumps.size()), low(c.lumps.size());
    c.evaluate_lumps_jacobian(point.parameters.data(), jacobian.data());
    for (std::size_t p = 0; p < a.size(); ++p) {
      std::vector<double> moved = point.parameters;
      constexpr double step = 1e-6;
      moved[p] += step;
      c.evaluate_lumps(moved.data(), high.data());
      moved[p] -= 2 * step;
      c.evaluate_lumps(moved.data(), low.data());
      for (std::size_t l = 0; l < c.lumps.size(); ++l)
        EXPECT_NEAR(jacobian[l * a.size() + p], (high[l] - low[l]) / (2 * step),
                    1e-6 * (1 + std::abs(high[l]) + std::abs(jacobian[l * a.size() + p])))
            << c.lumps[l].name << " by " << model.symbols[p].name;
    }
  }
}

TEST_F(RestingMotion, CodeAndInterpretationComputeTheStatedLaw) {
  const auto compiled = loaded(false), interpreted = loaded(true);
  expect_stated_law(*compiled);
  expect_stated_law(*interpreted);
  EXPECT_LT(test::largest_difference(*compiled, *interpreted, 3), 1e-12);
  test::expect_lanes_of_each(*compiled, test::points_of_lanes(*compiled, 7));
}

TEST(RestingModels, AreTheSameAfterACache) {
  const CanonicalModel model = canonical_model(read_model_text(resting_text, "resting.toml"));
  EXPECT_FALSE(model.rest_values.empty());
  const auto again = canonical_from_json(canonical_json(model));
  ASSERT_TRUE(again.has_value());
  EXPECT_EQ(canonical_json(*again), canonical_json(model));
  EXPECT_EQ(test::largest_difference(*interpreted_model(model), *interpreted_model(*again), 2), 0);
}

// Columns hold frequencies alone: what a coefficient has of values at rest is the lump's.
TEST(RestingModels, LumpsHoldTheValuesAtRest) {
  const Model pendulum = read_model_text(
      "schema = 1\nname = \"m\"\nreference = \"rest\"\n[[mode]]\ncoordinate = \"x\"\nfrequency = \"w\"\n"
      "equation = \"D2(x) + k*sin(x) = g\"\n[[case]]\nname = \"c\"\nexcitation = false\nexpand_to = 2\n",
      "m");
  const auto model = interpreted_model(canonical_model(pendulum));
  // -w*(1/4 + 5/12*tan(x_rest)^2)*|A|^2 at x_rest = 1/2 and w = 2
  const double parameters[] = {2, 0.5}, tangent = std::tan(0.5);
  const std::complex<double> amplitude(0.1, 0);
  std::complex<double> rate;
  model->cases[0].modulation(parameters, nullptr, &amplitude, nullptr, &rate);
  EXPECT_NEAR(rate.imag(), -2 * (0.25 + 5.0 / 12 * tangent * tangent) * 1e-3, 1e-15);
}

}  // namespace
}  // namespace secular
