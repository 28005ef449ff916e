// Fourier coefficients of what jumps with the sign of a velocity.
#include "motion/balance/velocity_jumps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "estimator/model/by_name.hpp"
#include "generated/registry.hpp"
#include "motion/balance/balance_sweep.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

constexpr double pi = std::numbers::pi;

MatrixXcd lines_of_sign(const Torus& torus, const MatrixXcd& velocity) {
  const MatrixXd samples = torus.samples(velocity);
  const std::vector<Turning> all = turnings(torus, velocity, samples);
  MatrixXd sizes(1, static_cast<Index>(all.size()));
  for (Index j = 0; j < sizes.cols(); ++j) sizes(0, j) = all[static_cast<std::size_t>(j)].slope > 0 ? 2 : -2;
  return lines_with_jumps(torus, samples.array().sign().matrix(), all, sizes);
}

// sgn(cos x) = 4/pi (cos x - cos(3 x)/3 + ...); a line is half of its peak.
TEST(VelocityJumps, SignHasItsFourierCoefficientsWhateverThePoints) {
  for (const Index points : {31, 64, 255})
    for (const double phase : {0.0, 0.3, 1.234, -2.9}) {
      const Torus torus(1, 12, points);
      MatrixXcd velocity = MatrixXcd::Zero(1, 13);
      velocity(0, 1) = std::polar(0.7, phase);
      const MatrixXcd lines = lines_of_sign(torus, velocity);
      for (int n = 0; n <= 12; ++n) {
        const Complex exact = n % 2 == 0 ? 0 : std::polar(2 / (pi * n) * (n % 4 == 1 ? 1 : -1), n * phase);
        EXPECT_LT(std::abs(lines(0, n) - exact), 1e-13) << points << " points, phase " << phase << ", line " << n;
      }
    }
}

// sgn(cos x + b) is positive over 2 acos(-b): its mean says so, and line n is 2 sin(n acos(-b))/(pi n).
TEST(VelocityJumps, TurnsOfUnequalLength) {
  for (const double b : {0.3, -0.8}) {
    const Torus torus(1, 8, 101);
    MatrixXcd velocity = MatrixXcd::Zero(1, 9);
    velocity(0, 0) = b;
    velocity(0, 1) = 0.5;
    const MatrixXcd lines = lines_of_sign(torus, velocity);
    const double half = std::acos(-b);
    EXPECT_NEAR(lines(0, 0).real(), 2 * half / pi - 1, 1e-13);
    for (int n = 1; n <= 8; ++n)
      EXPECT_LT(std::abs(lines(0, n) - 2 * std::sin(n * half) / (pi * n)), 1e-13) << b << ", line " << n;
  }
}

TEST(VelocityJumps, LinesBeyondTheTorusAddUp) {
  const double base = 93;
  for (const double natural : {40.0, 93.0, 95.5, 186.0})
    for (const double phase : {0.0, 0.4, pi, 5.0}) {
      double sum = 0;
      constexpr int most = 2000000;
      for (double n = 7; n <= most; ++n) sum += std::cos(n * phase) / (natural * natural - n * n * base * base);
      if (phase == 0) sum -= 1 / (base * base * (most + 0.5));
      // A resonance is moved off by a ten-thousandth, of which lines above it see a fiftieth.
      EXPECT_NEAR(velocity_beyond(phase, 6, base, natural), base / pi * sum,
                  2e-5 * base / pi / (base * base) * 0.15)
          << natural << ", " << phase;
    }
}

// Dry friction of the model's own, as strong as half of what drives it.
class FrictionOverATurn : public testing::Test {
 protected:
  const CompiledModel& model = *generated::find_compiled_model("pendulum");

  std::size_t symbol(const std::string& name) const { return symbol_named(model, name); }
  std::vector<double> parameters() const {
    std::vector<double> values(model.symbols.size(), 0.0);
    values[symbol("omega0")] = 5.77;
    values[symbol("alpha3")] = -5.55;
    values[symbol("mu1")] = 0.01;
    values[symbol("fc")] = 0.5;
    return values;
  }
  MotionSetting setting(int highest, Index points) const {
    MotionSetting setting;
    setting.torus = std::make_shared<const Torus>(1, highest, points);
    setting.rate = {Complex(0, 5.6), Complex(0)};
    setting.excitation = MatrixXcd::Zero(static_cast<Index>(model.excitations.size()), setting.torus->lines());
    setting.masters = {{0, 1}};
    return setting;
  }
  Complex balance(int highest, Index points) const {
    const Motion motion = MotionBalance(model, {}).solve(
        setting(highest, points), Eigen::VectorXcd::Constant(1, Complex(0.1, 0.06)), parameters());
    EXPECT_TRUE(motion.converged()) << highest << " lines, " << points << " points";
    return motion.balance(0);
  }
};

TEST_F(FrictionOverATurn, AFewLinesBalanceAsManyDo) {
  const Complex many = balance(60, 1023);
  EXPECT_LT(std::abs(balance(6, 255) - many), 2e-4 * std::abs(many));
  EXPECT_LT(std::abs(balance(12, 255) - many), 5e-5 * std::abs(many));
  EXPECT_LT(std::abs(balance(6, 255) - balance(6, 254)), 1e-5 * std::abs(many));
}

TEST_F(FrictionOverATurn, LinesAndParametersMoveTheResidualAsDifferencesSay) {
  const MotionSetting setting = this->setting(6, 255);
  BalanceSweep sweep(model, {}, setting);
  const std::vector<double> parameters = this->parameters();
  const std::vector<SlavedLine> slaves = slaved_lines(setting, model, parameters);
  MatrixXcd lines = MatrixXcd::Zero(1, 7);
  lines.row(0) << 1e-3, Complex(0.1, 0.06), Complex(2e-3, 1e-3), Complex(-1e-3, 4e-3), 0, Complex(0, 1e-3), 0;
  const double step = 1e-7;
  const MatrixXcd slopes = sweep.residual_slopes(sweep.path(lines), parameters, slaves, step);
  for (Index e = 0; e < slopes.cols(); ++e) {
    const MatrixXcd up = sweep.residual(sweep.path(with_step(slaves, lines, e, step)), parameters),
                    down = sweep.residual(sweep.path(with_step(slaves, lines, e, -step)), parameters);
    const MatrixXcd difference = ((up - down) / (2 * step)).reshaped();
    EXPECT_LT((slopes.col(e) - difference).norm(), 2e-2 * difference.norm()) << "entry " << e;
  }
  const MatrixXcd by_friction = sweep.parameter_slopes(sweep.path(lines), parameters, {symbol("fc")}).front();
  std::vector<double> moved = parameters;
  moved[symbol("fc")] += 1e-4;
  const MatrixXcd up = sweep.residual(sweep.path(lines), moved);
  moved[symbol("fc")] -= 2e-4;
  const MatrixXcd difference = (up - sweep.residual(sweep.path(lines), moved)) / 2e-4;
  EXPECT_LT((by_friction - difference).norm(), 2e-2 * difference.norm());
}

}  // namespace
}  // namespace secular
