// Coverage of the 95 % intervals: the full equations are integrated once, noise is drawn many times, everything
// after it (observation, regression, error bars) is done again for every draw. Set SECULAR_COVERAGE_DRAWS for the
// table with more draws.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "estimator/regression/confidence.hpp"
#include "simulate/noise.hpp"
#include "virtual_campaign.hpp"

namespace secular {
namespace {

using namespace testing_support;

int draws_wanted(int fallback) {
  const char* text = std::getenv("SECULAR_COVERAGE_DRAWS");
  return text ? std::atoi(text) : fallback;
}

Experiment without_noise(Experiment e) {
  if (e.excitation) e.excitation->noise_sd = e.excitation->quantisation = 0;
  for (SimulatedChannel& channel : e.responses) channel.noise_sd = channel.quantisation = 0;
  return e;
}

struct Coverage {
  std::string name;
  int inside = 0;
  double bias = 0, truth = 0, mean_sd = 0, scatter = 0, mean = 0;
};

// How often the interval contains the truth once the bias that all draws share (the expansion's truncation, which
// `identify` takes out by replaying the full equations) is taken out: that is listed by itself.
std::vector<Coverage> coverage(const Experiment& experiment, const std::string& case_name,
                               const std::vector<std::string>& names, int draws) {
  const CompiledModel& model = *generated::find_compiled_model(experiment.model);
  const CompiledCase& resonance = case_named(model, case_name);
  const SimulatedCampaign exact = run_virtual_test(without_noise(experiment), model, 1, 2);
  EstimateOptions options;
  options.damping_laws = false;
  const auto add_noise = [&](SimulatedCampaign& noisy, std::uint64_t seed) {
    for (std::size_t r = 0; r < noisy.samples.size(); ++r)
      for (std::size_t c = 0; c < noisy.samples[r].channels.size(); ++c) {
        const bool excitation = experiment.excitation && c == 0;
        const double sd = excitation ? experiment.excitation->noise_sd
                                     : experiment.responses[c - (experiment.excitation ? 1 : 0)].noise_sd;
        NoiseStream noise(seed, r, c);
        for (double& x : noisy.samples[r].channels[c]) x += sd * noise.gaussian();
      }
  };
  std::vector<Coverage> result;
  std::vector<Estimate> estimates;
  for (int draw = 0; draw < draws; ++draw) {
    SimulatedCampaign noisy = exact;
    add_noise(noisy, static_cast<std::uint64_t>(draw) + 1);
    estimates.push_back(estimate(observed(noisy, model, resonance), "m", {"m/s^2"}, options));
  }
  for (const std::string& name : names) {
    Coverage c;
    c.name = name;
    c.truth = truth_of(model, resonance, experiment.parameters, name);
    double square = 0;
    for (const Estimate& e : estimates) {
      const EstimatedValue& v = value_of(e, name);
      c.mean += *v.value / draws;
      square += *v.value * *v.value / draws;
      c.mean_sd += v.sd / draws;
    }
    c.scatter = std::sqrt(std::max(0.0, square - c.mean * c.mean) * draws / (draws - 1));
    c.bias = c.mean - c.truth;
    for (const Estimate& e : estimates) {
      const EstimatedValue& v = value_of(e, name);
      const Interval interval = confidence_interval(*v.value - c.bias, v.sd, v.degrees_of_freedom);
      c.inside += interval.low <= c.truth && c.truth <= interval.high;
    }
    std::printf("%-10s truth %12.5g  bias %9.2e  sd %9.2e  scatter %9.2e  covered %5.1f %% of %d\n", name.c_str(),
                c.truth, c.bias, c.mean_sd, c.scatter, 100.0 * c.inside / draws, draws);
    result.push_back(c);
  }
  return result;
}

void check(const std::vector<Coverage>& table, int draws) {
  for (const Coverage& c : table) {
    // Binomial with p between 0.93 and 0.97 nominal; four standard deviations of a draw count below 0.93, and the
    // jackknife's bias is upward.
    const double band = 4 * std::sqrt(0.05 * 0.95 / draws);
    EXPECT_GT(static_cast<double>(c.inside) / draws, 0.93 - band) << c.name;
    // Truncation: what is left after the noise is gone is a few percent at most, before it is corrected.
    EXPECT_LT(std::abs(c.bias), 0.2 * std::abs(c.truth) + 5 * c.mean_sd) << c.name;
  }
}

TEST(StatisticalCoverage, PrincipalParametricDwells) {
  Experiment e = shipped_experiment("principal_parametric");
  for (DwellProgramme& d : e.dwells) d.ensembles = 4;
  const int draws = draws_wanted(40);
  check(coverage(e, "principal_parametric", {"omega0", "mu1", "mu2", "mu3", "alpha_e", "eta_e", "eta1"}, draws),
        draws);
}

TEST(StatisticalCoverage, FreeDecay) {
  Experiment e = shipped_experiment("principal_parametric");
  e.dwells.clear();
  FreeDecayProgramme decay;
  decay.initial_displacement = {4e-3};
  decay.initial_velocity = {0};
  decay.duration_s = 12;
  e.free_decays = {decay, decay};
  const int draws = draws_wanted(40);
  check(coverage(e, "free", {"omega0", "mu1", "mu3", "alpha_e"}, draws), draws);
}

}  // namespace
}  // namespace secular
