// Slopes of the balance with the lines of the motion.
#include "motion/balance/balance_sweep.hpp"

#include <gtest/gtest.h>

#include "generated/registry.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;

// Two modes on two base phases, every line in motion, masses that depend on the displacement.
TEST(BalanceSweep, SlopesAreThoseOfTheResidual) {
  const CompiledModel& model = *generated::find_compiled_model("two_mass_lumps");
  std::vector<double> parameters(model.symbols.size(), 0.3);
  for (std::size_t s = 0; s < parameters.size(); ++s) parameters[s] += 0.1 * static_cast<double>(s);
  parameters[0] = 1.0;
  parameters[1] = 2.7;
  MotionSetting setting;
  setting.torus = std::make_shared<const Torus>(2, 3, 16);
  setting.rate = {Complex(0, 1.01), Complex(0, 2.69)};
  setting.excitation = MatrixXcd::Zero(static_cast<Index>(model.excitations.size()), setting.torus->lines());
  setting.excitation(0, *setting.torus->find({1, 1})) = 0.2;
  setting.masters = {{0, *setting.torus->find({1, 0})}, {1, *setting.torus->find({0, 1})}};
  MatrixXcd displacement = 0.02 * MatrixXcd::Random(2, setting.torus->lines());
  displacement.col(0).imag().setZero();
  BalanceSweep sweep(model, {}, setting);
  const std::vector<SlavedLine> slaves = slaved_lines(setting, model, parameters);
  ASSERT_GT(slaves.size(), 20U);
  const BalanceSweep::Path path = sweep.path(displacement);
  const MatrixXcd slopes = sweep.residual_slopes(path, parameters, slaves, 1e-5);
  ASSERT_EQ(slopes.cols(), gathered(slaves, displacement).size());
  const double step = 1e-5;
  for (Index s = 0; s < slopes.cols(); ++s) {
    const auto residual = [&](double by) {
      return MatrixXcd(sweep.residual(sweep.path(with_step(slaves, displacement, s, by)), parameters));
    };
    const MatrixXcd difference = (residual(step) - residual(-step)) / (2 * step);
    EXPECT_LT((slopes.col(s) - difference.reshaped()).norm(), 1e-6 * difference.norm()) << "entry " << s;
  }
}

}  // namespace
}  // namespace secular
