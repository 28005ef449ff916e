// Quality of an estimate, case by case, and what its user has to be told.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "estimator/identification/case_quality.hpp"
#include "estimator/identification/estimation.hpp"
#include "estimator/identification/short_list.hpp"

namespace secular {
namespace {

void warn_of_outliers(Estimation& e) {
  if (e.result.outliers.empty()) return;
  const OutlyingEnsemble& worst =
      *std::max_element(e.result.outliers.begin(), e.result.outliers.end(),
                        [](const auto& a, const auto& b) { return a.distance < b.distance; });
  std::size_t all = 0;
  for (const CaseFit& fit : e.fits) all += fit.set->observations.size();
  const bool one = e.result.outliers.size() == 1;
  e.result.warnings.push_back(fmt::format(
      "{} of {} ensembles stand{} out from the others of {} condition and count{} less; {}record {}, ensemble at "
      "{:.1f} s: {:.1f} times the usual distance from its condition, weight {:.2g}",
      e.result.outliers.size(), all, one ? "s" : "", one ? "its" : "their", one ? "s" : "", one ? "" : "worst ",
      worst.record + 1, worst.centre_s, worst.distance, worst.weight));
}

}  // namespace

void report_quality(Estimation& e) {
  const auto append = [](auto& to, auto from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  };
  for (const CaseFit& fit : e.fits) {
    if (fit.fit.coefficients.size() == 0) continue;
    const std::string name(fit.set->resonance->name);
    append(e.result.blocks, block_quality(fit));
    append(e.result.conditions, condition_quality(fit));
    append(e.result.outliers, outlying_ensembles(fit));
    if (e.options.damping_laws && !e.pass.between) append(e.result.damping, compare_damping(fit));
    const std::size_t conditions = fit.fit.cluster_labels.size();
    if (fit.fit.covariance_kind != CovarianceKind::clustered)
      e.result.warnings.push_back(
          fmt::format("case {}: too few conditions ({} for {} unknowns) for error bars from their scatter; they "
                      "come from the residuals and may be too small",
                      name, conditions, fit.fit.rank));
    std::vector<std::string> near;
    const auto entangled = nearly_entangled(fit);
    for (std::size_t c = 0; c < entangled.size(); ++c)
      if (!entangled[c].empty()) near.push_back(column_name(fit, c));
    if (!near.empty())
      e.result.warnings.push_back(fmt::format(
          "case {}: {} act nearly alike on these conditions, their error bars say how little is known of "
          "each; conditions with other levels and other ratios of the amplitudes would part them",
          name, short_list(near)));
    std::vector<std::string> lost;
    for (std::size_t c = 0; c < fit.columns.size(); ++c)
      if (!fit.fit.identifiable[c]) lost.push_back(column_name(fit, c));
    if (!lost.empty())
      e.result.warnings.push_back(
          fmt::format("case {}: {} cannot be told apart on {} condition{} (their columns differ by noise or not at "
                      "all); no numbers are given for them",
                      name, short_list(lost), conditions, conditions == 1 ? "" : "s"));
  }
  std::vector<std::string> doubtful;
  for (const auto* list : {&e.result.parameters, &e.result.lumps})
    for (const EstimatedValue& value : *list)
      if (const std::string label = label_of(value, e.result);
          value.doubtful && std::find(doubtful.begin(), doubtful.end(), label) == doubtful.end())
        doubtful.push_back(label);
  if (!doubtful.empty())
    e.result.warnings.push_back("doubtful because the model does not fit: " + short_list(doubtful));
  warn_of_outliers(e);
}

}  // namespace secular
