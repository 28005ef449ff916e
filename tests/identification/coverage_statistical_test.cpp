// Coverage of the 95 % intervals: the full equations are integrated once, noise is drawn many times, everything
// after it (observation, regression, error bars) is done again for every draw. Set SECULAR_COVERAGE_DRAWS for the
// table with more draws.
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "motion/correction/replay.hpp"
#include "motion/simulate/noise.hpp"
#include "numerics/confidence.hpp"
#include "numerics/distribution.hpp"
#include "virtual_campaign.hpp"

namespace secular {
namespace {

using namespace testing_support;

int draws_wanted(int fallback) {
  return number_from("SECULAR_COVERAGE_DRAWS", fallback);
}

struct Coverage {
  std::string name;
  int inside = 0;  ///< draws whose interval holds the truth
  double bias = 0, truncation = 0, truth = 0, mean_sd = 0, scatter = 0, mean = 0;
};

// Errors of two parameters go together over the draws as their covariance says: Fisher's transformation of a
// correlation from n draws has standard deviation 1/sqrt(n - 3), whatever the correlation.
void check_correlations(const std::vector<Estimate>& estimates, const std::vector<std::string>& names) {
  const auto draws = static_cast<double>(estimates.size());
  const auto place = [&](const std::string& name) {
    const std::vector<EstimatedValue>& all = estimates.front().parameters;
    return std::find_if(all.begin(), all.end(), [&](const EstimatedValue& v) { return v.name == name; }) -
           all.begin();
  };
  const auto parameters = static_cast<Eigen::Index>(estimates.front().parameters.size());
  for (std::size_t a = 0; a < names.size(); ++a)
    for (std::size_t b = a + 1; b < names.size(); ++b) {
      const Eigen::Index i = place(names[a]), j = place(names[b]);
      if (i == parameters || j == parameters) continue;  // a lump that is no parameter
      Eigen::MatrixX2d values(estimates.size(), 2);
      double told = 0;
      for (std::size_t e = 0; e < estimates.size(); ++e) {
        const Estimate& one = estimates[e];
        values.row(static_cast<Eigen::Index>(e)) << *one.parameters[static_cast<std::size_t>(i)].value,
            *one.parameters[static_cast<std::size_t>(j)].value;
        told += one.covariance(i, j) / std::sqrt(one.covariance(i, i) * one.covariance(j, j)) / draws;
      }
      const Eigen::MatrixX2d about = values.rowwise() - values.colwise().mean();
      const double seen = about.col(0).dot(about.col(1)) / (about.col(0).norm() * about.col(1).norm());
      std::printf("%s, %s: correlation %.2f, told %.2f\n", names[a].c_str(), names[b].c_str(), seen, told);
      EXPECT_NEAR(std::atanh(seen), std::atanh(told), 4 / std::sqrt(draws - 3)) << names[a] << ", " << names[b];
    }
}

// One case in a thousand whose equations hold is said to lack something.
void check_that_equations_hold(const std::vector<Estimate>& estimates) {
  int alarms = 0;
  for (const Estimate& e : estimates) {
    ASSERT_FALSE(e.lack_of_fit.empty());
    const std::vector<LackOfFit>& tests = e.lack_of_fit.front().equations;
    EXPECT_GE(tests.size(), 2U);
    alarms += std::any_of(tests.begin(), tests.end(), [](const LackOfFit& test) { return test.significant; });
  }
  EXPECT_GT(binomial_upper_tail(alarms, static_cast<double>(estimates.size()), 0.001), 1e-4) << alarms;
}

// How often the interval contains the truth, the expansion's truncation taken out as `identify` does it, with the
// full equations at the true parameters: what is left is statistics. The truncation is listed by itself.
std::vector<Coverage> coverage(const Experiment& experiment, const std::string& case_name,
                               const std::vector<std::string>& names, int draws) {
  const CompiledModel& model = *generated::find_compiled_model(experiment.model);
  const CompiledCase& resonance = case_named(model, case_name);
  const SimulatedCampaign exact = run_virtual_test(without_noise(experiment), model, 1, 2);
  EstimateOptions options;
  options.damping_laws = false;
  options.refine = std::getenv("SECULAR_COVERAGE_REFINE") != nullptr;
  const auto add_noise = [&](SimulatedCampaign& noisy, std::uint64_t seed) {
    for (std::size_t r = 0; r < noisy.samples.size(); ++r)
      noisy.samples[r] = with_sensor_noise(std::move(noisy.samples[r]), experiment, seed, r);
  };
  std::vector<Coverage> result;
  const ObservationSet clean = observed(exact, model, resonance);
  const Estimate truncated = estimate(clean, "m", {"m/s^2"}, options);
  std::vector<Estimate> estimates;
  for (int draw = 0; draw < draws; ++draw) {
    SimulatedCampaign noisy = exact;
    add_noise(noisy, static_cast<std::uint64_t>(draw) + 1);
    const ObservationSet set = observed(noisy, model, resonance);
    const ObservationSet replayed = observe_replay(exact.campaign, set, experiment.parameters, 2);
    const std::vector<ObservationSet> corrected =
        with_truncation(std::span(&set, 1), std::span(&replayed, 1), experiment.parameters);
    estimates.push_back(estimate(corrected, {"m", {"m/s^2"}}, options));
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
    c.truncation = *value_of(truncated, name).value - c.truth;
    for (const Estimate& e : estimates) {
      const EstimatedValue& v = value_of(e, name);
      const Interval interval = confidence_interval(*v.value, v.sd, v.degrees_of_freedom);
      c.inside += interval.low <= c.truth && c.truth <= interval.high;
    }
    std::printf(
        "%-8s truth %12.5g  truncation taken out %9.2e  bias left %9.2e  sd %9.2e  scatter %9.2e  covered %5.1f %% "
        "of %d\n",
        name.c_str(), c.truth, c.truncation, c.bias, c.mean_sd, c.scatter, 100.0 * c.inside / draws, draws);
    result.push_back(c);
  }
  check_correlations(estimates, names);
  check_that_equations_hold(estimates);
  return result;
}

// Binomial with p between 0.93 and 0.97 nominal; four standard deviations of a draw count below 0.93, and the
// jackknife's bias is upward.
double lowest_share(int draws) {
  return 0.93 - 4 * std::sqrt(0.05 * 0.95 / draws);
}

TEST(StatisticalCoverage, PrincipalParametricDwells) {
  Experiment e = shipped_experiment("principal_parametric");
  for (DwellProgramme& d : e.dwells) d.ensembles = 4;
  const int draws = draws_wanted(40);
  for (const Coverage& c :
       coverage(e, "principal_parametric", {"omega0", "mu1", "mu2", "mu3", "alpha_e", "eta_e", "eta1"}, draws)) {
    EXPECT_GT(static_cast<double>(c.inside) / draws, lowest_share(draws)) << c.name;
    // Of what truncation does to the estimate, next to nothing is left.
    EXPECT_LT(std::abs(c.bias), 0.2 * std::abs(c.truncation) + 5 * c.scatter / std::sqrt(draws) + 0.5 * c.mean_sd)
        << c.name;
  }
}

Experiment two_decays() {
  Experiment e = shipped_experiment("principal_parametric");
  e.dwells.clear();
  FreeDecayProgramme decay;
  decay.initial_displacement = {4e-3};
  decay.initial_velocity = {0};
  decay.duration_s = 12;
  e.free_decays = {decay, decay};
  return e;
}

TEST(StatisticalCoverage, FreeDecay) {
  const Experiment e = two_decays();
  const int draws = draws_wanted(40);
  for (const Coverage& c : coverage(e, "free", {"omega0", "mu1", "mu3", "alpha_e"}, draws)) {
    EXPECT_GT(static_cast<double>(c.inside) / draws, lowest_share(draws)) << c.name;
    EXPECT_LT(std::abs(c.bias), 0.2 * std::abs(c.truncation) + 5 * c.scatter / std::sqrt(draws)) << c.name;
  }
}

// A decay that is taken for one of a linear damping: windows that follow one another agree with each other and not
// with the model, and what rests on the equation that lacks something is no confident number.
TEST(LackOfFitOfDecays, ALawThatIsMissingIsTold) {
  const Experiment e = two_decays();
  const CompiledModel& model = *generated::find_compiled_model(e.model);
  const ObservationSet set = observed(run_virtual_test(e, model, 1, 2), model, case_named(model, "free"));
  const ObservationSet replayed =
      observe_replay(run_virtual_test(without_noise(e), model, 1, 2).campaign, set, e.parameters, 2);
  const std::vector<ObservationSet> corrected =
      with_truncation(std::span(&set, 1), std::span(&replayed, 1), e.parameters);
  const auto without = [&](const std::map<std::string, double>& fixed) {
    EstimateOptions options;
    options.damping_laws = false;
    options.fixed = fixed;
    return estimate(corrected, {"m", {"m/s^2"}}, options);
  };
  const auto says = [](const Estimate& estimate, const char* balance) {
    return std::any_of(
        estimate.lack_of_fit.front().equations.begin(), estimate.lack_of_fit.front().equations.end(),
        [&](const LackOfFit& test) { return test.significant && test.name.find(balance) != std::string::npos; });
  };
  const auto off_by = [&](const Estimate& estimate, const char* name) {  // in its standard deviations
    const EstimatedValue& value = value_of(estimate, name);
    return std::abs(*value.value - truth_of(model, case_named(model, "free"), e.parameters, name)) / value.sd;
  };
  const Estimate linear_damping = without({{"mu2", 0}, {"mu3", 0}});
  EXPECT_TRUE(says(linear_damping, "balance of energy"));
  EXPECT_FALSE(says(linear_damping, "balance of frequency"));
  EXPECT_TRUE(value_of(linear_damping, "mu1").doubtful);
  EXPECT_LT(off_by(linear_damping, "omega0"), 4);
}

}  // namespace
}  // namespace secular
