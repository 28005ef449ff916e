#include "jobs/diagnose/diagnosis_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "jobs/shared/disturbance_output.hpp"
#include "numerics/hertz.hpp"

namespace secular {
namespace {

using Json = nlohmann::ordered_json;

Json next_experiment(const DiagnosisRun& run) {
  const NextExperiment& next = run.diagnosis.next_experiment;
  if (!next.test) return {{"proposed", false}, {"reason", next.reason}};
  const ProposedTest& test = *next.test;
  const RecordEntry& like = run.campaign.records[test.like];
  Json json = {{"proposed", next.proposed}};
  if (!next.proposed) json["reason"] = next.reason;
  json.update({{"kind", to_string(like.kind)},
               {"like", like.file},
               {"level_factor", test.level},
               {"length_factor", test.length},
               {"minutes", test.minutes},
               {"watch", test.watch},
               {"separates", next.separates},
               {"separation_sigma", test.separation},
               {"probability_before", test.before},
               {"expected_probability", test.probability},
               {"expected_probability_of_a_random_one", test.typical},
               {"chance_to_leave_one", test.chance},
               {"compared", test.compared}});
  if (is_steady(like.kind))
    json.update({{"resonance", test.resonance},
                 {"excitation_channel", test.channel},
                 {"excitation_peak", test.excitation},
                 {"frequency_hz", test.frequency * to_hz}});
  return json;
}

Json simulated_errors(const std::vector<SimulatedError>& errors) {
  Json list = Json::array();
  for (const SimulatedError& e : errors) {
    Json entry = {
        {"channel", e.channel}, {"signal_rms", e.signal}, {"before_rms", e.before}, {"after_rms", e.after}};
    if (e.before_fitted) entry["before_fitted_rms"] = *e.before_fitted;
    if (e.after_fitted) entry["after_fitted_rms"] = *e.after_fitted;
    list.push_back(std::move(entry));
  }
  return list;
}

Json gap_json(const GapReport& found) {
  Json gap;
  gap["of"] = to_string(found.judged);
  gap["detected"] = found.detected;
  gap["p_value"] = found.p_value;
  gap["before"] = found.before;
  gap["after"] = found.after;
  gap["floor"] = found.floor;
  gap["closed"] = found.closed;
  gap["closed_ci95"] = {found.closed_low, found.closed_high};
  if (found.left_share) gap["left_share"] = *found.left_share;
  if (found.noise_misjudged) gap["noise"] = "misjudged";
  gap["metric"] = found.metric;
  if (!found.wrong_cause.empty())
    gap["best_other_cause"] = {{"effect", found.wrong_cause}, {"closed", found.wrong_cause_closed}};
  if (found.placebo_closed) gap["placebo_closed"] = *found.placebo_closed;
  return gap;
}

Json unsteady_json(const Unsteadiness& unsteady) {
  Json json = {{"detected", unsteady.detected}, {"p_value", unsteady.p_value}, {"ratio", unsteady.ratio}};
  if (unsteady.detected) json["record"] = unsteady.record;
  return json;
}

Json where_json(const std::vector<GapShare>& shares) {
  Json where = Json::array();
  for (const GapShare& share : shares)
    where.push_back({{"mode", share.mode},
                     {"component", to_string(share.component)},
                     {"harmonic", share.harmonic},
                     {"region", share.region},
                     {"share", share.share}});
  return where;
}

Json cause_json(const CauseReport& cause) {
  Json entry;
  entry["effect"] = cause.effect;
  entry["mode"] = cause.subject;
  entry["probability"] = cause.probability;
  if (!cause.coefficient_name.empty()) {
    entry["coefficient"] = cause.coefficient;
    entry["sd"] = cause.sd;
    entry["symbol"] = cause.coefficient_name;
    entry["unit"] = cause.unit;
  }
  for (const CauseReport::Shape& shape : cause.shapes)
    entry["shapes"].push_back(
        {{"symbol", shape.name}, {"value", shape.value}, {"sd", shape.sd}, {"unit", shape.unit}});
  if (cause.closed) entry["closed"] = *cause.closed;
  return entry;
}

// Keys verdict to causes.
void add_verdict(const Diagnosis& d, Json& root) {
  root["verdict"] = d.verdict;
  root["cause"] = d.cause.empty() ? Json(nullptr) : Json(d.cause);
  root["set"] = d.set;
  if (!d.unknown_because.empty()) root["unknown_because"] = d.unknown_because;
  if (!d.together.empty()) root["together"] = d.together;
  if (!d.second_or.empty()) root["second_or"] = d.second_or;
  if (d.open_law)
    root["open_law"] = {{"mode", d.open_law->mode},
                        {"law", d.open_law->law},
                        {"exponent", d.open_law->exponent},
                        {"sd", d.open_law->sd},
                        {"probability", d.open_law->probability}};
  root["causes"] = Json::array();
  for (const CauseReport& cause : d.causes) root["causes"].push_back(cause_json(cause));
}

// Keys parameters_moved, parameters and covariance.
void add_parameters(const Diagnosis& d, Json& root) {
  if (!d.parameters_moved.empty()) {
    root["parameters_moved"] = Json::array();
    for (const ParameterMove& move : d.parameters_moved)
      root["parameters_moved"].push_back(
          {{"name", move.name}, {"from", move.from}, {"to", move.to}, {"sd", move.sd}});
  }
  root["parameters"] = Json::array();
  for (std::size_t n = 0; n < d.fitted.names.size(); ++n) {
    const auto at = static_cast<Eigen::Index>(n);
    root["parameters"].push_back({{"name", d.fitted.names[n]},
                                  {"value", d.fitted.values(at)},
                                  {"sd", std::sqrt(d.fitted.covariance(at, at))},
                                  {"unit", d.fitted.units[n]}});
  }
  root["covariance"] = {{"names", d.fitted.names}, {"matrix", Json::array()}};
  for (const auto& row : d.fitted.covariance.rowwise())
    root["covariance"]["matrix"].push_back(std::vector<double>(row.begin(), row.end()));
}

Json simulated_json(const SimulatedCheck& check) {
  Json json = {{"dwells", simulated_errors(check.dwells)},
               {"steady", check.steady},
               {"lost", check.lost},
               {"segments", simulated_errors(check.segments)}};
  if (!check.apart.empty()) json["check"] = simulated_errors(check.apart);
  return json;
}

}  // namespace

std::string diagnosis_json(const DiagnosisRun& run) {
  const Diagnosis& d = run.diagnosis;
  Json root;
  root["schema"] = 1;
  root["model"] = std::string(run.model->name);
  root["gap"] = gap_json(d.gap);
  root["unsteady"] = unsteady_json(d.unsteady);
  root["where"] = where_json(d.where);
  add_verdict(d, root);
  add_parameters(d, root);
  if (d.simulated) root["simulated"] = simulated_json(*d.simulated);
  if (d.gap.detected) {
    root["residual_structure"] = {{"p_value", d.residual_structure.p_value},
                                  {"smooth_p_value", d.residual_structure.smooth_p_value},
                                  {"smooth_share", d.residual_structure.smooth_share}};
    root["remainder"] = root["residual_structure"];  // its name in version 0.1, kept for one version
  }
  root["next_experiment"] = next_experiment(run);
  root["conditions"] = d.conditions;
  root["data_used"] = d.data_used;
  root["decays_in_one_piece"] = d.decays_in_one_piece;
  root["warnings"] = d.warnings;
  root["disturbances"] = disturbances_json(run.disturbances, run.campaign);
  return root.dump(2) + "\n";
}

}  // namespace secular
