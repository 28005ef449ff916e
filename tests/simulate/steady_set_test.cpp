// Steady motions of dwells by harmonic balance, against the same by integration; and the noise of ensembles.
#include "motion/correction/steady_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>

#include "estimator/model/by_name.hpp"
#include "motion/correction/observation_noise.hpp"
#include "motion/correction/replay.hpp"
#include "tests/identification/virtual_campaign.hpp"
#include "tests/sensor_noise.hpp"

namespace secular {
namespace {

using testing_support::observed;
using testing_support::shipped_experiment;

struct Dwells {
  Experiment experiment;
  const CompiledModel* model;
  const CompiledCase* resonance;
  SimulatedCampaign simulated;
  ObservationSet set;

  Dwells(Experiment e, const std::string& case_name, bool noise) : experiment(std::move(e)) {
    if (!noise) experiment = testing_support::without_noise(std::move(experiment));
    model = generated::find_compiled_model(experiment.model);
    resonance = &case_named(*model, case_name);
    simulated = run_virtual_test(experiment, *model, 1, 2);
    set = observed(simulated, *model, *resonance);
  }
};

Experiment parametric() {
  Experiment e = shipped_experiment("principal_parametric");
  e.dwells.resize(1);
  e.dwells[0].frequencies_hz.resize(std::min<std::size_t>(3, e.dwells[0].frequencies_hz.size()));
  e.dwells[0].amplitudes.resize(1);
  e.dwells[0].ensembles = 2;
  e.dwells[0].settle_s = 200;
  return e;
}

Experiment combination() {
  Experiment e = shipped_experiment("thesis_chapter6");
  e.dwells.resize(1);
  e.dwells[0].frequencies_hz = {{45.54}};
  e.dwells[0].ensembles = 3;
  return e;
}

// From motions of one structure to those of another, which were never measured.
TEST(SteadySet, IsWhatASettledDwellOfTheParametersShows) {
  const Dwells here(parametric(), "principal_parametric", false);
  Experiment other = parametric();
  for (std::size_t p = 0; p < here.model->symbols.size(); ++p) {
    const std::string_view name = here.model->symbols[p].name;
    double& value = other.parameters(static_cast<Eigen::Index>(p));
    if (name == "mu1" || name == "alpha3") value *= 1.03;
  }
  const Dwells there(other, "principal_parametric", false);
  ASSERT_FALSE(here.set.observations.empty());
  ASSERT_EQ(here.set.observations.size(), there.set.observations.size());
  const std::optional<ObservationSet> found = SteadySet(here.set, 2).at(other.parameters);
  ASSERT_TRUE(found);
  double moved = 0;
  for (std::size_t i = 0; i < found->observations.size(); ++i) {
    const Observation &a = found->observations[i], &b = there.set.observations[i], &c = here.set.observations[i];
    const double size = std::abs(b.amplitude[0]);
    // The mode's phase against half of the excitation's is the motion's, up to a half turn.
    const auto phase = [](const Observation& o) { return std::arg(o.forcing[0]) - 2 * std::arg(o.amplitude[0]); };
    EXPECT_NEAR(std::abs(a.amplitude[0]), size, 1e-6 * size) << i;
    EXPECT_NEAR(std::abs(std::polar(1.0, phase(a)) - std::polar(1.0, phase(b))), 0, 1e-6) << i;
    EXPECT_LT(std::abs(a.rate[0] - b.rate[0]), 1e-6);
    for (std::size_t h = 0; h < a.harmonic.size(); ++h)
      if (b.harmonic_sd[h] >= 0) {
        EXPECT_NEAR(std::abs(a.harmonic[h]), std::abs(b.harmonic[h]), 1e-6 * size) << i;
      }
    moved = std::max(moved, std::abs(std::abs(c.amplitude[0]) / size - 1));
  }
  EXPECT_GT(moved, 1e-3) << "the two structures' motions are the same";
}

// Two modes, a frequency that the resonance leaves free: integrated from the steady state nothing grows, and each
// mode keeps the frequency that was found.
TEST(SteadySet, MotionsOfACombinationResonanceStandStill) {
  const Dwells dwells(combination(), "additive_combination", true);
  ASSERT_FALSE(dwells.set.observations.empty());
  const std::optional<ObservationSet> found = SteadySet(dwells.set, 2).at(dwells.experiment.parameters);
  ASSERT_TRUE(found);
  const ObservationSet integrated =
      observe_replay(dwells.simulated.campaign, *found, dwells.experiment.parameters, 2);
  ASSERT_FALSE(integrated.observations.empty());
  const Observation &a = integrated.observations.front(), &b = found->observations.front();
  for (std::size_t k = 0; k < 2; ++k) {
    // Lines beyond the highest one of the balance leave a ten-millionth.
    EXPECT_NEAR(a.rate[k].real(), 0, 1e-7 * b.rate[k].imag());
    EXPECT_NEAR(a.rate[k].imag(), b.rate[k].imag(), 1e-7 * b.rate[k].imag());
    EXPECT_NEAR(std::abs(a.amplitude[k]), std::abs(b.amplitude[k]), 1e-5 * std::abs(b.amplitude[k]));
  }
  EXPECT_NEAR(b.rate[0].imag() + b.rate[1].imag(), b.excitation_frequency[0], 1e-9);
}

TEST(SteadySet, NothingIsFoundBeyondTheRangeOfAResonance) {
  Dwells dwells(parametric(), "principal_parametric", false);
  Eigen::VectorXd damped = dwells.experiment.parameters;
  damped(static_cast<Eigen::Index>(symbol_named(*dwells.model, "mu1"))) *= 50;
  EXPECT_FALSE(SteadySet(dwells.set, 2).at(damped));
}

TEST(ObservationNoise, IsAsLargeAsEnsemblesSay) {
  const Dwells dwells(combination(), "additive_combination", true);
  constexpr int draws = 2000;
  const Observation& exact = dwells.set.observations.front();
  double amplitude[2] = {0, 0}, forcing = 0, split = 0, sum = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const ObservationSet noisy = with_observation_noise(dwells.set, static_cast<std::uint64_t>(draw));
    const Observation& o = noisy.observations.front();
    for (std::size_t k = 0; k < 2; ++k)
      amplitude[k] += std::norm((o.amplitude[k] - exact.amplitude[k]) / exact.amplitude_sd[k]) / (2 * draws);
    forcing += std::norm((o.forcing[0] - exact.forcing[0]) / exact.forcing_sd[0]) / (2 * draws);
    const double own = (o.rate[0] - o.rate[1]).imag() - (exact.rate[0] - exact.rate[1]).imag();
    split += std::pow(own / (exact.frequency_sd[0] + exact.frequency_sd[1]), 2) / draws;
    sum = std::max(sum, std::abs(o.rate[0].imag() + o.rate[1].imag() - o.excitation_frequency[0]));
  }
  // Means of squares of standard normal numbers: standard deviation sqrt(2/n).
  const double pair = 5 * std::sqrt(2.0 / (2 * draws)), one = 5 * std::sqrt(2.0 / draws);
  EXPECT_NEAR(amplitude[0], 1, pair);
  EXPECT_NEAR(amplitude[1], 1, pair);
  EXPECT_NEAR(forcing, 1, pair);
  EXPECT_NEAR(split, 1, one + 0.1);  // the excitation's own noise is split between the modes
  EXPECT_LT(sum, 1e-9) << "the frequencies of the modes add up to the excitation's";
}

}  // namespace
}  // namespace secular
