#include "jobs/identify/estimate_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "estimator/identification/identified_lumps.hpp"
#include "jobs/identify/full_equations.hpp"
#include "jobs/identify/scatter_output.hpp"
#include "jobs/shared/disturbance_output.hpp"
#include "numerics/confidence.hpp"

namespace secular {
namespace {

using Json = nlohmann::ordered_json;

Json value_json(const EstimatedValue& value, bool lump, const Estimate& estimate) {
  Json entry;
  entry["name"] = value.name;
  if (lump) entry["definition"] = value.definition;
  if (lump) entry["case"] = value.resonance;
  if (value.value) {
    entry["value"] = *value.value;
    entry["sd"] = value.sd;
    if (value.fixed) {
      entry["ci95"] = {*value.value, *value.value};
    } else {
      const Interval interval = confidence_interval(*value.value, value.sd, value.degrees_of_freedom);
      entry["ci95"] = {interval.low, interval.high};
    }
  } else {
    entry["value"] = nullptr;
    entry["sd"] = nullptr;
    entry["ci95"] = nullptr;
  }
  entry["unit"] = value.unit;
  entry["identifiable"] = value.identifiable;
  entry["significant"] = value.significant;
  entry["from"] = value.from;
  if (value.fixed) entry["fixed"] = true;
  if (value.value && !value.fixed) {
    entry["sd_by_noise"] = value.noise_sd;
    entry["sd_by_open_parameters"] = value.open_sd;
  }
  if (value.value && value.between_records) entry["scatter_between_records"] = scatter_json(value, estimate);
  if (value.misfit > 0) entry["misfit"] = value.misfit;
  if (value.doubtful) entry["doubtful"] = true;
  if (value.doubtful) entry["doubtful_because"] = value.doubtful_because;
  if (value.truncation != 0) entry["truncation_correction"] = -value.truncation;
  if (!value.identifiable) entry["entangled_with"] = value.entangled_with;
  if (!value.nearly_entangled_with.empty()) entry["nearly_entangled_with"] = value.nearly_entangled_with;
  if (value.partial_f)
    entry["partial_f"] = {{"f", value.partial_f->f},
                          {"numerator_df", 1},
                          {"denominator_df", value.partial_f->degrees_of_freedom},
                          {"p_value", value.partial_f->p_value},
                          {"p_value_holm", value.partial_f->p_value_holm},
                          {"tests", value.partial_f->tests}};
  if (value.bootstrap)
    entry["bootstrap"] = {{"sd", value.bootstrap->sd}, {"ci95", {value.bootstrap->low, value.bootstrap->high}}};
  return entry;
}

void add_unstated_noise(Json& result, const std::vector<UnstatedNoise>& all) {
  if (all.empty()) return;
  Json& list = result["unstated_noise"] = Json::array();
  for (const UnstatedNoise& noise : all)
    list.push_back({{"case", noise.resonance},
                    {"mode", noise.mode},
                    {"sd", noise.sd},
                    {"degrees_of_freedom", noise.degrees_of_freedom},
                    {"rows", noise.rows},
                    {"from", "what the model leaves"}});
}

Json lack_of_fit_json(const LackOfFit& test, const CaseLackOfFit& tests) {
  Json entry;
  entry["case"] = tests.resonance;
  entry["equation"] = test.name;
  entry["conditions"] = test.conditions;
  entry["misfit_ratio"] = test.misfit_ratio;
  entry["scatter_ratio"] = test.scatter_ratio;
  entry["misfit"] = test.misfit_ratio;  // their names in version 0.1, kept for one version
  entry["repeatability"] = test.scatter_ratio;
  entry["f"] = test.f;
  entry["numerator_df"] = test.numerator_df;
  if (std::isfinite(test.denominator_df))
    entry["denominator_df"] = test.denominator_df;
  else
    entry["denominator_df"] = nullptr;  // the measured noise stands for repeats
  entry["p_value"] = test.p_value;
  entry["significant"] = test.significant;
  return entry;
}

Json condition_json(const ConditionQuality& condition, const Identification& id) {
  Json entry;
  entry["case"] = condition.resonance;
  entry["record"] = id.campaign.records[condition.record].file;
  entry["ensembles"] = condition.ensembles;
  entry["amplitude"] = condition.amplitude;
  if (condition.gamma) {
    entry["gamma_rad"] = *condition.gamma;
    entry["gamma_sd"] = *condition.gamma_sd;
  }
  entry["leverage"] = condition.leverage;
  entry["influence"] = condition.influence;
  entry["residual"] = condition.residual;
  return entry;
}

Json damping_json(const DampingComparison& comparison) {
  Json entry;
  entry["case"] = comparison.resonance;
  entry["mode"] = comparison.mode;
  entry["decided"] = comparison.decided;
  entry["chosen"] = comparison.laws[comparison.chosen].terms;
  entry["laws"] = Json::array();
  for (const DampingLaw& law : comparison.laws)
    entry["laws"].push_back({{"terms", law.terms},
                             {"held_out_score", law.score},
                             {"worse_by", law.worse_by},
                             {"worse_by_sd", law.sd},
                             {"p_value", law.p_value},
                             {"excluded", law.excluded}});
  return entry;
}

// One entry a record; one of the case where no time of a record is known.
void add_lateness(Json& list, const CaseLateness& lateness, const Identification& id) {
  Json common = {{"kind", "late_record"}, {"case", lateness.resonance}, {"finding", name_of(lateness.finding)}};
  common["treated"] = lateness.finding == PhaseFinding::late ? "fitted" : "listed";
  common["p_value"] = lateness.p_value;
  if (!lateness.assumed_positive.empty()) common["assumed_positive"] = lateness.assumed_positive;
  if (lateness.records.empty()) {
    common["text"] = text_of(lateness);
    list.push_back(std::move(common));
    return;
  }
  for (const RecordLateness& record : lateness.records) {
    Json entry = common;
    entry["record"] = id.campaign.records[record.record].file;
    entry["size"] = record.late_s;
    entry["unit"] = "s";
    entry["period_s"] = record.period_s;
    list.push_back(std::move(entry));
  }
}

// Of all parameters together with representatives of those that the data cannot tell: what noise and what is left
// open do to them, along the same directions. Misfit that widened an error bar counts as that parameter's own.
Json representative_covariance(const Estimate& estimate) {
  const Eigen::MatrixXd matrix =
      estimate.noise * estimate.noise.transpose() + estimate.open * estimate.open.transpose();
  Json names = Json::array(), rows = Json::array();
  for (std::size_t p = 0; p < estimate.parameters.size(); ++p) {
    const EstimatedValue& value = estimate.parameters[p];
    const auto row = static_cast<Eigen::Index>(p);
    if (value.fixed || row >= matrix.rows()) continue;
    names.push_back(value.name);
    Json entries = Json::array();
    for (std::size_t q = 0; q < estimate.parameters.size(); ++q) {
      if (estimate.parameters[q].fixed) continue;
      const double entry = matrix(row, static_cast<Eigen::Index>(q));
      entries.push_back(p == q && value.value ? std::max(entry, value.sd * value.sd) : entry);
    }
    rows.push_back(std::move(entries));
  }
  return {{"names", std::move(names)}, {"matrix", std::move(rows)}};
}

// Of parameters that the data cannot tell, values that go with all that they tell: for commands that need numbers.
void add_representative(Json& result, const Identification& identification) {
  const Estimate& estimate = identification.estimate;
  const Eigen::VectorXd values = representative_parameters(estimate);
  Json open;
  for (std::size_t p = 0; p < estimate.parameters.size(); ++p)
    if (!estimate.parameters[p].value && std::isfinite(values(static_cast<Eigen::Index>(p))))
      open[estimate.parameters[p].name] = values(static_cast<Eigen::Index>(p));
  if (open.empty()) return;
  Json cases = Json::array();
  for (const CompiledCase* resonance : identified_cases(estimate)) cases.push_back(resonance->name);
  result["representative"] = {{"values", std::move(open)}, {"steady_motions_of", std::move(cases)}};
  if (estimate.noise.rows() == values.size())
    result["representative"]["covariance"] = representative_covariance(estimate);
}

// Of all parameters that were estimated. Misfit that widened an error bar counts as that parameter's own.
Json covariance_json(const Estimate& estimate) {
  std::vector<Eigen::Index> places;
  Json names = Json::array(), matrix = Json::array();
  for (std::size_t p = 0; p < estimate.parameters.size(); ++p) {
    const EstimatedValue& value = estimate.parameters[p];
    if (!value.value || value.fixed) continue;
    places.push_back(static_cast<Eigen::Index>(p));
    names.push_back(value.name);
  }
  for (const Eigen::Index row : places) {
    Json entries = Json::array();
    for (const Eigen::Index column : places) {
      const double sd = estimate.parameters[static_cast<std::size_t>(row)].sd;
      entries.push_back(row == column ? sd * sd : estimate.covariance(row, column));
    }
    matrix.push_back(std::move(entries));
  }
  return {{"names", std::move(names)}, {"matrix", std::move(matrix)}};
}

void add_following(Json& result, const std::vector<FollowingEstimate>& all) {
  for (const FollowingEstimate& following : all) {
    Json entry = {{"name", following.name}, {"value", following.value}, {"sd", following.sd}};
    if (following.doubtful) entry["doubtful"] = true;
    if (following.doubtful) entry["doubtful_because"] = {following.doubtful_because};
    result["follows_from_rest"].push_back(std::move(entry));
  }
}

Json block_json(const BlockQuality& block) {
  Json entry;
  entry["name"] = block.name;
  entry["case"] = block.resonance;
  entry["equations"] = block.equations;
  entry["conditions"] = block.conditions;
  entry["normalised_residual"] = block.normalised_residual;
  entry["condition_index"] = block.condition_index;
  entry["covariance"] = block.clustered ? "clustered by condition" : "from residuals";
  for (const auto& [name, inflation] : block.variance_inflation) entry["variance_inflation"][name] = inflation;
  return entry;
}

Json number_json(const std::vector<EstimatedValue>& values, std::size_t at) {
  if (at >= values.size() || !values[at].value) return nullptr;
  return {{"value", *values[at].value}, {"sd", values[at].sd}};
}

Json refinement_json(const DecayRefinement& refinement) {
  Json entry = {{"taken", refinement.is_taken()}, {"text", text_of(refinement)}};
  entry["parameters"] = Json::array();
  for (std::size_t p = 0; p < refinement.by_modulation.size(); ++p)
    entry["parameters"].push_back({{"name", refinement.by_modulation[p].name},
                                   {"by_modulation_equations", number_json(refinement.by_modulation, p)},
                                   {"by_full_equations", number_json(refinement.by_full_equations, p)}});
  return entry;
}

Json json_of(const Identification& identification) {
  Json result;
  result["schema"] = 1;
  result["model"] = identification.model->name;
  Json cases = Json::array();
  std::size_t observations = 0;
  for (const ObservationSet& set : identification.measured) {
    cases.push_back(set.resonance->name);
    observations += set.observations.size();
  }
  if (cases.size() == 1)
    result["case"] = cases.front();
  else
    result["cases"] = cases;
  result["coordinate_unit"] = identification.coordinate_unit;
  result["estimates"] = Json::array();
  for (const EstimatedValue& value : identification.estimate.parameters)
    result["estimates"].push_back(value_json(value, false, identification.estimate));
  result["lumps"] = Json::array();
  for (const EstimatedValue& value : identification.estimate.lumps)
    result["lumps"].push_back(value_json(value, true, identification.estimate));
  result["covariance"] = covariance_json(identification.estimate);
  add_representative(result, identification);
  add_following(result, identification.following);
  Json quality;
  quality["observations"] = observations;
  quality["blocks"] = Json::array();
  for (const BlockQuality& block : identification.estimate.blocks) quality["blocks"].push_back(block_json(block));
  quality["lack_of_fit"] = Json::array();
  for (const CaseLackOfFit& tests : identification.estimate.lack_of_fit)
    for (const LackOfFit& test : tests.equations) quality["lack_of_fit"].push_back(lack_of_fit_json(test, tests));
  const LumpConsistency& consistency = identification.estimate.consistency;
  quality["lump_consistency"] = {{"chi_squared", consistency.chi_squared},
                                 {"degrees_of_freedom", consistency.degrees_of_freedom},
                                 {"p_value", consistency.p_value},
                                 {"significant", consistency.significant}};
  quality["conditions"] = Json::array();
  for (const ConditionQuality& condition : identification.estimate.conditions)
    quality["conditions"].push_back(condition_json(condition, identification));
  quality["outliers"] = Json::array();
  for (const OutlyingEnsemble& o : identification.estimate.outliers)
    quality["outliers"].push_back({{"case", o.resonance},
                                   {"record", identification.campaign.records[o.record].file},
                                   {"centre_s", o.centre_s},
                                   {"distance", o.distance},
                                   {"weight", o.weight}});
  quality["damping_laws"] = Json::array();
  for (const DampingComparison& comparison : identification.estimate.damping)
    quality["damping_laws"].push_back(damping_json(comparison));
  quality["not_separated"] = Json::array();
  for (const NullDirection& direction : identification.estimate.null_directions)
    quality["not_separated"].push_back(
        {{"parameters", direction.parameters}, {"direction", direction.text}, {"parted_by", direction.parted_by}});
  if (!identification.held_out.empty()) {
    quality["held_out"] = Json::array();
    for (const HeldOutPrediction& prediction : identification.held_out)
      quality["held_out"].push_back({{"record", identification.campaign.records[prediction.record].file},
                                     {"from_s", prediction.from_s},
                                     {"to_s", prediction.to_s},
                                     {"rms", prediction.rms},
                                     {"largest_excursion", prediction.amplitude},
                                     {"unit", identification.coordinate_unit}});
  }
  if (identification.refinement) quality["refinement"] = refinement_json(*identification.refinement);
  quality["warnings"] = identification.estimate.warnings;
  add_unstated_noise(result, identification.estimate.unstated_noise);
  result["quality"] = std::move(quality);
  result["disturbances"] = disturbances_json(identification.disturbances, identification.campaign);
  for (const CaseLateness& lateness : identification.lateness)
    add_lateness(result["disturbances"], lateness, identification);
  return result;
}

}  // namespace

std::string estimate_json(const Identification& identification) {
  Json result = json_of(identification);
  if (!identification.full) return result.dump(2) + "\n";
  const FullEstimate& full = *identification.full;
  result["equations"] = "full";
  Json& quality = result["quality"];
  quality["observations"] = full.conditions;
  quality["converged"] = full.has_converged;
  if (full.noise_misjudged) quality["noise"] = "misjudged";
  quality["data_used"] = full.data_used;
  quality["records"] = records_in_words(identification.campaign, full.records);
  return result.dump(2) + "\n";
}

}  // namespace secular
