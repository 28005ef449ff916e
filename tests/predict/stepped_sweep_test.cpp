#include "motion/simulate/stepped_sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "generated/registry.hpp"
#include "motion/response/response_curve.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Principal parametric resonance at twice 2 Hz with weak cubic terms, so that the expansion is accurate to far less
// than a step of the sweep.
TEST(SlowSteppedSweep, JumpsWithinAStepOfThePrediction) {
  const CompiledModel& model = *generated::find_compiled_model("two_mass_mode1");
  const CompiledCase& resonance = model.cases[0];
  ASSERT_EQ(resonance.name, "principal_parametric");
  const auto names = ResponseField::parameter_names(model);
  VectorXd p = VectorXd::Zero(static_cast<Index>(names.size()));
  const auto set = [&](std::string_view name, double value) {
    const auto found = std::find(names.begin(), names.end(), name);
    ASSERT_NE(found, names.end());
    p(found - names.begin()) = value;
  };
  const double omega0 = 4 * std::numbers::pi;
  set("omega0", omega0);
  set("mu1", 0.02);
  set("mu3", 5.0);
  set("alpha3", -2e4);
  set("eta2", 2);
  set("F", 1);
  set("Omega", 2 * omega0);
  const ResponseField field(model, resonance);
  ResponseRequest request;
  request.parameters = p;
  request.parameter = static_cast<Index>(model.symbols.size());
  request.lower = 2 * omega0 - 0.2;
  request.upper = 2 * omega0 + 0.1;
  const ResponseDiagram diagram = response_diagram(field, request);
  double fold = 0, lower_threshold = 1e9;
  for (const ResponseBranch& branch : diagram.branches)
    for (const ResponseSpecial& special : branch.special)
      if (special.kind == SpecialKind::saddle_node)
        fold = special.at.parameter;
      else if (special.at.at_rest)
        lower_threshold = std::min(lower_threshold, special.at.parameter);
  ASSERT_GT(fold, request.lower);
  ASSERT_LT(fold, lower_threshold);

  // Where a sweep over neighbouring frequencies jumps.
  const double step = 0.005;
  const auto jump = [&](double from, double to) {
    SteppedSweep sweep;
    sweep.parameters = p;
    sweep.disturbance = 1e-3 * diagram.scale;
    sweep.window_limit = 120;
    std::vector<double> frequencies;
    const int count = static_cast<int>(std::lround(std::abs(to - from) / step)) + 1;
    for (int i = 0; i < count; ++i) {
      frequencies.push_back(from + (to - from) * i / (count - 1));
      sweep.steps.push_back({{frequencies.back()}, {1.0}});
    }
    const std::vector<SweepPoint> points = stepped_sweep(model, resonance, sweep);
    std::size_t at = 0;
    double largest = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double change = std::abs(points[i].amplitude[0] - points[i - 1].amplitude[0]);
      if (change > largest) {
        largest = change;
        at = i;
      }
    }
    return std::pair(frequencies[at - 1], frequencies[at]);
  };
  const auto [before_up, after_up] = jump(lower_threshold - 5.5 * step, lower_threshold + 4.5 * step);
  EXPECT_NEAR(0.5 * (before_up + after_up), lower_threshold, step);
  // The down sweep begins on the upper branch, at a frequency where rest is unstable.
  const auto [before_down, after_down] = jump(lower_threshold + 2 * step, fold - 3.5 * step);
  EXPECT_NEAR(0.5 * (before_down + after_down), fold, step);
}

}  // namespace
}  // namespace secular
