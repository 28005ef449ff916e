// Records whose responses are late against the excitation, on observations whose truth is known exactly.
#include "estimator/identification/record_lateness.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "modulation_observations.hpp"
#include "numerics/confidence.hpp"
#include "virtual_campaign.hpp"

namespace secular {
namespace {

using namespace testing_support;

const MeasuredUnits units{"kg^(1/2) m", {"m/s^2"}};

Estimate estimate_of(const ObservationSet& set) {
  EstimateOptions options;
  options.damping_laws = false;
  return estimate(std::span(&set, 1), units, options);
}

// By record: how late the responses are made, in seconds.
std::vector<double> uniform_lateness(const OneMode& truth, double most_s, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<double> late;
  for (int c = 0; c < truth.conditions; ++c) late.push_back(most_s * static_cast<double>(random() >> 11) * 0x1p-53);
  return late;
}

// The excitation looks ahead of responses that are late.
ObservationSet with_lateness(ObservationSet set, const std::vector<double>& late) {
  for (Observation& o : set.observations)
    for (std::size_t j = 0; j < o.forcing.size(); ++j)
      o.forcing[j] *= std::polar(1.0, o.excitation_frequency[j] * late[o.record]);
  return set;
}

UnknownPhases phases_of(const ObservationSet& set, const Estimate& so_far) {
  return find_unknown_phases(std::span(&set, 1), units, {}, so_far);
}

double period(const ObservationSet& set) {
  return 2 * std::numbers::pi / set.observations.front().excitation_frequency.front();
}

// Over many draws, of lateness small against the period, all over it, and the same in all records.
struct Kind {
  const char* name;
  double share;  // of the period
  bool same;
};

class Lateness : public ::testing::TestWithParam<Kind> {};

TEST_P(Lateness, IsFoundAndIntervalsHold) {
  const Kind kind = GetParam();
  OneMode truth;
  truth.ensembles = 4;
  constexpr int draws = 25;
  const std::map<std::string, double> values{{"mu1", truth.mu1}, {"mu3", truth.mu3}, {"eta_e", truth.eta_e}};
  int intervals = 0, held = 0;
  for (int draw = 1; draw <= draws; ++draw) {
    const ObservationSet in_step = truth.set(static_cast<std::uint64_t>(draw));
    std::vector<double> late =
        uniform_lateness(truth, kind.share * period(in_step), static_cast<std::uint64_t>(100 + draw));
    if (kind.same) late.assign(late.size(), 0.5 * kind.share * period(in_step));
    const ObservationSet measured = with_lateness(in_step, late);
    const UnknownPhases found = phases_of(measured, estimate_of(measured));
    ASSERT_EQ(found.cases.size(), 1U) << kind.name << ", draw " << draw;
    ASSERT_EQ(found.cases.front().finding, PhaseFinding::late) << kind.name << ", draw " << draw;
    const CaseLateness& what = found.cases.front();
    ASSERT_EQ(what.records.size(), late.size());
    // Up to half a period, common to all, where the sign of the excitation is not told.
    const double turn = what.assumed_positive.empty()
                            ? 0
                            : std::round(2 * (what.records[0].late_s - late[0]) / period(in_step)) / 2;
    for (std::size_t r = 0; r < late.size(); ++r)
      EXPECT_NEAR(std::remainder(what.records[r].late_s - late[r] - turn * period(in_step), period(in_step)), 0,
                  0.02 * period(in_step))
          << kind.name << ", draw " << draw << ", record " << r;
    // What is assumed has a rival of the other sign.
    ASSERT_EQ(found.rivals.empty(), what.assumed_positive.empty()) << kind.name << ", draw " << draw;
    for (const UnknownPhases::Rival& rival : found.rivals) {
      EXPECT_LT(*value_of(estimate_of(rival.set), "eta_e").value, 0) << kind.name << ", draw " << draw;
    }
    const Estimate result = estimate_of(found.sets.front());
    for (const auto& [name, value] : values) {
      const EstimatedValue& v = value_of(result, name);
      ASSERT_TRUE(v.value) << name;
      const Interval interval = confidence_interval(*v.value, v.sd, v.degrees_of_freedom);
      ++intervals;
      held += interval.low <= value && value <= interval.high;
      EXPECT_LT(std::abs(*v.value - value), 6 * v.sd) << name << ", draw " << draw;
    }
    for (const CaseLackOfFit& tests : result.lack_of_fit)
      for (const LackOfFit& test : tests.equations)
        EXPECT_FALSE(test.significant) << test.name << test.misfit_ratio;
  }
  EXPECT_GE(held, 0.95 * intervals - 3 * std::sqrt(0.05 * 0.95 * intervals * static_cast<double>(values.size())));
}

INSTANTIATE_TEST_SUITE_P(RecordLateness, Lateness,
                         ::testing::Values(Kind{"small", 0.1, false}, Kind{"half a period", 0.5, false},
                                           Kind{"a whole period", 1.0, false}, Kind{"in all records", 0.3, true}),
                         [](const auto& tested) {
                           std::string name = tested.param.name;
                           std::replace(name.begin(), name.end(), ' ', '_');
                           return name;
                         });

// With nothing said of the fit the test decides: its p-value is uniform where records are in step.
TEST(RecordLateness, IsNotFoundInRecordsInStep) {
  OneMode truth;
  truth.ensembles = 4;
  for (int draw = 1; draw <= 25; ++draw) {
    const ObservationSet in_step = truth.set(static_cast<std::uint64_t>(draw));
    Estimate unjudged = estimate_of(in_step);
    EXPECT_TRUE(phases_of(in_step, unjudged).cases.empty());
    unjudged.lack_of_fit.clear();
    EXPECT_TRUE(phases_of(in_step, unjudged).cases.empty()) << draw;
  }
}

// A law that the model lacks misfits as well, but not in the phases alone.
TEST(RecordLateness, IsNotFoundForADampingLawThatIsMissing) {
  OneMode truth;
  truth.mu2 = 6;
  for (int draw = 1; draw <= 5; ++draw) {
    const ObservationSet set = truth.set(static_cast<std::uint64_t>(draw));
    EstimateOptions without;
    without.fixed = {{"mu2", 0}};
    without.damping_laws = false;
    const Estimate so_far = estimate(std::span(&set, 1), units, without);
    EXPECT_TRUE(find_unknown_phases(std::span(&set, 1), units, without, so_far).cases.empty()) << draw;
  }
}

// Dwells that stand still, as measured ones do: within `spread` radians of phase resonance, the force as large as
// the damping needs. `quintic`: of a stiffness that the model lacks, in the balance of frequency.
ObservationSet steady(const OneMode& truth, double spread, double quintic, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  ObservationSet set = truth.set(seed);
  set.observations.clear();
  for (int c = 0; c < truth.conditions; ++c) {
    const double peak = 0.8e-3 + truth.peak_spread * c / (truth.conditions - 1), b = 0.5 * peak;
    const double damping = truth.mu1 + 1.5 * truth.mu3 * w0 * w0 * b * b;
    const double away = spread * (2 * static_cast<double>(random() >> 11) * 0x1p-53 - 1);
    const double force = damping * w0 / truth.eta_e / std::cos(away);
    for (int e = 0; e < truth.ensembles; ++e) {
      const double instant = 2.3 * e + 0.7 * c;
      Observation o = truth.exact(c, peak, force, 0.5 * (away - std::numbers::pi / 2), instant);
      o.rate[0] += std::complex<double>(0, quintic * b * b * b * b);
      o.excitation_frequency[0] = 2 * o.rate[0].imag();
      o.centre_s = e;
      NoiseStream noise(seed, static_cast<std::uint64_t>(c), static_cast<std::uint64_t>(e));
      const std::complex<double> turn = std::polar(1.0, instant);
      o.amplitude[0] += truth.amplitude_sd * std::complex<double>(noise.gaussian(), noise.gaussian()) * turn;
      o.forcing[0] += truth.forcing_sd * std::complex<double>(noise.gaussian(), noise.gaussian()) * turn * turn;
      o.rate[0] += o.growth_sd[0] * noise.gaussian();
      set.observations.push_back(std::move(o));
    }
  }
  return set;
}

EstimateOptions without_drag() {
  EstimateOptions options;
  options.fixed = {{"mu2", 0}};
  options.damping_laws = false;
  return options;
}

// A stiffness that the model lacks changes phases near resonance as much as a late record does.
TEST(RecordLateness, IsNotFoundForAStiffnessThatIsMissing) {
  OneMode truth;
  truth.ensembles = 4;
  const EstimateOptions options = without_drag();
  for (const double spread : {0.1, 0.2, 0.4, 0.8})
    for (const double quintic : {2e10, 1e11})
      for (std::uint64_t draw = 1; draw <= 4; ++draw) {
        const ObservationSet set = steady(truth, spread, quintic, draw);
        const Estimate so_far = estimate(std::span(&set, 1), units, options);
        const UnknownPhases found = find_unknown_phases(std::span(&set, 1), units, options, so_far);
        for (const CaseLateness& one : found.cases) {
          EXPECT_NE(one.finding, PhaseFinding::late) << spread << ", " << quintic << ", draw " << draw;
          // What it is compared with has to differ from it.
          EXPECT_EQ(found.sets.front().phase_unknown, one.finding == PhaseFinding::like_a_law);
        }
      }
}

// Away from phase resonance amplitudes tell damping and force; at it nothing does, and that is said.
TEST(RecordLateness, IsFoundOrSaidWhereverDwellsStand) {
  OneMode truth;
  truth.ensembles = 4;
  const EstimateOptions options = without_drag();
  for (const double spread : {0.01, 0.4, 1.2})
    for (std::uint64_t draw = 1; draw <= 6; ++draw) {
      const ObservationSet in_step = steady(truth, spread, 0, draw);
      const ObservationSet measured =
          with_lateness(in_step, uniform_lateness(truth, 0.3 * period(in_step), 50 + draw));
      const Estimate so_far = estimate(std::span(&measured, 1), units, options);
      const UnknownPhases found = find_unknown_phases(std::span(&measured, 1), units, options, so_far);
      if (spread < 0.1) {
        for (const CaseLateness& one : found.cases) EXPECT_NE(one.finding, PhaseFinding::late) << draw;
        if (found.cases.empty()) {
          EXPECT_TRUE(value_of(so_far, "mu1").doubtful) << draw;
          EXPECT_TRUE(value_of(so_far, "eta_e").doubtful) << draw;
        }
        continue;
      }
      ASSERT_EQ(found.cases.size(), 1U) << spread << ", draw " << draw;
      EXPECT_EQ(found.cases.front().finding, PhaseFinding::late) << spread << ", draw " << draw;
      EXPECT_EQ(found.cases.front().records.size(), static_cast<std::size_t>(truth.conditions));
      const Estimate result = estimate(found.sets, units, options);
      for (const auto& [name, value] :
           {std::pair{"mu1", truth.mu1}, std::pair{"mu3", truth.mu3}, std::pair{"eta_e", truth.eta_e}})
        if (const EstimatedValue& v = value_of(result, name); v.value) {
          EXPECT_LT(std::abs(*v.value - value), 6 * v.sd) << name << ", " << spread << ", draw " << draw;
        }
    }
}

// Numbers with unknown phases do not depend on what the phases were.
TEST(RecordLateness, EstimatesDoNotDependOnIt) {
  const OneMode truth;
  const ObservationSet in_step = truth.set(7);
  std::vector<Estimate> results;
  for (const std::uint64_t seed : {std::uint64_t{1}, std::uint64_t{2}}) {
    const ObservationSet measured = with_lateness(in_step, uniform_lateness(truth, 0.4 * period(in_step), seed));
    const UnknownPhases found = phases_of(measured, estimate_of(measured));
    ASSERT_EQ(found.cases.size(), 1U);
    results.push_back(estimate_of(found.sets.front()));
  }
  for (const char* name : {"omega0", "mu1", "mu3", "alpha_e"}) {
    const EstimatedValue &a = value_of(results[0], name), &b = value_of(results[1], name);
    EXPECT_NEAR(*a.value, *b.value, 0.05 * a.sd) << name;
    EXPECT_NEAR(a.sd, b.sd, 0.05 * a.sd) << name;
  }
}

}  // namespace
}  // namespace secular
