// Dwells at an additive combination resonance: the response frequencies are not known, only their sum is.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <complex>
#include <numbers>

#include "measure/observe/mode_frequencies.hpp"
#include "measure/observe/related_tones.hpp"
#include "measure/observe/steady_amplitude.hpp"
#include "motion/simulate/noise.hpp"
#include "numerics/hertz.hpp"
#include "virtual_campaign.hpp"

namespace secular {
namespace {

using namespace testing_support;
using Eigen::Index;

// A dwell that settles within its ensemble: value, slope and curvature at the centre of a sum of exponentials, with
// time constants as the two-mass structure has them.
TEST(RelatedTones, AmplitudesThatSettle) {
  constexpr double rate = 256, w = 77.8;
  constexpr Index samples = 1024;
  using Complex = std::complex<double>;
  const Complex decay(-0.28, 0.35), steady = std::polar(1.0, 0.4), off = std::polar(0.02, 1.1);
  Eigen::MatrixXd y(samples, 1);
  for (Index i = 0; i < samples; ++i) {
    const double t = (static_cast<double>(i) - 0.5 * (samples - 1)) / rate;
    y(i, 0) = 2 * ((steady + off * std::exp(decay * t)) * std::exp(Complex(0, w * t))).real();
  }
  const auto fit_of = [&](int degree) {
    const RelatedTones tones{Eigen::VectorXd::Constant(1, w), Eigen::MatrixXd(1, 0), 1, degree};
    return fit_related_tones(y, rate, tones, Eigen::VectorXd());
  };
  const RelatedToneFit quadratic = fit_of(2), quartic = fit_of(4);
  const Complex slope = decay * off, curvature = decay * slope;
  // A cubic term s t^3 adds 3/5 s T^2 to the slope of a fit over (-T, T); one of fifth order 5/21 s T^4 to that of
  // a fit with a cubic.
  const double half = 2, cubic = std::abs(decay * curvature) / 6,
               fifth = std::abs(decay * decay * decay * curvature) / 120;
  EXPECT_NEAR(std::abs(quadratic.slope(0, 0) - slope), 0.6 * half * half * cubic, 0.2 * half * half * cubic);
  EXPECT_LT(std::abs(quartic.slope(0, 0) - slope), 2 * 5.0 / 21 * std::pow(half, 4) * fifth);
  EXPECT_LT(std::abs(quartic.slope(0, 0) - slope), 0.02 * std::abs(quadratic.slope(0, 0) - slope));
  EXPECT_LT(std::abs(quartic.curvature(0, 0) - curvature), 0.02 * std::abs(curvature));
}

// Two tones that add up to a known frequency; least-squares statistics over draws.
TEST(StatisticalRelatedTones, FrequencyAndItsErrorBar) {
  constexpr double rate = 256, sum = 2 * std::numbers::pi * 45.54, second = 2 * std::numbers::pi * 33.1537;
  constexpr Index samples = 1024;
  constexpr double noise_sd = 0.05;
  constexpr int draws = 60;
  RelatedTones tones{Eigen::Vector3d(sum, 0, sum), Eigen::Vector3d(-1, 1, 0), 0};
  double square = 0, reported = 0;
  for (int draw = 0; draw < draws; ++draw) {
    NoiseStream noise(7, static_cast<std::uint64_t>(draw), 0);
    Eigen::MatrixXd y(samples, 2);
    for (Index i = 0; i < samples; ++i) {
      const double t = (static_cast<double>(i) - 0.5 * (samples - 1)) / rate;
      const double one = 3 * std::cos((sum - second) * t + 0.4), two = 2 * std::cos(second * t - 1);
      y(i, 0) = one - 0.6 * two + std::cos(sum * t) + 0.3 + noise_sd * noise.gaussian();
      y(i, 1) = 0.7 * one + two + noise_sd * noise.gaussian();
    }
    const RelatedToneFit fit =
        fit_related_tones(y, rate, tones, Eigen::VectorXd::Constant(1, second + 0.7 * 2 * std::numbers::pi / 4));
    ASSERT_EQ(fit.ending, SolverEnding::converged);
    square += std::pow((fit.free(0) - second) / fit.free_sd(0), 2);
    reported += fit.free_sd(0) / draws;
    EXPECT_NEAR(std::abs(fit.amplitude(0, 0)), 1.5, 6 * fit.amplitude_sd(0, 0));
    EXPECT_NEAR(std::abs(fit.amplitude(1, 1)), 1.0, 6 * fit.amplitude_sd(1, 1));
    EXPECT_NEAR(fit.offset(0), 0.3, 6 * fit.offset_sd(0));
  }
  // Sum of `draws` squares of standard normals: mean draws, sd sqrt(2 draws).
  EXPECT_NEAR(square, draws, 4 * std::sqrt(2.0 * draws));
  // Cramer-Rao bound of the shared frequency: 12 sd^2/(rate T^3) over the sum of squared peak amplitudes times
  // half.
  const double power = 9 * (1 + 0.49) + 4 * (0.36 + 1), length = samples / rate;
  const double bound = noise_sd * std::sqrt(24 / (rate * length * length * length * power));
  EXPECT_NEAR(reported / bound, 1, 0.05);
}

// Table 6.2's lumps in the model that has one term for each of them, on two sweeps and one level series.
Experiment combination_experiment() {
  Experiment e;
  const CompiledModel& model = *generated::find_compiled_model("two_mass_lumps");
  e.name = "combination";
  e.model = "two_mass_lumps";
  e.sample_rate_hz = 256;
  const std::map<std::string, double> values = {{"omega1", 77.84866595595507},
                                                {"omega2", 208.41325663914688},
                                                {"mu11", 0.273},
                                                {"mu22", 0.293},
                                                {"mu13", 229},
                                                {"mu23", 1006},
                                                {"lambda", 0},
                                                {"alpha1", 1430491217.98},
                                                {"alpha2", -12091836408.2},
                                                {"kappa", -0.149},
                                                {"p", -6.604},
                                                {"q1", -0.002593},
                                                {"q2", -0.01757}};
  e.parameters.resize(static_cast<Index>(model.symbols.size()));
  for (std::size_t p = 0; p < model.symbols.size(); ++p)
    e.parameters(static_cast<Index>(p)) = values.at(std::string(model.symbols[p].name));
  const auto channel = [](const char* name, ChannelRole role, std::vector<double> shape) {
    SimulatedChannel made;
    made.channel = {name, role, Quantity::acceleration, "m/s^2"};
    made.noise_sd = 0.05;
    made.shape = std::move(shape);
    return made;
  };
  e.excitations = {channel("base", ChannelRole::excitation, {})};
  e.responses = {channel("a1", ChannelRole::response, {1.1603, -0.7199}),
                 channel("a2", ChannelRole::response, {0.7336, 1.1428})};
  e.modal_basis = ModalBasis{{"a1", "a2"}, {"v1", "v2"}, {{1.1603, -0.7199}, {0.7336, 1.1428}}};
  const auto dwell = [&](std::vector<std::vector<double>> frequencies, std::vector<std::vector<double>> levels) {
    DwellProgramme d;
    d.frequencies_hz = std::move(frequencies);
    d.amplitudes = std::move(levels);
    d.ensembles = 4;
    d.settle_s = 200;
    d.carry_state = true;
    d.initial_displacement = {4e-4, 2e-4};
    e.dwells.push_back(d);
  };
  dwell({{45.545}, {45.555}, {45.565}}, {{26}});
  dwell({{45.56}}, {{30}, {28}, {25}});
  dwell({{45.57}}, {{31}, {29}, {27}});
  return e;
}

// Amplitudes of a motion by the equations of modulation, from rest but for a push, and how fast they change.
Observation combination_motion(const CompiledModel& model, const CompiledCase& resonance,
                               const Eigen::VectorXd& parameters, double seconds) {
  using Complex = std::complex<double>;
  Observation o;
  o.excitation_frequency = {two_pi * 45.555};
  o.forcing = {26};
  o.amplitude = {Complex(2e-4, 1e-5), Complex(1e-4, 0)};
  const auto change = [&](const std::vector<Complex>& amplitude) {
    std::vector<Complex> slope(2);
    resonance.modulation(parameters.data(), o.excitation_frequency.data(), amplitude.data(), o.forcing.data(),
                         slope.data());
    return slope;
  };
  constexpr double step = 0.02;
  const auto moved = [&](const std::vector<Complex>& slope, double by) {
    return std::vector<Complex>{o.amplitude[0] + by * slope[0], o.amplitude[1] + by * slope[1]};
  };
  for (double t = 0; t < seconds; t += step) {
    const auto k1 = change(o.amplitude), k2 = change(moved(k1, step / 2)), k3 = change(moved(k2, step / 2)),
               k4 = change(moved(k3, step));
    for (std::size_t k = 0; k < 2; ++k) o.amplitude[k] += step / 6 * (k1[k] + 2.0 * k2[k] + 2.0 * k3[k] + k4[k]);
  }
  const ModeFrequencies modes = mode_frequencies(model, resonance);
  Eigen::VectorXd natural(1);
  natural(0) = parameters(static_cast<Index>(modes.free.front()));
  const Eigen::VectorXd frame = modes.observed(natural, o.excitation_frequency);
  const std::vector<Complex> slope = change(o.amplitude);
  for (std::size_t k = 0; k < 2; ++k)
    o.rate.push_back(slope[k] / o.amplitude[k] + Complex(0, frame(static_cast<Index>(k))));
  return o;
}

// A combination resonance moves at frequencies of its own, which are not the natural ones: that is no drift.
TEST(Combination, ASteadyMotionStaysAndOneThatDriftsGoesWhereItSettles) {
  const Experiment experiment = combination_experiment();
  const CompiledModel& model = *generated::find_compiled_model(experiment.model);
  const CompiledCase& resonance = case_named(model, "additive_combination");
  ObservationSet set;
  set.model = &model;
  set.resonance = &resonance;
  const Observation settled = combination_motion(model, resonance, experiment.parameters, 800);
  const Observation drifting = combination_motion(model, resonance, experiment.parameters, 75);
  set.observations = {settled, drifting};
  const std::size_t free = mode_frequencies(model, resonance).free.front();
  ASSERT_GT(std::abs(settled.rate[free].imag() - experiment.parameters(static_cast<Index>(free))), 0.01);
  const double off = std::abs(drifting.amplitude[0]) / std::abs(settled.amplitude[0]) - 1;
  ASSERT_GT(std::abs(off), 1e-4);
  ASSERT_LT(std::abs(off), 0.05);
  to_steady_amplitudes(set, experiment.parameters);
  for (std::size_t k = 0; k < 2; ++k) {
    const double steady = std::abs(settled.amplitude[k]);
    EXPECT_NEAR(std::abs(set.observations[0].amplitude[k]), steady, 1e-8 * steady);
    EXPECT_NEAR(std::abs(set.observations[1].amplitude[k]), steady, 10 * off * off * steady);
  }
}

TEST(SlowCombination, LumpsOfTheThesisAreRecovered) {
  const Experiment experiment = combination_experiment();
  const CompiledModel& model = *generated::find_compiled_model(experiment.model);
  const CompiledCase& resonance = case_named(model, "additive_combination");
  const SimulatedCampaign simulated = run_virtual_test(experiment, model, 3, 2);
  const ObservationSet set = observed(simulated, model, resonance);
  ASSERT_GE(set.observations.size(), 32U) << (set.warnings.empty() ? "" : set.warnings.front());
  // The truncation is still in the equations.
  const Estimate result = estimate(set, "kg^(1/2) m", {"m/s^2"}, {}, {.judge_fit = false});
  for (const char* name : {"omega2", "mu11", "mu22", "mu13", "mu23", "p", "q1", "q2", "alpha1", "alpha2"}) {
    const EstimatedValue& v = value_of(result, name);
    ASSERT_TRUE(v.value) << name;
    // Nine conditions at most: Student's t with eight degrees of freedom exceeds 5 once in a thousand; one percent
    // of the value for what the first-order expansion leaves out.
    EXPECT_NEAR(*v.value, truth_of(model, resonance, experiment.parameters, name),
                5 * v.sd + 0.01 * std::abs(*v.value))
        << name << " sd " << v.sd;
  }
  for (const char* name : {"mu11", "mu22", "p"})
    EXPECT_LT(value_of(result, name).sd, 0.05 * std::abs(*value_of(result, name).value));
  // A change of stiffness and a change of natural frequency are one and the same.
  EXPECT_FALSE(value_of(result, "lambda").identifiable);
  bool named = false;
  for (const NullDirection& direction : result.null_directions)
    named = named || (direction.text.find("lambda") != std::string::npos);
  EXPECT_TRUE(named || !value_of(result, "lambda").entangled_with.empty());
  for (const ConditionQuality& condition : result.conditions) {
    ASSERT_TRUE(condition.gamma);
    EXPECT_LT(*condition.gamma_sd, 0.05);
  }
}

}  // namespace
}  // namespace secular
