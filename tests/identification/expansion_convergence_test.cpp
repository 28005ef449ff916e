// The expansion against the full equations: the periodic solution's Fourier coefficient approaches the fixed point
// of the modulation equations as eps goes to zero, with the order that the truncation promises.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <cstdio>
#include <numbers>
#include <vector>

#include "generated/registry.hpp"
#include "motion/simulate/motion.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;

class Scaled {
 public:
  // Coefficients of the principal parametric case, each times its power of eps.
  explicit Scaled(double eps) : eps_(eps) {
    const double e2 = eps * eps;
    //             omega0 mu1       mu2       mu3       alpha2     alpha3    delta2     delta3    eta1       eta2
    parameters_ = {1.0,      0.2 * e2,  0.1 * e2, 0.3 * e2,  0.5 * eps,
                   0.6 * e2, 0.2 * eps, 0.3 * e2, 0.4 * eps, 2.5 * e2};
    omega_ = 2 + 0.4 * e2;
  }

  Complex modulation(Complex b) const {
    const Complex forcing = 1;
    Complex rate;
    resonance().modulation(parameters_.data(), &omega_, &b, &forcing, &rate);
    return rate / (eps_ * eps_);
  }

  // Fixed point by Newton from a large amplitude (the upper branch).
  Complex fixed_point() const {
    Eigen::Vector2d x(0.6, 0.5);
    for (int i = 0; i < 60; ++i) {
      const Complex f = modulation({x(0), x(1)});
      Eigen::Matrix2d jacobian;
      for (int c = 0; c < 2; ++c) {
        Eigen::Vector2d moved = x;
        moved(c) += 1e-7;
        const Complex d = (modulation({moved(0), moved(1)}) - f) / 1e-7;
        jacobian.col(c) << d.real(), d.imag();
      }
      x -= jacobian.fullPivLu().solve(Eigen::Vector2d(f.real(), f.imag()));
    }
    return {x(0), x(1)};
  }

  // Coefficients of exp(i Omega t/2) and exp(i Omega t) in the periodic solution near b, found by shooting.
  std::pair<Complex, Complex> periodic(Complex b) const {
    const double period = 4 * std::numbers::pi / omega_;
    Eigen::Vector2d state(2 * b.real(), -omega_ * b.imag());
    const auto after = [&](const Eigen::Vector2d& start, std::vector<double>* samples) {
      constexpr int count = 512;
      MotionState moving{{start(0)}, {start(1)}};
      int i = 0;
      Eigen::Vector2d end;
      integrate_motion({model(), parameters_.data(), signal()}, {0, 0, period / count, count + 1}, settings(),
                       moving, [&](const MotionSample& s) {
                         if (samples && i < count) samples->push_back(s.displacement[0]);
                         ++i;
                         end << s.displacement[0], s.velocity[0];
                       });
      return end;
    };
    for (int iteration = 0; iteration < 30; ++iteration) {
      const Eigen::Vector2d gap = after(state, nullptr) - state;
      Eigen::Matrix2d jacobian;
      for (int c = 0; c < 2; ++c) {
        Eigen::Vector2d moved = state;
        moved(c) += 1e-5;
        jacobian.col(c) = (after(moved, nullptr) - moved - gap) / 1e-5;
      }
      const Eigen::Vector2d step = jacobian.fullPivLu().solve(gap);
      state -= step;
      if (step.norm() < 1e-12) break;
    }
    std::vector<double> samples;
    after(state, &samples);
    Complex half = 0, whole = 0;
    const auto n = static_cast<double>(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(i) / n;
      half += samples[i] * std::polar(1.0, -angle) / n;
      whole += samples[i] * std::polar(1.0, -2 * angle) / n;
    }
    return {half, whole};
  }

  const std::vector<double>& parameters() const { return parameters_; }
  double omega() const { return omega_; }
  static const CompiledModel& model() { return *generated::find_compiled_model("two_mass_mode1"); }
  static const CompiledCase& resonance() { return model().cases[0]; }

 private:
  ExcitationSignal signal() const {
    return [w = omega_](double t, ExcitationSample* s) {
      s[0] = {std::cos(w * t), -w * std::sin(w * t), -w * w * std::cos(w * t)};
    };
  }
  static MotionSettings settings() {
    MotionSettings s;
    s.relative_tolerance = s.absolute_tolerance = 1e-13;
    return s;
  }
  double eps_, omega_;
  std::vector<double> parameters_;
};

TEST(Expansion, FixedPointConvergesToThePeriodicSolutionOfTheFullEquations) {
  ASSERT_EQ(Scaled::resonance().name, "principal_parametric");
  std::vector<double> eps = {0.16, 0.08, 0.04, 0.02}, errors;
  for (const double e : eps) {
    const Scaled scaled(e);
    const Complex predicted = scaled.fixed_point();
    ASSERT_GT(std::abs(predicted), 0.1);
    const auto [half, whole] = scaled.periodic(predicted);
    // A and -A are the same state half a period later.
    errors.push_back(std::min(std::abs(half - predicted), std::abs(half + predicted)) / std::abs(predicted));
    std::printf("eps %.3f  relative error of the amplitude %.3e\n", e, errors.back());
  }
  for (std::size_t i = 1; i < eps.size(); ++i) {
    const double slope = std::log(errors[i - 1] / errors[i]) / std::log(2.0);
    std::printf("log-log slope %.3f\n", slope);
    // What is left out of the modulation equations is of relative order eps or smaller.
    EXPECT_GT(slope, 0.9);
  }
  EXPECT_LT(errors.back(), 2e-3);
}

}  // namespace
}  // namespace secular
