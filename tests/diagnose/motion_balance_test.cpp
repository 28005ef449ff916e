// Harmonic balance with the resonant line given, against what is known in closed form.
#include "motion/balance/motion_balance.hpp"

#include <gtest/gtest.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <cmath>
#include <numbers>

#include "motion/integrate/motion_integrator.hpp"
#include "estimator/model/by_name.hpp"
#include "generated/registry.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;

Eigen::VectorXd parameters_of(const CompiledModel& model,
                              std::initializer_list<std::pair<const char*, double>> values) {
  Eigen::VectorXd parameters = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(model.symbols.size()));
  for (const auto& [name, value] : values) parameters(static_cast<Eigen::Index>(symbol_named(model, name))) = value;
  return parameters;
}

MotionSetting steady(const CompiledModel& model, double frequency, int highest) {
  MotionSetting setting;
  setting.torus = std::make_shared<const Torus>(1, highest, 128);
  setting.rate = {Complex(0, frequency), Complex(0)};
  setting.excitation =
      Eigen::MatrixXcd::Zero(static_cast<Eigen::Index>(model.excitations.size()), setting.torus->lines());
  setting.masters = {{0, 1}};
  return setting;
}

TEST(MotionBalance, LinearOscillatorHasItsTransferFunction) {
  const CompiledModel& model = *generated::find_compiled_model("two_mass_mode1");
  const double w0 = 80, mu = 0.3, eta = -0.02, force = 5;
  const Eigen::VectorXd p = parameters_of(model, {{"omega0", w0}, {"mu1", mu}, {"eta1", eta}});
  for (const double w : {78.0, 80.0, 81.5}) {
    MotionSetting setting = steady(model, w, 3);
    setting.excitation(0, 1) = force / 2;
    const Complex amplitude = eta * force / 2 / Complex(w0 * w0 - w * w, 2 * mu * w);
    const Motion motion =
        MotionBalance(model, {}).solve(setting, Eigen::VectorXcd::Constant(1, amplitude), {p.data(), 10});
    EXPECT_TRUE(motion.converged());
    EXPECT_LT(std::abs(motion.balance(0)), 1e-12 * w0 * w0 * std::abs(amplitude));
  }
}

TEST(MotionBalance, FreeDecayRateOfALinearOscillatorBalances) {
  const CompiledModel& model = *generated::find_compiled_model("two_mass_mode1");
  const double w0 = 80, mu = 4;
  const Eigen::VectorXd p = parameters_of(model, {{"omega0", w0}, {"mu1", mu}});
  MotionSetting setting = steady(model, 0, 3);
  setting.rate[0] = Complex(-mu, std::sqrt(w0 * w0 - mu * mu));
  const Motion motion =
      MotionBalance(model, {}).solve(setting, Eigen::VectorXcd::Constant(1, Complex(1e-3, 2e-4)), {p.data(), 10});
  EXPECT_LT(std::abs(motion.balance(0)), 1e-12 * w0 * w0 * 1e-3);
}

// A spring a thousand times beyond what its lines can carry: nothing is near, and no number stands for that.
TEST(MotionBalance, AMotionThatRunsAwayIsNoNumber) {
  const CompiledModel& model = *generated::find_compiled_model("pendulum");
  const Eigen::VectorXd p = parameters_of(model, {{"omega0", 5}, {"alpha3", 1e5}});
  const Motion motion =
      MotionBalance(model, {}).solve(steady(model, 5, 9), Eigen::VectorXcd::Constant(1, Complex(1)),
                                     {p.data(), static_cast<std::size_t>(p.size())});
  EXPECT_FALSE(motion.converged());
  EXPECT_FALSE(motion.displacement.allFinite());
}

// The free Duffing oscillator x'' + w^2 x + a x^3 = 0 released at X turns with the frequency
// pi sqrt(w^2 + a X^2) / (2 K(k)), k^2 = a X^2 / (2 (w^2 + a X^2)).
TEST(MotionBalance, DuffingBackboneIsTheEllipticOneAtAnyAmplitude) {
  const CompiledModel& model = *generated::find_compiled_model("pendulum");
  const double w0 = 5, alpha = 6;
  const Eigen::VectorXd p = parameters_of(model, {{"omega0", w0}, {"alpha3", alpha}});
  for (const double peak : {0.1, 1.0, 3.0}) {
    const double stiff = w0 * w0 + alpha * peak * peak;
    const double exact = std::numbers::pi * std::sqrt(stiff) /
                         (2 * boost::math::ellint_1(std::sqrt(alpha * peak * peak / (2 * stiff))));
    MotionSetting setting = steady(model, exact, 11);
    // The first line's share of the release amplitude is not one: found so that all lines together reach the peak.
    double half = peak / 2;
    Motion motion;
    for (int i = 0; i < 40; ++i) {
      motion = MotionBalance(model, {}).solve(setting, Eigen::VectorXcd::Constant(1, Complex(half)),
                                              {p.data(), static_cast<std::size_t>(p.size())});
      const double reached = 2 * motion.displacement.row(0).tail(11).real().sum();
      half *= peak / reached;
    }
    EXPECT_TRUE(motion.converged());
    EXPECT_LT(std::abs(motion.balance(0)), 1e-6 * exact * exact * half) << peak;
  }
}

TEST(StretchOfMotion, FollowsTheLinearDecayToFourthOrder) {
  const CompiledModel& model = *generated::find_compiled_model("pendulum");
  const double w0 = 5, mu = 0.2;
  const Eigen::VectorXd p = parameters_of(model, {{"omega0", w0}, {"mu1", mu}});
  const double wd = std::sqrt(w0 * w0 - mu * mu);
  const auto silent = std::make_shared<const DrivingSignal>(DrivingSignal{{}, 0.05});
  const auto worst = [&](int substeps) {
    const StretchOfMotion motion = MotionIntegrator(model, {}).motion(
        {{p.data(), p.data() + p.size()}, Eigen::Vector2d(1, -mu), silent, 200, substeps});
    double error = 0;
    for (Eigen::Index i = 0; i < 200; ++i) {
      const double t = 0.05 * static_cast<double>(i);
      error = std::max(error, std::abs(motion.displacement(0, i) - std::exp(-mu * t) * std::cos(wd * t)));
    }
    return error;
  };
  const double coarse = worst(2), fine = worst(4);
  EXPECT_LT(fine, 1e-5);
  EXPECT_NEAR(std::log2(coarse / fine), 4, 0.2);
}

}  // namespace
}  // namespace secular
