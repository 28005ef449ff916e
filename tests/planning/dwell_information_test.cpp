// Information of a dwell against the derivative of the steady response itself, and candidates against the
// equations.
#include "estimator/planning/dwell_information.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <numbers>

#include "estimator/planning/response_candidates.hpp"
#include "motion/response/response_field.hpp"
#include "tests/table_5_4.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using testing_support::table_5_4::model;
using testing_support::table_5_4::parameters;
using testing_support::table_5_4::resonance;
using testing_support::table_5_4::symbol;

CandidateRequest request() {
  CandidateRequest r;
  r.parameters.resize(parameters().size() + 2);
  r.parameters << parameters(), 0, 0;
  for (int i = 0; i < 9; ++i) r.frequencies.push_back(2 * std::numbers::pi * (24.58 + 0.04 * i));
  r.forcings = {22.5};
  return r;
}

const std::vector<DwellCandidate>& candidates() {
  static const std::vector<DwellCandidate> all =
      response_candidates(ResponseField(model(), resonance()), request());
  return all;
}

// Newton's method on the generated modulation equation.
Complex steady(const VectorXd& p, double frequency, double force, Complex b) {
  const Complex forcing = force;
  for (int i = 0; i < 30; ++i) {
    Complex rate;
    Eigen::Matrix<double, 2, 2, Eigen::RowMajor> jacobian;
    resonance().modulation(p.data(), &frequency, &b, &forcing, &rate);
    resonance().modulation_jacobian(p.data(), &frequency, &b, &forcing, jacobian.data());
    const Eigen::Vector2d step = jacobian.inverse() * Eigen::Vector2d(rate.real(), rate.imag());
    b -= Complex(step(0), step(1));
  }
  return b;
}

TEST(ResponseCandidates, AreStableSteadyAndReached) {
  ASSERT_GE(candidates().size(), 6u);
  for (const DwellCandidate& c : candidates()) {
    const Complex b = steady(parameters(), c.state.frequency, c.state.forcing, c.state.amplitude[0]);
    EXPECT_LT(std::abs(b - c.state.amplitude[0]), 1e-9 * std::abs(b));
    EXPECT_LT(c.slowest, 0);
    EXPECT_GE(c.settle_s, -std::log(1e3) / c.slowest * (1 - 1e-9));
    EXPECT_GT(c.start(0), 0);
  }
}

TEST(DwellInformation, IsThatOfTheSteadyResponse) {
  const VectorXd p = parameters();
  const DwellCandidate& c = candidates()[candidates().size() / 2];
  // Without the harmonics' own lumps: mu1, mu3 and omega0 are symbols whose effect the response shows by itself.
  const PlanUnknowns unknowns =
      plan_unknowns(model(), resonance(), p, {"mu2", "alpha_e", "eta_e", "eta1", "alpha_q"});
  ASSERT_EQ(unknowns.names.size(), 3u);
  PlanningNoise noise;
  noise.response_sd = {0.05};
  const MatrixXd information =
      dwell_information({model(), resonance(), p, unknowns, noise}, c.state, MatrixXd(), 10);
  MatrixXd slope(2, 3);
  for (Index u = 0; u < 3; ++u) {
    const Index s = symbol(unknowns.names[static_cast<std::size_t>(u)]);
    VectorXd up = p, down = p;
    // A natural frequency far finer: the response lives within 0.2 rad/s.
    const double h = s == 0 ? 1e-6 : 1e-4 * p(s);
    up(s) += h;
    down(s) -= h;
    // alpha_e and eta_e stay what they are: with alpha2 = delta2 = 0 they do not depend on omega0.
    const Complex d = (steady(up, c.state.frequency, c.state.forcing, c.state.amplitude[0]) -
                       steady(down, c.state.frequency, c.state.forcing, c.state.amplitude[0])) /
                      (2 * h);
    slope.col(u) << d.real(), d.imag();
  }
  const double w = 0.5 * c.state.frequency, sd = 0.05 / std::sqrt(2 * 1024.0) / (w * w);
  const MatrixXd expected = 10 / (sd * sd) * slope.transpose() * slope;
  for (Index i = 0; i < 3; ++i)
    for (Index j = 0; j < 3; ++j)
      EXPECT_NEAR(information(i, j), expected(i, j), 2e-3 * std::sqrt(expected(i, i) * expected(j, j)))
          << unknowns.names[static_cast<std::size_t>(i)] << ", " << unknowns.names[static_cast<std::size_t>(j)];
}

TEST(DwellInformation, RepeatabilityLimitsWhatEnsemblesBring) {
  const VectorXd p = parameters();
  const PlanUnknowns unknowns = plan_unknowns(model(), resonance(), p, {"mu2"});
  PlanningNoise noise;
  noise.response_sd = {0.05};
  noise.excitation_sd = 0.05;
  const auto mu3 = std::find(unknowns.names.begin(), unknowns.names.end(), "mu3") - unknowns.names.begin();
  const auto at = [&](int ensembles) {
    return dwell_information({model(), resonance(), p, unknowns, noise}, candidates()[1].state, MatrixXd(),
                             ensembles)(mu3, mu3);
  };
  EXPECT_NEAR(at(40), 4 * at(10), 1e-6 * at(40));
  noise.dwell_scatter = 0.02;
  EXPECT_LT(at(4000), 1.9 * 4000.0 / 10 * at(10));
  EXPECT_GT(at(40), at(10));
}

}  // namespace
}  // namespace secular
