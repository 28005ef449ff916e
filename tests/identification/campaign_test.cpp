// Campaigns of several cases, and campaigns that something is wrong with.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "estimator/identification/identifiability.hpp"
#include "estimator/regression/linear_fit.hpp"
#include "motion/correction/replay.hpp"
#include "motion/simulate/noise.hpp"
#include "numerics/hertz.hpp"
#include "virtual_campaign.hpp"

namespace secular {
namespace {

using namespace testing_support;
using Eigen::Index;

Experiment few_dwells(std::size_t programmes, std::vector<std::vector<double>> frequencies) {
  Experiment e = shipped_experiment("principal_parametric");
  e.dwells.resize(programmes);
  e.dwells.front().frequencies_hz = std::move(frequencies);
  for (DwellProgramme& d : e.dwells) {
    d.settle_s = 40;
    d.initial_displacement = {1.5e-3};
  }
  return e;
}

struct Tested {
  Experiment experiment;
  const CompiledModel* model;
  SimulatedCampaign simulated;
};

Tested run(const Experiment& experiment) {
  Tested t{experiment, generated::find_compiled_model(experiment.model), {}};
  t.simulated = run_virtual_test(experiment, *t.model, 1, 2);
  return t;
}

ObservationSet parametric(const Tested& t) {
  return observed(t.simulated, *t.model, case_named(*t.model, "principal_parametric"));
}

TEST(BadCampaign, OneConditionGivesNoNumbersMadeOfNoise) {
  const Tested t = run(few_dwells(1, {{24.7}}));
  const ObservationSet set = parametric(t);
  ASSERT_EQ(set.observations.size(), 10U);
  const Estimate result = estimate(set, "kg^(1/2) m", {"m/s^2"}, {});
  // One steady state: two real equations for omega0, mu1, mu2, mu3, alpha_e, eta_e.
  for (const char* name : {"mu1", "mu2", "mu3", "alpha_e", "eta_e"}) {
    const EstimatedValue& v = value_of(result, name);
    EXPECT_FALSE(v.value) << name << " " << v.value.value_or(0) << " sd " << v.sd;
    EXPECT_FALSE(v.identifiable) << name;
  }
  EXPECT_TRUE(warns(result.warnings, "cannot be told apart on 1 condition"));
}

TEST(BadCampaign, ResponseNamedExcitationIsSaid) {
  Tested t = run(few_dwells(1, {{24.7}}));
  std::swap(t.simulated.campaign.channels[0].role, t.simulated.campaign.channels[1].role);
  const ObservationSet set = parametric(t);
  EXPECT_TRUE(set.observations.empty());
  EXPECT_TRUE(warns(set.warnings, "are they swapped?"));
  EXPECT_THROW(estimate(set, "m", {"m/s^2"}, {}), std::exception);
}

TEST(BadCampaign, TrivialBranchAndUnsettledDwellsAreLeftOut) {
  Experiment e = few_dwells(1, {{24.4}, {24.7}});
  e.dwells.front().settle_s = 2;  // from a kick: still decaying, or still growing
  e.dwells.front().carry_state = false;
  const ObservationSet unsettled = parametric(run(e));
  EXPECT_TRUE(unsettled.observations.empty());
  EXPECT_TRUE(warns(unsettled.warnings, "has not settled"));
  e.dwells.front().settle_s = 60;
  e.dwells.front().initial_displacement = {1e-6};
  e.dwells.front().frequencies_hz = {{24.3}};
  const ObservationSet trivial = parametric(run(e));
  EXPECT_TRUE(trivial.observations.empty());
  EXPECT_TRUE(warns(trivial.warnings, "trivial branch"));
}

TEST(BadCampaign, WrongLevelIsSaid) {
  Tested t = run(few_dwells(1, {{24.7}}));
  for (RecordEntry& entry : t.simulated.campaign.records) entry.excitation_amplitude = 10;
  EXPECT_TRUE(warns(parametric(t).warnings, "times the nominal excitation amplitude"));
}

// Of equations whose truncation is not known: what they leave says nothing of the model.
const EstimatePass unjudged{.judge_fit = false};

class Campaign : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { tested_ = new Tested(run(shipped_experiment("principal_parametric"))); }
  static void TearDownTestSuite() {
    delete tested_;
    tested_ = nullptr;
  }
  static Tested* tested_;
};
Tested* Campaign::tested_ = nullptr;
class SlowCampaign : public Campaign {};

TEST_F(SlowCampaign, AnOutlyingEnsembleIsListedAndDoesNoHarm) {
  const ObservationSet clean = parametric(*tested_);
  const Estimate before = estimate(clean, "kg^(1/2) m", {"m/s^2"}, {}, unjudged);
  // The first ensemble of a dwell may still settle; of the others none stands out far.
  for (const OutlyingEnsemble& o : before.outliers)
    if (o.centre_s > 4) {
      EXPECT_GT(o.weight, 0.5) << o.record << ", distance " << o.distance;
    }
  ObservationSet spoilt = clean;
  spoilt.observations[33].amplitude[0] *= 1.06;
  const Estimate after = estimate(spoilt, "kg^(1/2) m", {"m/s^2"}, {}, unjudged);
  ASSERT_FALSE(after.outliers.empty());
  const auto worst = std::min_element(after.outliers.begin(), after.outliers.end(),
                                      [](const auto& a, const auto& b) { return a.weight < b.weight; });
  EXPECT_EQ(worst->record, spoilt.observations[33].record);
  EXPECT_EQ(worst->centre_s, spoilt.observations[33].centre_s);
  EXPECT_LT(worst->weight, 0.05);
  for (const OutlyingEnsemble& o : after.outliers)
    if (&o != &*worst) {
      EXPECT_GT(o.weight, 0.5);
    }
  for (const char* name : {"mu1", "mu3", "alpha_e", "eta_e"})
    EXPECT_NEAR(*value_of(after, name).value, *value_of(before, name).value, 0.5 * value_of(before, name).sd)
        << name;
}

TEST_F(SlowCampaign, DampingLawsAreDecidedByPrediction) {
  const Estimate cubic = estimate(parametric(*tested_), "kg^(1/2) m", {"m/s^2"}, {}, unjudged);
  ASSERT_EQ(cubic.damping.size(), 1U);
  const auto terms = [](const DampingLaw& law) {
    std::string text;
    for (const std::string& t : law.terms) text += t + " ";
    return text;
  };
  // mu2 is zero in truth: the best law has mu1 and mu3, and linear with quadratic damping is worse.
  EXPECT_NE(terms(cubic.damping.front().laws.front()).find("mu1"), std::string::npos);
  EXPECT_NE(terms(cubic.damping.front().laws.front()).find("mu3"), std::string::npos);
  for (const DampingLaw& law : cubic.damping.front().laws)
    if (terms(law) == "mu1 mu2 ") {
      EXPECT_GT(law.worse_by, 2 * law.sd);
    }
}

TEST_F(SlowCampaign, BootstrapAgreesWithTheJackknife) {
  EstimateOptions options;
  options.bootstrap = 300;
  const ObservationSet set = parametric(*tested_);
  const Estimate result = estimate(set, "kg^(1/2) m", {"m/s^2"}, options, unjudged);
  for (const char* name : {"mu1", "mu3", "alpha_e", "eta_e"}) {
    const EstimatedValue& v = value_of(result, name);
    ASSERT_TRUE(v.bootstrap) << name;
    // Nineteen conditions, some of which matter much more than others: a resample leaves out more than a third of
    // them, where the jackknife leaves out one. Both have a relative error of about 1/sqrt(2*18).
    EXPECT_GT(v.bootstrap->sd, 0.4 * v.sd) << name;
    EXPECT_LT(v.bootstrap->sd, 2.5 * v.sd) << name;
    EXPECT_LT(v.bootstrap->low, *v.value);
    EXPECT_GT(v.bootstrap->high, *v.value);
  }
  const Estimate again = estimate(set, "kg^(1/2) m", {"m/s^2"}, options, unjudged);
  EXPECT_EQ(value_of(result, "mu1").bootstrap->low, value_of(again, "mu1").bootstrap->low);
}

ObservationSet without_truncation(const Tested& t, const ObservationSet& set) {
  const ObservationSet replayed = observe_replay(t.simulated.campaign, set, t.experiment.parameters, 2);
  return with_truncation(std::span(&set, 1), std::span(&replayed, 1), t.experiment.parameters).front();
}

TEST_F(SlowCampaign, DwellsAndDecayTogetherAreSharper) {
  Experiment e = shipped_experiment("principal_parametric");
  e.dwells.clear();
  FreeDecayProgramme decay;
  decay.initial_displacement = {4e-3};
  decay.initial_velocity = {0};
  decay.duration_s = 14;
  e.free_decays = {decay, decay, decay, decay};
  const Tested swing = run(e);
  // Without the expansion's truncation: its errors are larger than the noise, and differ from case to case.
  const std::vector<ObservationSet> sets = {
      without_truncation(*tested_, parametric(*tested_)),
      without_truncation(swing, observed(swing.simulated, *swing.model, case_named(*swing.model, "free")))};
  ASSERT_FALSE(sets[1].observations.empty()) << (sets[1].warnings.empty() ? "" : sets[1].warnings.front());
  const MeasuredUnits units{"kg^(1/2) m", {"m/s^2"}};
  const Estimate dwells = estimate(std::span(&sets[0], 1), units, {}, unjudged);
  const Estimate both = estimate(sets, units, {}, unjudged);
  ASSERT_EQ(both.cases.size(), 2U);
  for (const char* name : {"mu1", "mu3"}) {
    const EstimatedValue& v = value_of(both, name);
    ASSERT_TRUE(v.value) << name;
    EXPECT_LT(v.sd, value_of(dwells, name).sd) << name;
    EXPECT_NE(v.from.find("principal_parametric"), std::string::npos) << v.from;
    EXPECT_NE(v.from.find("free"), std::string::npos) << v.from;
  }
  // alpha_e in both cases means the same; a lump of each.
  EXPECT_EQ(std::count_if(both.lumps.begin(), both.lumps.end(), [](const auto& l) { return l.name == "mu1"; }), 2);
}

TEST(Identifiability, NullDirectionsAreReadableAndNameWhatPartsThem) {
  const CompiledModel& model = *generated::find_compiled_model("two_mass_mode1");
  const CompiledCase& resonance = case_named(model, "principal_parametric");
  CampaignKnowledge known;
  known.model = &model;
  known.parameters.assign(model.symbols.size(), false);
  known.parameters[0] = true;
  known.cases = {{&resonance, std::vector<bool>(resonance.lumps.size(), false)}};
  for (std::size_t l = 0; l < resonance.lumps.size(); ++l)  // modulation equation and the harmonic at Omega
    for (const char* seen : {"mu1", "mu2", "mu3", "alpha_e", "eta_e", "eta1", "alpha_q"})
      if (resonance.lumps[l].name == seen) known.cases[0].lumps[l] = true;
  const std::vector<NullDirection> directions = null_directions(known);
  // alpha2, delta2, alpha3, delta3 are four unknowns in alpha_e and alpha_q.
  ASSERT_EQ(directions.size(), 2U);
  bool exact = false, zero = false;
  for (const NullDirection& d : directions) {
    exact = exact || d.text.find("omega0^2") != std::string::npos;
    for (const std::string& test : d.parted_by) zero = zero || test.find("zero-frequency") != std::string::npos;
  }
  EXPECT_TRUE(exact) << directions[0].text << "\n" << directions[1].text;
  EXPECT_TRUE(zero);
}

// Replicates of one condition differ by noise only: a second column is not seen, however different from rounding.
TEST(LinearFit, ColumnsMadeOfNoiseAreNotIdentifiable) {
  NoiseStream noise(1, 1, 1);
  constexpr Index rows = 20;
  constexpr double sd = 1e-3;
  Eigen::MatrixXd design(rows, 2);
  Eigen::VectorXd response(rows);
  std::vector<int> cluster;
  for (Index i = 0; i < rows; ++i) {
    design.row(i) << 1 + sd * noise.gaussian(), 2 + sd * noise.gaussian();
    response(i) = 1 + sd * noise.gaussian();
    cluster.push_back(static_cast<int>(i / 5));
  }
  const Eigen::MatrixXd column_noise = rows * sd * sd * Eigen::Matrix2d::Identity();
  EXPECT_EQ(linear_fit(design, response, cluster).rank, 2);
  const LinearFit fit = linear_fit(design, response, cluster, {column_noise, {}});
  EXPECT_FALSE(fit.identifiable[0] || fit.identifiable[1]);
}

// Noise leads the circular-hyperbolic decomposition astray in some of the ensembles; the frequency that was asked
// for does not.
TEST(Observation, AnExcitationInNoiseOfHalfItsSizeIsFound) {
  Experiment e = shipped_experiment("principal_parametric");
  e.excitations.front().noise_sd = 8;
  const CompiledModel& model = *generated::find_compiled_model("two_mass_mode1");
  const SimulatedCampaign simulated = run_virtual_test(e, model, 1, 2);
  const ObservationSet set = observed(simulated, model, case_named(model, "principal_parametric"));
  ASSERT_FALSE(set.observations.empty());
  for (const Observation& o : set.observations) {
    const double nominal = two_pi * *simulated.campaign.records[o.record].excitation_frequency_hz;
    EXPECT_LT(std::abs(o.excitation_frequency[0] - nominal), 6 * o.excitation_frequency_sd[0]) << o.record;
  }
}

}  // namespace
}  // namespace secular
