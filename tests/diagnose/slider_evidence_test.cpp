// Sliders in stretches of motion: where they give way and turn, their limit, and fits that end in one place.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "diagnose/evidence/segment_evidence.hpp"
#include "diagnose/inference/refit.hpp"
#include "generated/registry.hpp"
#include "motion/simulate/motion.hpp"
#include "tests/diagnose/laboratory.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double slid_omega = 80, pulled = 1e-3, true_slip = 0.03 * pulled,
                 slid_sample_s = 2 * std::numbers::pi / slid_omega / 24;
constexpr double gives_way = 0.01 * pulled * slid_omega * slid_omega;  // force, of one kilogram

const ForceLaw only_friction{
    ForceLaw::Kind::state, [](double, double v, double, double) { return v > 0   ? 1.0
                                                                         : v < 0 ? -1.0
                                                                                 : 0.0; }, true};

// The model's excitation carries the force.
class SliderEvidence : public testing::TestWithParam<ForceLaw> {
 protected:
  std::size_t symbol(const std::string& name) const { return symbol_named(model, name); }
  Index at(const std::string& name) const { return static_cast<Index>(symbol(name)); }

  VectorXd unknowns(double slips_at) const {
    return testing_support::unknowns_of(
        model, FaultTable(model, sensors),
        {{"omega0", slid_omega}, {"mu1", 0.1}, {"eta1", -gives_way / pulled}, {"mu3", slips_at}});
  }
  StateForce force(const ForceLaw& law) const { return {law, 0, 0, symbol("eta1"), symbol("mu3"), pulled}; }

  StretchOfMotion motion(const ForceLaw& law, double slips_at, Index samples, int substeps) const {
    const VectorXd values = unknowns(slips_at);
    StateForce acts = force(law);
    if (law.kind == ForceLaw::Kind::state) acts.shape_symbol = StateForce::none;
    MotionStart begin{{values.data(), values.data() + model.symbols.size()},
                      Eigen::Vector2d(pulled, 0),
                      std::make_shared<const DrivingSignal>(DrivingSignal{{}, slid_sample_s}),
                      samples,
                      substeps};
    if (law.kind == ForceLaw::Kind::state) begin.parameters[symbol("eta1")] = -gives_way;
    begin.parameters[symbol("mu3")] *= law.kind == ForceLaw::Kind::state ? 0 : 1;
    return MotionIntegrator(model, {acts}).motion(begin);
  }

  // A decay with noise of a thousandth of its begin; every reading times 1 + 1e-9 u.
  SegmentEvidence decay(unsigned draw) const {
    constexpr Index length = 144;
    const StretchOfMotion m = motion(GetParam(), true_slip, 3 * length, 16);
    std::mt19937_64 random(5), drawn(draw);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> even(-1, 1);
    std::vector<Segment> segments;
    for (int i = 0; i < 3; ++i) {
      Segment s;
      s.fold = i;
      s.sample_s = slid_sample_s;
      s.substeps = 3;
      s.response = m.displacement.middleCols(i * length, length);
      s.noise_sd = VectorXd::Constant(1, 1e-3 * pulled);
      for (double& reading : s.response.row(0))
        reading = (reading + s.noise_sd(0) * normal(random)) * (1 + 1e-9 * even(drawn));
      segments.push_back(std::move(s));
    }
    return {model, {force(GetParam())}, sensors, FaultTable(model, sensors), std::move(segments)};
  }

  const CompiledModel& model = *generated::find_compiled_model("two_mass_mode1");
  SensorModel sensors = testing_support::one_sensor("v");
};

// Where it turns, it takes a time as the square root of the slip until it slides.
TEST_P(SliderEvidence, FarBelowTheMotionItIsDryFriction) {
  constexpr Index samples = 240;
  const StretchOfMotion friction = motion(only_friction, 0, samples, 3);
  for (const double share : {3e-2, 3e-3, 3e-4}) {
    const StretchOfMotion m = motion(GetParam(), share * pulled, samples, 3);
    EXPECT_LT((m.displacement - friction.displacement).cwiseAbs().maxCoeff(), 0.6 * std::sqrt(share) * pulled)
        << share;
  }
}

// From either side of the truth, whatever the last digits of the readings.
TEST_P(SliderEvidence, ItsFitEndsInOnePlace) {
  VectorXd first;
  double least = 0;
  for (unsigned draw = 0; draw < 4; ++draw) {
    Discrepancy discrepancy;
    discrepancy.add(std::make_unique<SegmentEvidence>(decay(draw)));
    VectorXd here = unknowns((draw % 2 == 0 ? 0.3 : 2.5) * true_slip);
    Refit fit;
    for (int round = 0; round < 4; ++round) {
      discrepancy.freeze(here);
      fit = refit(discrepancy, here, {symbol("omega0"), symbol("mu1"), symbol("eta1"), symbol("mu3")});
      here = fit.unknowns;
    }
    EXPECT_EQ(fit.ending, SolverEnding::converged) << draw;
    EXPECT_NEAR(std::abs(here(at("mu3"))), true_slip, 4 * std::sqrt(fit.covariance(3, 3))) << draw;
    if (draw == 0) {
      first = here;
      least = fit.chi_squared;
    }
    // Twice the evidence's hundredth, within which probabilities are to stay.
    EXPECT_NEAR(fit.chi_squared, least, 0.02) << draw;
    EXPECT_NEAR(std::abs(here(at("mu3"))), std::abs(first(at("mu3"))), 0.05 * std::sqrt(fit.covariance(3, 3)))
        << draw;
  }
}

// A Jenkins element by itself: located to rounding and integrated to 1e-10 (motion/simulate).
class JenkinsStretch : public SliderEvidence {};

TEST_P(JenkinsStretch, IsThatOfASlipElementInStepsOfASeventiethOfATurn) {
  constexpr std::size_t samples = 240;
  VectorXd values = unknowns(true_slip);
  values(at("eta1")) = -gives_way / true_slip;
  values(at("mu3")) = 0;
  MotionSettings settings;
  settings.slip_elements = {{0, 0, true_slip}};
  MotionState state{{pulled}, {0}, {0}};
  std::vector<double> truth;
  integrate_motion({model, values.data(), {}}, {0, 0, slid_sample_s, samples}, settings, state,
                   [&](const MotionSample& s) { truth.push_back(s.displacement[0]); });
  const StretchOfMotion m = motion(GetParam(), true_slip, samples, 3);
  double worst = 0;
  for (std::size_t i = 0; i < samples; ++i)
    worst = std::max(worst, std::abs(m.displacement(0, static_cast<Index>(i)) - truth[i]));
  EXPECT_LT(worst, 1e-4 * pulled);
  EXPECT_LT(truth.back(), pulled);
}

INSTANTIATE_TEST_SUITE_P(Laws, SliderEvidence,
                         testing::Values(force_law::slider, force_law::spread_slider, force_law::smooth_slider));
INSTANTIATE_TEST_SUITE_P(Laws, JenkinsStretch, testing::Values(force_law::slider));

}  // namespace
}  // namespace secular
