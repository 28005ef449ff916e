// Slopes of what harmonic balance leaves, against differences.
#include "motion/balance/balance_sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <ostream>

#include "estimator/model/by_name.hpp"
#include "generated/registry.hpp"

namespace secular {

// For the tests' names: a law's function has another address in every run.
inline void PrintTo(const ForceLaw& law, std::ostream* out) {
  *out << "law of kind " << static_cast<int>(law.kind);
}

namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;

// One mode with quadratic inertia, so that a force's share of the acceleration depends on the displacement, driven
// by a force that a law of the motion supplies in place of the excitation.
class SweepWithForce : public testing::TestWithParam<ForceLaw> {
 protected:
  std::size_t symbol(const std::string& name) const { return symbol_named(model, name); }

  StateForce force() const {
    StateForce force;
    force.law = GetParam();
    force.strength_symbol = symbol("eta1");
    force.shape_symbol = symbol("mu3");
    force.scale = force.law.of_velocity ? 0.1 : 1e-3;
    return force;
  }

  MotionSetting setting() const {
    MotionSetting setting;
    setting.torus = std::make_shared<const Torus>(1, 5, 128);
    setting.rate = {Complex(0, 80), Complex(0)};
    setting.excitation = MatrixXcd::Zero(static_cast<Index>(model.excitations.size()), setting.torus->lines());
    setting.masters = {{0, 1}};
    return setting;
  }

  std::vector<double> parameters(double strength) const {
    std::vector<double> values(model.symbols.size(), 0.0);
    values[symbol("omega0")] = 79;
    values[symbol("mu1")] = 0.4;
    values[symbol("alpha3")] = 1e6;
    values[symbol("delta2")] = 60;
    values[symbol("eta1")] = strength;
    values[symbol("mu3")] = GetParam().has_memory() ? 4e-4 : 1.7;  // slip displacement, exponent
    return values;
  }

  MatrixXcd lines() const {
    MatrixXcd lines = MatrixXcd::Zero(1, 6);
    lines.row(0) << 1e-5, Complex(5e-4, 2e-4), Complex(2e-5, 3e-5), Complex(-1e-5, 2e-5), 0, Complex(0, 3e-6);
    return lines;
  }

  const CompiledModel& model = *generated::find_compiled_model("two_mass_mode1");
};

TEST_P(SweepWithForce, LinesMoveTheResidualAsDifferencesSay) {
  const MotionSetting setting = this->setting();
  const std::vector<double> parameters = this->parameters(600);
  BalanceSweep sweep(model, {force()}, setting);
  const std::vector<SlavedLine> slaves = slaved_lines(setting, model, parameters);
  ASSERT_EQ(slaves.size(), 5u);
  const double step = 1e-10;
  const MatrixXcd slopes = sweep.residual_slopes(sweep.path(lines()), parameters, slaves, step);
  ASSERT_EQ(slopes.cols(), 9);
  for (Index e = 0; e < slopes.cols(); ++e) {
    const MatrixXcd up = sweep.residual(sweep.path(with_step(slaves, lines(), e, step)), parameters),
                    down = sweep.residual(sweep.path(with_step(slaves, lines(), e, -step)), parameters);
    const MatrixXcd difference = ((up - down) / (2 * step)).reshaped();
    EXPECT_LT((slopes.col(e) - difference).norm(), 1e-4 * difference.norm()) << "entry " << e;
  }
}

// Where the force is switched off its strength has a slope all the same.
TEST_P(SweepWithForce, ParametersMoveTheResidualAsDifferencesSay) {
  const MotionSetting setting = this->setting();
  for (const double strength : {600.0, 0.0}) {
    const std::vector<double> parameters = this->parameters(strength);
    BalanceSweep sweep(model, {force()}, setting);
    const BalanceSweep::Path path = sweep.path(lines());
    std::vector<std::size_t> symbols;  // a force has one strength: the model's other factor of F is none
    for (std::size_t s = 0; s < parameters.size(); ++s)
      if (s != force().shape_symbol && s != symbol("eta2")) symbols.push_back(s);
    const std::vector<MatrixXcd> slopes = sweep.parameter_slopes(path, parameters, symbols);
    ASSERT_EQ(slopes.size(), symbols.size());
    for (std::size_t i = 0; i < symbols.size(); ++i) {
      std::vector<double> moved = parameters;
      const double step = parameters[symbols[i]] != 0 ? 1e-4 * parameters[symbols[i]] : 1e-2;
      moved[symbols[i]] += step;
      const MatrixXcd up = sweep.residual(path, moved);
      moved[symbols[i]] -= 2 * step;
      const MatrixXcd difference = (up - sweep.residual(path, moved)) / (2 * step);
      EXPECT_LT((slopes[i] - difference).norm(), 1e-6 * difference.norm() + 1e-12)
          << model.symbols[symbols[i]].name << ", strength " << strength;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, SweepWithForce,
                         testing::Values(force_law::slider, force_law::spread_slider, force_law::smooth_slider,
                                         force_law::velocity_power, force_law::displacement_power,
                                         force_law::relaxation));

}  // namespace
}  // namespace secular
