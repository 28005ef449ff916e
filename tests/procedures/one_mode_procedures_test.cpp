// The thesis's procedures for one mode on exact steady states: right equations return the truth, printed ones are
// off by what the misprint says.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <numbers>

#include "input/numerical_failure.hpp"
#include "tests/table_5_4.hpp"
#include "thesis/procedures/frequency_response_regression.hpp"
#include "thesis/procedures/harmonic_regression.hpp"
#include "thesis/procedures/jump_frequencies.hpp"
#include "thesis/procedures/saddle_node_regression.hpp"
#include "thesis/procedures/thesis_harmonics.hpp"

namespace secular {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::VectorXd;

using namespace testing_support::table_5_4;

double damping(NonlinearDamping law, double a) {
  return omega0 * mu1 + (law == NonlinearDamping::quadratic ? 4 * omega0 * omega0 / (3 * std::numbers::pi) * mu2 * a
                                                            : 0.375 * std::pow(omega0, 3) * mu3 * a * a);
}

// Force with which sigma(a) = 2/w0 (alpha_e a^2 - sqrt(eta^2 F^2 - D^2)) has its turning point at this amplitude,
// by bisection on the numerical derivative: nothing of the closed form of the procedure.
double force_of_saddle_node(NonlinearDamping law, double a) {
  const auto slope = [&](double force) {
    const auto sigma = [&](double x) {
      return alpha_e * x * x - std::sqrt(std::pow(eta_e * force, 2) - std::pow(damping(law, x), 2));
    };
    const double h = 1e-6 * a;
    return (sigma(a + h) - sigma(a - h)) / (2 * h);
  };
  // At a force just above the peak's the square root's slope dominates (positive here), far above it vanishes.
  double low = damping(law, a * (1 + 1e-5)) / eta_e, high = 100 * low;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (slope(middle) > 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

class SaddleNode : public testing::TestWithParam<NonlinearDamping> {
 protected:
  SaddleNode() : amplitude(VectorXd::LinSpaced(8, 8e-4, 2.4e-3)), peak(8), turning(8) {
    for (Index i = 0; i < 8; ++i) {
      peak(i) = damping(GetParam(), amplitude(i)) / eta_e;
      turning(i) = force_of_saddle_node(GetParam(), amplitude(i));
    }
  }
  double nonlinear() const { return (GetParam() == NonlinearDamping::quadratic ? mu2 : mu3) / eta_e; }
  VectorXd amplitude, peak, turning;
};

TEST_P(SaddleNode, AsPrintedItIsThePeak) {
  const SaddleNodeFit fit = saddle_node_regression(GetParam(), amplitude, peak, omega0);
  EXPECT_NEAR(fit.linear, mu1 / eta_e, 1e-12);
  EXPECT_NEAR(fit.nonlinear, nonlinear(), 1e-10);
  EXPECT_LT(fit.residual_sd, 1e-11);
}

TEST_P(SaddleNode, CorrectedItIsTheTurningPoint) {
  const SaddleNodeFit fit =
      saddle_node_regression(GetParam(), amplitude, turning, omega0, std::abs(alpha_e / eta_e));
  EXPECT_TRUE(fit.converged);
  EXPECT_NEAR(fit.linear, mu1 / eta_e, 1e-5 * mu1 / eta_e);
  EXPECT_NEAR(fit.nonlinear, nonlinear(), 1e-5 * nonlinear());
}

TEST_P(SaddleNode, TheShiftPutsEveryPointToTheRight) {
  VectorXd scattered = turning;
  for (Index i = 0; i < 8; ++i) scattered(i) *= 1 + 0.02 * std::cos(2.3 * static_cast<double>(i));
  const SaddleNodeFit fit = saddle_node_regression(GetParam(), amplitude, scattered, omega0);
  double closest = 1e300;
  for (Index i = 0; i < 8; ++i)
    closest = std::min(closest, scattered(i) - fit.fitted(i) - omega0 * (fit.lowered_linear - fit.linear));
  EXPECT_NEAR(closest, 0, 1e-11);
  EXPECT_LT(fit.lowered_linear, fit.linear);
}

INSTANTIATE_TEST_SUITE_P(Laws, SaddleNode, testing::Values(NonlinearDamping::quadratic, NonlinearDamping::cubic),
                         [](const auto& instance) {
                           return instance.param == NonlinearDamping::quadratic ? "quadratic" : "cubic";
                         });

TEST(SaddleNodeRegression, PrintedCubicLineIsOffByTheFactorOfTheVerdict) {
  // sqrt(1 + (3 w0^3 mu3/(8 alpha_e))^2), the 17 % that models/printed/fahey2000.toml records for (5.28).
  VectorXd amplitude = VectorXd::LinSpaced(8, 8e-4, 2.4e-3), turning(8);
  for (Index i = 0; i < 8; ++i) turning(i) = force_of_saddle_node(NonlinearDamping::cubic, amplitude(i));
  const SaddleNodeFit fit = saddle_node_regression(NonlinearDamping::cubic, amplitude, turning, omega0);
  const double factor = std::hypot(1.0, 0.375 * std::pow(omega0, 3) * mu3 / alpha_e);
  EXPECT_NEAR(factor, 1.174, 5e-4);
  EXPECT_NEAR(fit.linear / (mu1 / eta_e), factor, 1e-4);
  EXPECT_NEAR(fit.nonlinear / (mu3 / eta_e), factor, 1e-4);
}

struct Steady {
  Complex amplitude;  // half of the peak
  double excitation_frequency = 0;
};

// Steady state of the generated modulation equation with this amplitude and force: phase and frequency from
// (5.23), (5.24), confirmed by the generated code in the test.
Steady steady(double a, double force, double side) {
  const double sine = damping(NonlinearDamping::cubic, a) / (eta_e * force);
  const double gamma = side > 0 ? std::asin(sine) : std::numbers::pi - std::asin(sine);
  const double sigma = 2 / omega0 * (alpha_e * a * a - eta_e * force * std::cos(gamma));
  return {0.5 * a * std::polar(1.0, -0.5 * gamma), 2 * omega0 + sigma};
}

FrequencyResponseData frequency_response() {
  FrequencyResponseData data;
  data.omega0 = omega0;
  data.linear = mu1 / eta_e;
  data.cubic = mu3 / eta_e;
  constexpr int points = 12;
  data.amplitude.resize(points);
  data.forcing = VectorXd::Constant(points, 22.55);
  data.excitation_frequency.resize(points);
  data.cos_gamma.resize(points);
  for (int i = 0; i < points; ++i) {
    const double side = i < 9 ? -1 : 1;  // the last three lie beyond the peak
    const double a = i < 9 ? 4e-4 + 1.6e-4 * i : 1.95e-3 - 5e-5 * (i - 9);
    const Steady s = steady(a, 22.55, side);
    data.amplitude(i) = a;
    data.excitation_frequency(i) = s.excitation_frequency;
    data.cos_gamma(i) = std::cos(-2 * std::arg(s.amplitude));
    data.condition.push_back(i);
  }
  return data;
}

TEST(FrequencyResponseRegression, ReturnsTheTruthOnFixedPointsOfTheGeneratedEquation) {
  const FrequencyResponseData data = frequency_response();
  const VectorXd p = parameters();
  for (Index i = 0; i < data.amplitude.size(); ++i) {
    const Steady s = steady(data.amplitude(i), 22.55, data.cos_gamma(i));
    const Complex forcing = 22.55;
    Complex rate;
    resonance().modulation(p.data(), &s.excitation_frequency, &s.amplitude, &forcing, &rate);
    ASSERT_LT(std::abs(rate), 1e-10 * std::abs(s.amplitude)) << i;
  }
  const FrequencyResponseFit fit = frequency_response_regression(data);
  EXPECT_NEAR(fit.stiffness, alpha_e, 1e-8 * std::abs(alpha_e));
  EXPECT_NEAR(fit.excitation, eta_e, 1e-8);
}

TEST(FrequencyResponseRegression, AsPrintedTheExcitationTurnsItsSignOnTheUpperBranch) {
  FrequencyResponseData data = frequency_response();
  data.cos_gamma.resize(0);
  for (VectorXd* v : {&data.amplitude, &data.forcing, &data.excitation_frequency}) v->conservativeResize(9);
  data.condition.resize(9);
  const FrequencyResponseFit fit = frequency_response_regression(data);
  EXPECT_NEAR(fit.stiffness, alpha_e, 1e-8 * std::abs(alpha_e));
  EXPECT_NEAR(fit.excitation, -eta_e, 1e-8);
}

// Which ensembles are usable hangs on what was measured: without three of them there is no result.
TEST(FrequencyResponseRegression, HasNoResultWhereTheDampingNeedsMoreForceThanThereWas) {
  FrequencyResponseData data = frequency_response();
  data.linear = 1e3;
  EXPECT_THROW(frequency_response_regression(data), NumericalFailure);
  data.condition.pop_back();
  EXPECT_THROW(frequency_response_regression(data), std::invalid_argument);
}

TEST(JumpFrequencies, CentreOfTheBand) {
  const std::vector<SweepDwell> up = {{154.0, false}, {154.7, false}, {154.8, true}, {155, true}};
  const std::vector<SweepDwell> down = {{157, false}, {156.8, true}};
  const auto forward = onset_of(up), reverse = onset_of(down);
  ASSERT_TRUE(forward && reverse);
  const ResonanceCentre centre = resonance_centre(*forward, *reverse);
  EXPECT_DOUBLE_EQ(centre.thesis, 155.8);
  EXPECT_DOUBLE_EQ(centre.bracketed, 155.825);
  EXPECT_NEAR(centre.sd, 0.5 * std::hypot(0.1, 0.2) / std::sqrt(12.0), 1e-14);
  EXPECT_FALSE(onset_of(std::span(up).subspan(2)));
  EXPECT_FALSE(onset_of(std::span(up).first(2)));
}

// The hand-written Eq. (5.38) and the columns that the engine generates are the same equation.
TEST(ThesisHarmonics, CorrectedColumnsAreTheGeneratedOnes) {
  const ThesisHarmonic& equation = thesis_harmonics().front();
  ASSERT_EQ(equation.equation, "5.38");
  const Complex amplitude(3e-4, -7e-4), forcing = std::polar(21.0, 0.7);
  const double excitation = 2 * omega0, natural = omega0;
  const EnsembleTones tones{excitation, forcing, {omega0, 0}, {2.0 * amplitude, {}}};
  Complex hand[2], printed[2];
  equation.columns(tones, false, hand);
  equation.columns(tones, true, printed);
  bool found = false;
  for (const RegressorBlock& block : resonance().blocks) {
    if (block.kind != BlockKind::harmonic || block.name != "harmonic Omega of v") continue;
    found = true;
    ASSERT_EQ(block.lumps.size(), 2u);
    const Complex* amplitudes[] = {&amplitude};
    const Complex* forcings[] = {&forcing};
    const double* excitations[] = {&excitation};
    std::vector<Complex> generated(2);
    Complex* columns[] = {&generated[0], &generated[1]};
    block.columns({1, &natural, excitations, amplitudes, forcings}, columns);
    for (std::size_t j = 0; j < 2; ++j) {
      const std::string_view lump = resonance().lumps[static_cast<std::size_t>(block.lumps[j])].name;
      const std::size_t mine = lump == "eta1" ? 1 : 0;
      // The generated equation is in half amplitudes.
      EXPECT_LT(std::abs(2.0 * generated[j] - hand[mine]), 1e-12 * std::abs(hand[mine])) << lump;
    }
    EXPECT_EQ(printed[0], hand[0]);
    EXPECT_EQ(printed[1], -hand[1]);
  }
  EXPECT_TRUE(found);
}

TEST(HarmonicRegression, PooledAndByCondition) {
  HarmonicData data;
  const Eigen::Vector2d truth(-2e4, -0.018);
  constexpr int conditions = 5, ensembles = 4;
  data.columns.resize(conditions * ensembles, 2);
  data.target.resize(conditions * ensembles);
  for (int i = 0; i < conditions * ensembles; ++i) {
    data.condition.push_back(i / ensembles);
    data.columns.row(i) << std::polar(1e-11 * (1 + i), 0.3 * i), std::polar(1e-3, 0.1 * i * i);
    data.target(i) = (data.columns.row(i) * truth.cast<Complex>())(0);
  }
  const HarmonicFit fit = harmonic_regression(data);
  EXPECT_LT((fit.mean - truth).cwiseQuotient(truth).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((fit.pooled.coefficients - truth).cwiseQuotient(truth).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_EQ(fit.by_condition.rows(), conditions);
  EXPECT_LT(fit.sd(1), 1e-10);
}

}  // namespace
}  // namespace secular
