#include "jobs/identify/decay_refinement.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "estimator/identification/value_errors.hpp"
#include "input/input_error.hpp"
#include "input/numerical_failure.hpp"
#include "jobs/identify/full_equations.hpp"
#include "jobs/identify/identification.hpp"
#include "jobs/identify/scatter_output.hpp"
#include "jobs/shared/model_loading.hpp"
#include "jobs/shared/record_selection.hpp"
#include "measure/disturbances/disturbance_watch.hpp"
#include "motion/correction/replay.hpp"
#include "numerics/confidence.hpp"
#include "report/number_format.hpp"

namespace secular {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Records that the modulation equations tell numbers from.
std::set<std::size_t> observed_records(const Identification& id) {
  std::set<std::size_t> records;
  for (const ObservationSet& set : id.measured)
    for (const Observation& observation : set.observations) records.insert(observation.record);
  return records;
}

std::map<std::string, double> numbers_of(const Estimate& estimate) {
  std::map<std::string, double> numbers;
  for (const EstimatedValue& value : estimate.parameters)
    if (value.value && std::isfinite(*value.value)) numbers.emplace(value.name, *value.value);
  return numbers;
}

// What is wrong with the fit itself, or with what it is of; empty: nothing.
std::string against_fit(const FullEstimate& full, const Estimate& estimate, const std::set<std::size_t>& observed) {
  if (!full.has_converged) return "the fit by the full equations did not come to an end";
  if (!full.against_one_piece.empty()) return full.against_one_piece;
  if (full.noise_misjudged) return "the full equations leave far less than the noise that is measured";
  for (const CaseLackOfFit& tests : full.estimate.lack_of_fit)
    for (const LackOfFit& test : tests.equations)
      if (test.significant)
        return fmt::format(
            "the full equations do not hold all along the decays ({}: {} times what noise explains, {})", test.name,
            report::format_number(test.misfit_ratio, 3), report::format_p(test.p_value));
  if (!std::includes(full.records.begin(), full.records.end(), observed.begin(), observed.end()))
    return "the full equations use fewer records";
  for (std::size_t p = 0; p < estimate.parameters.size(); ++p)
    if (estimate.parameters[p].value && !full.estimate.parameters[p].value)
      return "the full equations do not tell " + estimate.parameters[p].name;
  return {};
}

// What is wrong with the estimate by the modulation equations; empty: nothing.
std::string against_estimate(const Estimate& estimate) {
  for (const EstimatedValue& value : estimate.parameters)
    if (value.misfit > 0 || value.doubtful) return "the modulation equations do not hold";
  return scatter_lines(estimate).empty() ? "" : "natural frequencies differ from record to record";
}

// docs/inference.md (68).
std::string disagreement(const Estimate& one, const Estimate& other, double alarm) {
  const auto count = static_cast<double>(one.parameters.size());
  for (std::size_t p = 0; p < one.parameters.size(); ++p) {
    const EstimatedValue &a = one.parameters[p], &b = other.parameters[p];
    if (!a.value || !b.value || a.fixed || !(a.sd > 0)) continue;
    const double apart = std::abs(*a.value - *b.value) / std::hypot(a.sd, b.sd);
    if (two_sided_p_value(apart, a.degrees_of_freedom) * count < alarm)
      return fmt::format(
          "{} is {} by the modulation equations and {} by the full ones, {} joint standard deviations "
          "away",
          a.name, report::format_uncertain(*a.value, a.sd), report::format_uncertain(*b.value, b.sd),
          report::format_number(apart, 3));
  }
  return {};
}

// docs/inference.md (69).
void allow_for(EstimatedValue& value, const EstimatedValue& other, double hidden) {
  if (!value.value || value.fixed) return;
  const double apart = other.value ? *value.value - *other.value : 0,
               beyond = std::sqrt(std::max(0.0, apart * apart - value.sd * value.sd - other.sd * other.sd));
  add_misfit(value, std::hypot(hidden, beyond),
             "along the decays the full equations show that it may be off by more than its error bar");
}

// Steps that noise does not smooth move with the motion: parts of a decay that they make differ say nothing of it.
bool has_coarse_steps(const std::vector<Disturbance>& disturbances) {
  return std::any_of(disturbances.begin(), disturbances.end(),
                     [](const Disturbance& d) { return d.kind == "converter_step"; });
}

// What the full equations contradict: a law that shows along the decays, or `apart`, numbers that are not the same.
void allow_for(Estimate& estimate, const FullEstimate& full, const std::string& apart, bool has_steps) {
  const bool differ = full.hidden_by_parts.size() > 0 && !has_steps;
  if (differ) {
    estimate.lack_of_fit.push_back({"", {*full.parts}});
    estimate.warnings.push_back(
        "the model does not hold all along the decays by the full equations (" + full.parts->name + ": " +
        report::format_number(full.parts->misfit_ratio, 3) +
        " times what noise explains); error bars allow for as much that the numbers have taken up. `secular "
        "diagnose` looks for what is missing");
  }
  if (!apart.empty()) estimate.warnings.push_back("the full equations do not confirm the numbers: " + apart);
  if (!full.has_converged || (!differ && apart.empty())) return;
  for (std::size_t p = 0; p < estimate.parameters.size(); ++p)
    allow_for(estimate.parameters[p], full.estimate.parameters[p],
              differ ? full.hidden_by_parts(static_cast<Index>(p)) : 0);
}

void take(Estimate& estimate, const Estimate& full) {
  std::set<std::string> told;
  for (std::size_t p = 0; p < estimate.parameters.size(); ++p) {
    EstimatedValue& value = estimate.parameters[p];
    EstimatedValue refined = full.parameters[p];
    if (value.fixed || !refined.value) continue;
    refined.told_by = value.told_by;
    refined.between_records = value.between_records;
    value = std::move(refined);
    told.insert(value.name);
    const auto at = static_cast<Index>(p);
    estimate.parameter_values(at) = *value.value;
    // What is told belongs to no direction that is left open.
    if (estimate.null_space.cols() > 0) estimate.null_space.row(at).setZero();
    if (estimate.null_space_coordinate.rows() > 0) estimate.null_space_coordinate.col(at).setZero();
  }
  std::erase_if(estimate.null_directions, [&](const NullDirection& direction) {
    return std::any_of(direction.parameters.begin(), direction.parameters.end(),
                       [&](const std::string& name) { return told.contains(name); });
  });
  const Eigen::SelfAdjointEigenSolver<MatrixXd> parts(full.covariance);
  estimate.covariance = full.covariance;
  estimate.parameter_sd = full.covariance.diagonal().cwiseMax(0).cwiseSqrt();
  estimate.noise = parts.eigenvectors() * parts.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
  estimate.open.resize(full.covariance.rows(), 0);
  estimate.lack_of_fit.insert(estimate.lack_of_fit.end(), full.lack_of_fit.begin(), full.lack_of_fit.end());
}

// What the full equations do at the parameters, which have changed.
void follow_again(const IdentificationRequest& request, Identification& id) {
  SelectedRecords reader(id.campaign, request.window);
  try {
    std::vector<ObservationSet> replayed;
    for (const ObservationSet& set : id.measured)
      replayed.push_back(observe_replay(id.campaign, set, id.estimate.parameter_values, request.threads));
    id.replayed = std::move(replayed);
  } catch (const NumericalFailure&) {
    for (ObservationSet& set : id.replayed) set.observations.clear();
  }
  follow_decays(
      request, [&](std::size_t r) { return reader.read(r); }, id);
}

// The fit that the refinement rests on; none, with the reason noted, where there cannot be one.
std::optional<FullEstimate> fit_of(IdentificationRequest request, const Identification& id,
                                   const std::set<std::size_t>& observed, DecayRefinement& refinement) {
  if (id.model->modes() > 1) {
    refinement.why_not = "of several modes no laws are tried that the model may lack (docs/inference.md (76))";
    return {};
  }
  if (request.window.band) {
    refinement.why_not = "noise of samples that have passed a band is not white";
    return {};
  }
  request.window.chosen.assign(id.campaign.records.size(), false);
  for (const std::size_t r : observed) request.window.chosen[r] = true;
  try {
    const ModelSource source(request.model, request.interpret, {});
    return fit_full_equations(request, id, source, {numbers_of(id.estimate)}).of;
  } catch (const InputError& error) {
    refinement.why_not = error.what();
  } catch (const NumericalFailure& failure) {
    refinement.why_not = failure.what();
  }
  return {};
}

}  // namespace

void refine_decays(const IdentificationRequest& request, Identification& id) {
  DecayRefinement& refinement = id.refinement.emplace();
  refinement.by_modulation = id.estimate.parameters;
  const std::set<std::size_t> observed = observed_records(id);
  const std::optional<FullEstimate> full = fit_of(request, id, observed, refinement);
  if (!full) return;
  refinement.by_full_equations = full->estimate.parameters;
  const std::string of_fit = against_fit(*full, id.estimate, observed);
  refinement.why_not = of_fit.empty() ? against_estimate(id.estimate) : of_fit;
  const std::string apart = disagreement(id.estimate, full->estimate, full->alarm);
  if (refinement.is_taken()) refinement.why_not = apart;
  if (refinement.is_taken()) {
    take(id.estimate, full->estimate);
    follow_again(request, id);
    return;
  }
  allow_for(id.estimate, *full, apart, has_coarse_steps(id.disturbances));
}

std::string text_of(const DecayRefinement& refinement) {
  if (!refinement.is_taken())
    return "by the modulation equations, not refined by the full equations: " + refinement.why_not;
  double least = 1e300, most = 0;
  for (std::size_t p = 0; p < refinement.by_modulation.size(); ++p) {
    const EstimatedValue &before = refinement.by_modulation[p], &after = refinement.by_full_equations[p];
    if (!before.value || !after.value || before.fixed || !(before.sd > 0)) continue;
    least = std::min(least, after.sd / before.sd);
    most = std::max(most, after.sd / before.sd);
  }
  std::string text = "by the full equations, each decay in one piece";
  if (most > 0)
    text += fmt::format(" (error bars {} to {} times those by the modulation equations)",
                        report::format_number(least, 2), report::format_number(most, 2));
  return text;
}

}  // namespace secular
