// What windows of a decay that overlap do to error bars, against the scatter over draws.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "estimator/identification/case_regression.hpp"
#include "numerics/confidence.hpp"
#include "recovered_campaign.hpp"

namespace secular {
namespace {

using namespace testing_support;
using Eigen::Index;
using Eigen::VectorXd;

// Decays of a spring of third degree at 5 Hz: 3 % of the frequency by the amplitude, one half of a percent damping.
Experiment decays_of_a_spring(int count, double noise_sd) {
  Experiment e = shipped_experiment("linear_impulse_response");
  const CompiledModel& model = *generated::find_compiled_model(e.model);
  const double omega0 = 10 * std::numbers::pi;
  const auto set = [&](const char* name, double value) {
    e.parameters(static_cast<Index>(*place_of(model.symbols, name))) = value;
  };
  set("omega0", omega0);
  set("mu", 0.005 * omega0);
  set("a2", 0.05 * omega0 * omega0);
  set("a3", 0.08 * omega0 * omega0);
  set("e", 0);
  e.sample_rate_hz = 200;
  e.free_decays.clear();
  for (int i = 0; i < count; ++i) {
    FreeDecayProgramme decay;
    decay.initial_displacement = {1 - 0.08 * i};
    decay.initial_velocity = {0};
    decay.duration_s = 20;
    e.free_decays.push_back(decay);
  }
  for (SimulatedChannel& channel : e.responses) channel.noise_sd = noise_sd;
  return e;
}

SimulatedCampaign drawn(const SimulatedCampaign& exact, const Experiment& e, std::uint64_t seed) {
  SimulatedCampaign noisy = exact;
  for (std::size_t r = 0; r < noisy.samples.size(); ++r)
    noisy.samples[r] = with_sensor_noise(std::move(noisy.samples[r]), e, seed, r);
  return noisy;
}

// Coefficients scatter over draws as correlations of windows say, at the measured noise, and not as windows do that
// are independent.
TEST(StatisticalWindowOverlap, CoefficientsScatterAsCorrelationsSay) {
  const Experiment e = decays_of_a_spring(1, 7e-3);
  const CompiledModel& model = *generated::find_compiled_model(e.model);
  const CompiledCase& resonance = case_named(model, "free");
  const SimulatedCampaign exact = run_virtual_test(without_noise(e), model, 1, 2);
  std::vector<std::size_t> blocks;
  for (std::size_t b = 0; b < resonance.blocks.size(); ++b)
    if (resonance.blocks[b].kind == BlockKind::modulation || resonance.blocks[b].order <= 1) blocks.push_back(b);
  CaseKnowledge known;
  known.natural_frequency = {e.parameters(0)};
  const int draws = 400;
  VectorXd sum, squares, told, independent;
  double repeats = 0, freedom = 0;
  for (int draw = 1; draw <= draws; ++draw) {
    const SimulatedCampaign noisy = drawn(exact, e, static_cast<std::uint64_t>(draw));
    const ObservationSet set = observed(noisy, model, resonance);
    const ObservationSet replayed = observe_replay(noisy.campaign, set, e.parameters, 1);
    const std::vector<ObservationSet> corrected =
        with_truncation(std::span(&set, 1), std::span(&replayed, 1), e.parameters);
    const CaseFit fit = fit_case(corrected.front(), blocks, known);
    if (draw == 1) sum = squares = told = independent = VectorXd::Zero(fit.fit.coefficients.size());
    sum += fit.fit.coefficients / draws;
    squares += fit.fit.coefficients.cwiseAbs2() / draws;
    const Eigen::MatrixXd& basis = fit.fit.basis;
    told += (basis * fit.overlap.gram * basis.transpose()).diagonal() / draws;
    independent += (basis * basis.transpose()).diagonal() / draws;
    repeats += fit.overlap.repeats / draws;
    freedom += fit.overlap.repeats * fit.overlap.repeats / fit.overlap.repeats_squared / draws;
  }
  const VectorXd scatter = squares - sum.cwiseAbs2();
  double most = 0, least = INFINITY;
  for (Index c = 0; c < scatter.size(); ++c) {
    // Of a variance from so many draws 0.07.
    EXPECT_NEAR(told(c) / scatter(c), 1, 0.28) << c;
    most = std::max(most, independent(c) / scatter(c));
    least = std::min(least, independent(c) / scatter(c));
  }
  EXPECT_GT(most, 1.4);
  EXPECT_LT(least, 0.8);
  EXPECT_LT(freedom, repeats);
}

// Intervals of one decay and of two hold, and are no wider than the scatter makes them.
TEST(StatisticalWindowOverlap, IntervalsOfDecaysHoldAndAreNoWider) {
  for (const int decays : {1, 2}) {
    const Experiment e = decays_of_a_spring(decays, 7e-3);
    const CompiledModel& model = *generated::find_compiled_model(e.model);
    const SimulatedCampaign exact = run_virtual_test(without_noise(e), model, 1, 2);
    const int draws = number_from("SECULAR_COVERAGE_DRAWS", 200);
    EstimateOptions options;
    options.damping_laws = false;
    std::map<std::string, std::vector<EstimatedValue>> found;
    for (int draw = 1; draw <= draws; ++draw) {
      const Recovered r = recover(
          {e, &model, &case_named(model, "free"), drawn(exact, e, static_cast<std::uint64_t>(draw))}, options);
      for (const char* name : {"omega0", "mu", "a2", "a3"}) found[name].push_back(r.value(name));
    }
    for (const auto& [name, values] : found) {
      const double truth = truth_of(model, case_named(model, "free"), e.parameters, name);
      double mean = 0, square = 0, inside = 0;
      std::vector<double> sds;
      for (const EstimatedValue& v : values) {
        mean += *v.value / draws;
        square += *v.value * *v.value / draws;
        const Interval interval = confidence_interval(*v.value, v.sd, v.degrees_of_freedom);
        if (interval.low <= truth && truth <= interval.high) inside += 1.0 / draws;
        sds.push_back(v.sd);
      }
      std::nth_element(sds.begin(), sds.begin() + draws / 2, sds.end());
      const double median = sds[static_cast<std::size_t>(draws / 2)], scatter = std::sqrt(square - mean * mean);
      std::printf("%d decays, %s: covered %.3f, median sd over scatter %.2f\n", decays, name.c_str(), inside,
                  median / scatter);
      EXPECT_GT(inside, 0.93 - 3 * std::sqrt(0.05 * 0.95 / draws)) << decays << " " << name;
      EXPECT_NEAR(median / scatter, 1, 0.17) << decays << " " << name;
    }
  }
}

}  // namespace
}  // namespace secular
