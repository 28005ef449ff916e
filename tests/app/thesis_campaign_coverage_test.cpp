// The thesis's campaigns with the models that they were made with, from samples to error bars, in several noise
// draws: the full equations are integrated once, everything after the noise is done again. SECULAR_COVERAGE_DRAWS
// asks for more draws than the few of a test run and for the table of how often each interval holds the truth,
// SECULAR_COVERAGE_FIRST for those from this one on, SECULAR_COVERAGE_FIXED=delta31,delta33 gives the
// identification these true values, SECULAR_COVERAGE_REFINE asks for maximum likelihood,
// SECULAR_COVERAGE_STRUCTURES for as many structures that differ in the null space, SECULAR_COVERAGE_PROCEDURES
// for as many draws of the source's procedures.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/procedure/thesis_procedures.hpp"
#include "estimator/model/by_name.hpp"
#include "jobs/identify/identification.hpp"
#include "jobs/shared/model_loading.hpp"
#include "motion/correction/observation_noise.hpp"
#include "motion/correction/steady_set.hpp"
#include "numerics/confidence.hpp"
#include "tests/identification/continuity.hpp"
#include "tests/identification/virtual_campaign.hpp"
#include "tests/sensor_noise.hpp"

namespace secular::app {
namespace {

using testing_support::number_from;

// One of them as it would be measured without noise.
class ThesisCampaign {
 public:
  static const ThesisCampaign& chapter_five() {
    static const ThesisCampaign campaign("thesis_chapter5", "principal_parametric");
    return campaign;
  }
  static const ThesisCampaign& chapter_six() {
    static const ThesisCampaign campaign("thesis_chapter6", "additive_combination");
    return campaign;
  }

  Estimate identified(int draw, const std::map<std::string, double>& fixed = {}) const {
    return identification(draw, fixed).estimate;
  }
  Identification identification(int draw, const std::map<std::string, double>& fixed = {}) const {
    IdentificationRequest asked = request();
    asked.fixed = fixed;
    if (draw != 0 || !fixed.empty()) return identify_by_modulation(asked, exact_.campaign, reader(draw));
    // The first draw is what most tests look at.
    if (!first_) first_ = identify_by_modulation(asked, exact_.campaign, reader(draw));
    return *first_;
  }
  Estimate identified_with_jitter(int draw) const {
    const RecordReader read = reader(draw);
    const RecordReader moved = [&](std::size_t r) { return testing_support::jittered(read(r), r); };
    return identify_by_modulation(request(), exact_.campaign, moved).estimate;
  }
  ProcedureRun procedures(int draw) const {
    ProcedureRequest asked;
    asked.campaign = experiment_.name;
    asked.model = experiment_.model;
    asked.truth = "experiments/" + experiment_.name;
    asked.methods = {"saddle_node", "harmonic", "frequency_response", "two_modes"};
    asked.threads = 2;
    return run_procedures(asked, exact_.campaign, reader(draw));
  }
  /// Every method, without the bias that is seen on motions of the full equations.
  ProcedureRun procedures_as_printed() const {
    ProcedureRequest asked;
    asked.campaign = experiment_.name;
    asked.model = experiment_.model;
    asked.truth = "experiments/" + experiment_.name;
    asked.bias = false;
    asked.threads = 2;
    return run_procedures(asked, exact_.campaign, reader(0));
  }
  IdentificationRequest request() const {
    IdentificationRequest request;
    request.model = experiment_.model;
    request.threads = 2;
    request.refine = std::getenv("SECULAR_COVERAGE_REFINE") != nullptr;
    return request;
  }
  const Eigen::VectorXd& parameters() const { return experiment_.parameters; }

  std::map<std::string, double> truth() const {
    std::map<std::string, double> values;
    for (std::size_t p = 0; p < model_->symbols.size(); ++p)
      values[std::string(model_->symbols[p].name)] = experiment_.parameters(static_cast<Eigen::Index>(p));
    return values;
  }
  std::map<std::string, double> true_values(const std::vector<std::string>& names) const {
    std::map<std::string, double> values;
    for (const std::string& name : names) values[name] = truth().at(name);
    return values;
  }

 private:
  ThesisCampaign(const std::string& name, const std::string& resonance)
      : experiment_(testing_support::shipped_experiment(name)),
        model_(ModelSource(experiment_.model, false, {}).load({resonance})) {
    Experiment quiet = testing_support::without_noise(experiment_);
    // Twenty minutes of settling take half as many steps so, and samples move by 3e-9 of the largest, less than a
    // millionth of the noise.
    quiet.motion.relative_tolerance *= 100;
    quiet.motion.absolute_tolerance *= 100;
    exact_ = run_virtual_test(quiet, *model_, 1, 2);
  }

  RecordReader reader(int draw) const {
    return [this, draw](std::size_t r) {
      return testing_support::with_sensor_noise(exact_.samples[r], experiment_,
                                                static_cast<std::uint64_t>(draw) + 1, r);
    };
  }

  Experiment experiment_;
  std::shared_ptr<const CompiledModel> model_;
  SimulatedCampaign exact_;
  mutable std::optional<Identification> first_;
};

struct Coverage {
  int inside = 0, count = 0;
  double error = 0, square = 0, sd = 0;

  bool add(const EstimatedValue& v, double truth) { return add(*v.value, v.sd, v.degrees_of_freedom, truth); }
  bool add(double value, double value_sd, double degrees_of_freedom, double truth) {
    const double off = value - truth;
    const Interval interval = confidence_interval(value, value_sd, degrees_of_freedom);
    const bool holds = interval.low <= truth && truth <= interval.high;
    inside += holds;
    error += off;
    square += off * off;
    sd += value_sd;
    ++count;
    return holds;
  }
};

void print(const std::map<std::string, Coverage>& table) {
  for (const auto& [name, c] : table)
    std::printf("%-40s bias %10.3e  scatter %9.3e  mean sd %9.3e  covered %5.1f %% of %d\n", name.c_str(),
                c.error / c.count, std::sqrt(std::max(0.0, c.square / c.count - std::pow(c.error / c.count, 2))),
                c.sd / c.count, 100.0 * c.inside / c.count, c.count);
}

// No draw is contradicted by its lumps or doubts a number, and none is far from the truth. Mean degrees of freedom
// of the lumps against one another.
double expect_intervals_to_hold(const ThesisCampaign& campaign) {
  const bool many = std::getenv("SECULAR_COVERAGE_DRAWS") != nullptr;
  const int draws = number_from("SECULAR_COVERAGE_DRAWS", 2), first = number_from("SECULAR_COVERAGE_FIRST", 0);
  std::map<std::string, double> fixed;
  if (const char* names = std::getenv("SECULAR_COVERAGE_FIXED")) {
    std::istringstream list(names);
    for (std::string name; std::getline(list, name, ',');) fixed.merge(campaign.true_values({name}));
  }
  const std::map<std::string, double> truth = campaign.truth();
  std::map<std::string, Coverage> table;
  int contradictions = 0;
  double chi_squared = 0, freedom = 0;
  for (int draw = first; draw < first + draws; ++draw) {
    const Estimate estimate = campaign.identified(draw, fixed);
    contradictions += estimate.consistency.significant;
    if (many)
      std::printf("draw %d: chi-squared %.1f on %.0f, p = %.2g\n", draw, estimate.consistency.chi_squared,
                  estimate.consistency.degrees_of_freedom, estimate.consistency.p_value);
    chi_squared += estimate.consistency.chi_squared / draws;
    freedom += estimate.consistency.degrees_of_freedom / draws;
    for (const EstimatedValue& v : estimate.parameters) {
      if (!v.value || v.fixed) continue;
      EXPECT_FALSE(v.doubtful) << v.name;
      table[v.name].add(v, truth.at(v.name));
      EXPECT_GT(two_sided_p_value((*v.value - truth.at(v.name)) / v.sd, v.degrees_of_freedom), 1e-5) << v.name;
    }
  }
  EXPECT_LE(contradictions, draws / 50);
  std::printf("chi-squared of the lumps against one another: mean %.1f on %.1f, contradictions %d of %d\n",
              chi_squared, freedom, contradictions, draws);
  print(table);
  return freedom;
}

// The dwells of a campaign on another structure, without noise, followed there from the steady motions of the
// campaign's own in steps; those whose motion ends on the way are left out.
ObservationSet on_another_structure(const ObservationSet& measured, const Eigen::VectorXd& own,
                                    const Eigen::VectorXd& other) {
  constexpr int steps = 20;
  ObservationSet result = measured;
  result.observations.clear();
  result.truncation.resize(0, 0);
  result.truncation_change.clear();
  result.truncation_of_moves.clear();
  for (std::size_t begin = 0, end = 0; begin < measured.observations.size(); begin = end) {
    ObservationSet dwell = result;
    dwell.observations.clear();
    while (end < measured.observations.size() &&
           measured.observations[end].record == measured.observations[begin].record)
      dwell.observations.push_back(measured.observations[end++]);
    SteadySet motion(dwell, 1);
    std::optional<ObservationSet> found = motion.at(own);
    for (int step = 1; found && step <= steps; ++step)
      found = motion.at(own + static_cast<double>(step) / steps * (other - own));
    if (found)
      result.observations.insert(result.observations.end(), found->observations.begin(), found->observations.end());
  }
  return result;
}

// Error bars hold what entangled parameters do beyond the expansion, which is the same in every noise draw of one
// structure. Here each draw has a structure of its own: parameters along every direction that no lump sees are
// where the error bars suppose them, normal about the likeliest place. Its motions are steady ones of the full
// equations at the campaign's dwells, with noise as the ensembles show it.
void expect_intervals_to_hold_for_drawn_structures(const ThesisCampaign& campaign) {
  const int draws = number_from("SECULAR_COVERAGE_STRUCTURES", 2), first = number_from("SECULAR_COVERAGE_FIRST", 0);
  const Identification shipped = campaign.identification(0);
  ASSERT_EQ(shipped.measured.size(), 1U);
  const Eigen::MatrixXd &null_space = shipped.estimate.null_space,
                        &coordinate = shipped.estimate.null_space_coordinate;
  ASSERT_GT(null_space.cols(), 0);
  const Eigen::VectorXd likeliest = campaign.parameters() - null_space * (coordinate * campaign.parameters());
  std::map<std::string, Coverage> table;
  const auto all = static_cast<double>(shipped.measured.front().observations.size());
  int inside = 0, count = 0, few_motions = 0, doubtful = 0;
  double share = 0;
  for (int draw = first; draw < first + draws; ++draw) {
    NoiseStream place(static_cast<std::uint64_t>(draw) + 1, 0, 1);
    Eigen::VectorXd truth = likeliest;
    for (Eigen::Index d = 0; d < null_space.cols(); ++d) truth += place.gaussian() * null_space.col(d);
    const ObservationSet exact = on_another_structure(shipped.measured.front(), campaign.parameters(), truth);
    share += static_cast<double>(exact.observations.size()) / all / draws;
    if (static_cast<double>(exact.observations.size()) < 0.5 * all) {
      ++few_motions;
      continue;
    }
    Identification id;
    id.campaign = shipped.campaign;
    id.model = shipped.model;
    id.measured = {with_observation_noise(exact, static_cast<std::uint64_t>(draw) + 1)};
    estimate_observed(campaign.request(), id);
    for (const EstimatedValue& v : id.estimate.parameters) {
      if (!v.value || v.fixed) continue;
      doubtful += v.doubtful;
      inside += table[v.name].add(v, truth(static_cast<Eigen::Index>(symbol_named(*id.model, v.name))));
      ++count;
    }
  }
  print(table);
  std::printf(
      "all %d intervals: %.1f %% hold; %d doubtful; %.1f %% of the dwells have a motion, %d structures less than "
      "half of theirs\n",
      count, 100.0 * inside / std::max(count, 1), doubtful, 100 * share, few_motions);
  ASSERT_GT(count, 0);
  EXPECT_LE(few_motions, draws / 2);
  // Intervals of one draw depend on one another: as if it had five independent ones.
  const double independent = 5.0 * (draws - few_motions);
  EXPECT_GT(static_cast<double>(inside) / count, 0.93 - 4 * std::sqrt(0.05 * 0.95 / independent));
}

TEST(SlowChapterFive, IntervalsHold) {
  expect_intervals_to_hold(ThesisCampaign::chapter_five());
}

// Four parameters act alike on every lump of this resonance, and not alike beyond the expansion: the rows tell how
// far they are, so that error bars are those of the noise, and what is still open of the truncation hides no lack
// of fit.
TEST(SlowChapterFive, NullSpaceCoordinatesAreReadOffTheRows) {
  const Estimate estimate = ThesisCampaign::chapter_five().identified(0);
  for (const EstimatedValue& v : estimate.parameters)
    if (v.value) {
      EXPECT_LT(v.open_sd, 0.5 * v.noise_sd) << v.name;
      EXPECT_NEAR(std::hypot(v.open_sd, v.noise_sd), v.sd, 0.2 * v.sd) << v.name;
    }
  ASSERT_EQ(estimate.lack_of_fit.size(), 1U);
  for (const LackOfFit& test : estimate.lack_of_fit.front().equations) {
    EXPECT_FALSE(test.significant) << test.name;
    // The root of a mean square has the standard deviation 1/sqrt(2 degrees of freedom).
    EXPECT_GT(test.misfit_ratio, 1 - 4 / std::sqrt(2 * test.numerator_df)) << test.name;
  }
}

// The source's procedures are biased, by many of their own error bars in some quantities; the bias that is seen on
// motions of the full equations with the identified parameters is theirs, and the interval without it holds the
// truth.
void expect_procedures_without_bias_to_hold(const ThesisCampaign& campaign, std::size_t quantities) {
  const int draws = number_from("SECULAR_COVERAGE_PROCEDURES", 1), first = number_from("SECULAR_COVERAGE_FIRST", 0);
  std::map<std::string, Coverage> table;
  int inside = 0, count = 0, inside_with_bias = 0;
  for (int draw = first; draw < first + draws; ++draw) {
    std::size_t judged = 0;
    const ProcedureRun run = campaign.procedures(draw);
    for (const ProcedureSection& section : run.sections)
      for (const ProcedureRow& row : section.rows) {
        if (!row.bias || !row.truth) continue;
        ++judged;
        ++count;
        inside += table[row.equation + " " + row.name].add(row.best(), row.bias->sd(), row.bias->degrees_of_freedom,
                                                           *row.truth);
        inside_with_bias += std::abs(row.recovered - *row.truth) < 2 * *row.sd;
      }
    EXPECT_EQ(judged, quantities);
  }
  print(table);
  std::printf("all %d intervals: %.1f %% hold without the bias, %.1f %% with it\n", count, 100.0 * inside / count,
              100.0 * inside_with_bias / count);
  const double independent = 5.0 * draws;
  EXPECT_GT(static_cast<double>(inside) / count, 0.93 - 4 * std::sqrt(0.05 * 0.95 / independent));
  EXPECT_LT(inside_with_bias, inside);
}

TEST(SlowChapterFive, ProceduresWithoutTheirBiasHold) {
  expect_procedures_without_bias_to_hold(ThesisCampaign::chapter_five(), 11);
}

TEST(SlowChapterSix, ProceduresWithoutTheirBiasHold) {
  expect_procedures_without_bias_to_hold(ThesisCampaign::chapter_six(), 22);
}

const ProcedureRow& row_of(const ProcedureRun& run, const std::string& method, const std::string& name) {
  for (const ProcedureSection& section : run.sections)
    for (const ProcedureRow& r : section.rows)
      if (section.method == method && r.name == name) return r;
  throw std::out_of_range(method + ": " + name);
}

TEST(SlowChapterSix, ProcedureSetsRecoveredBesideTrueBesidePrinted) {
  const ProcedureRun run = ThesisCampaign::chapter_six().procedures_as_printed();
  EXPECT_EQ(run.measured.observations.size(), 310u);
  const ProcedureRow& frequency = row_of(run, "jump_frequencies", "omega1 + omega2");
  EXPECT_NEAR(frequency.recovered, *frequency.truth, 0.001 * *frequency.truth);
  const ProcedureRow& eta11 = row_of(run, "harmonic", "eta11");
  EXPECT_NEAR(eta11.recovered, *eta11.truth, 0.01 * std::abs(*eta11.truth));
  for (const char* name : {"mu11", "mu22", "Gamma_5"}) {
    const ProcedureRow& r = row_of(run, "two_modes", name);
    EXPECT_NEAR(r.recovered, *r.truth, 0.1 * std::abs(*r.truth)) << name;
    EXPECT_NEAR(*r.as_printed, -r.recovered, 1e-6 * std::abs(r.recovered)) << name << ": the sign of the detuning";
  }
  // Tables D.3-D.5 of the source's equations, then each generated equation, weighted and not.
  std::vector<std::string> tables;
  for (const ProcedureSection& section : run.sections)
    for (const auto& [name, table] : section.anova) tables.push_back(name);
  EXPECT_EQ(tables, (std::vector<std::string>{
                        "Eq. (6.49)", "Eq. (6.50)", "Eq. (6.51)", "modulation of v1, weighted by measured noise",
                        "modulation of v1, equal weights", "modulation of v2, weighted by measured noise",
                        "modulation of v2, equal weights"}));
  EXPECT_NE(procedures_report(run, "command").find("Amplitudes of both modes"), std::string::npos);
}

TEST(SlowChapterFive, IntervalsHoldAlongTheNullSpace) {
  expect_intervals_to_hold_for_drawn_structures(ThesisCampaign::chapter_five());
}

TEST(SlowChapterSix, IntervalsHoldAlongTheNullSpace) {
  expect_intervals_to_hold_for_drawn_structures(ThesisCampaign::chapter_six());
}

TEST(SlowChapterSix, LumpsOfTheRightModelGoTogetherAndIntervalsHold) {
  EXPECT_GE(expect_intervals_to_hold(ThesisCampaign::chapter_six()), 20);
}

void expect_settled(const Estimate& estimate) {
  EXPECT_FALSE(estimate.consistency.significant) << estimate.consistency.p_value;
  for (const EstimatedValue& v : estimate.parameters) EXPECT_FALSE(v.doubtful) << v.name;
}

TEST(SlowChapterSix, CorrectionsThatBeginFarAwaySettle) {
  const ThesisCampaign& campaign = ThesisCampaign::chapter_six();
  // Fourteen standard deviations from the raw estimate to where its correction comes to rest: slopes that were seen
  // there lead nowhere, and weights that belong there make good steps look bad.
  expect_settled(campaign.identified(59, campaign.true_values({"delta31", "delta33", "delta34", "delta36"})));
  // The second correction has coefficients that make far more noise of the measurement's: the errors of the columns
  // have to follow, or the lumps that they seem to drown are given up.
  expect_settled(campaign.identified(336));
}

TEST(SlowChapterFive, EstimatesAreContinuous) {
  const ThesisCampaign& campaign = ThesisCampaign::chapter_five();
  testing_support::expect_continuous(campaign.identified(0), campaign.identified_with_jitter(0));
}

TEST(SlowChapterSix, EstimatesAreContinuous) {
  const ThesisCampaign& campaign = ThesisCampaign::chapter_six();
  testing_support::expect_continuous(campaign.identified(0), campaign.identified_with_jitter(0));
}

// Without coupled damping, lumps that it is part of cannot go together.
TEST(SlowChapterSix, AMissingTermIsAContradiction) {
  const Estimate estimate = ThesisCampaign::chapter_six().identified(0, {{"mu12", 0.0}});
  bool told = estimate.consistency.significant;
  for (const CaseLackOfFit& tests : estimate.lack_of_fit)
    for (const LackOfFit& test : tests.equations) told = told || test.significant;
  EXPECT_TRUE(told);
}

}  // namespace
}  // namespace secular::app
