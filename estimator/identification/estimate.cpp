#include "estimator/identification/estimate.hpp"

#include <algorithm>

#include "estimator/identification/estimation.hpp"
#include "estimator/identification/unsupported_values.hpp"

namespace secular {

std::string label_of(const EstimatedValue& value, const Estimate& estimate) {
  const bool lump = !value.resonance.empty() && value.definition != value.name;
  return lump && estimate.cases.size() > 1 ? value.resonance + ":" + value.name : value.name;
}

Estimate estimate(std::span<const ObservationSet> sets, const MeasuredUnits& units, const EstimateOptions& options,
                  const EstimatePass& pass) {
  const bool any =
      std::any_of(sets.begin(), sets.end(), [](const ObservationSet& s) { return !s.observations.empty(); });
  if (!any) {
    std::string names, why = "the campaign has no record of the kind it needs";
    for (auto set = sets.rbegin(); set != sets.rend(); ++set) {
      names = std::string(set->resonance->name) + (names.empty() ? "" : ", ") + names;
      if (!set->warnings.empty()) why = set->warnings.front();
    }
    throw NothingObserved("case " + names + ": no observations are left to identify it from; " + why);
  }
  Estimation e(sets, units, options, pass);
  const Precision so_far = fit_rounds(e);
  share_parameters(e);
  if (!e.frequency_lumps.empty()) {
    follow_frequency_lumps(e);
  } else if (know_frequency_lumps(e) || so_far == Precision::rough) {
    fit_cases(e, Precision::full);
    share_parameters(e);
  }
  if (options.bootstrap > 0 && !pass.between) draw_bootstrap(e);
  place_along_null_space(e);
  e.hidden.resize(e.fits.size());
  if (pass.judge_fit) {
    test_fit(e);
    test_consistency(e);
  }
  report_parameters(e);
  report_lumps(e);
  report_quality(e);
  if (pass.judge_fit) {
    take_out_unsupported(e.result, e.fits);
    doubt_without_force(e.result, e.fits);
  }
  e.result.state = std::make_shared<const EstimationState>(EstimationState{
      std::move(e.blocks), std::move(e.states), e.knowledge.natural_frequency, std::move(e.frequency_lumps)});
  return std::move(e.result);
}

Estimate estimate(const ObservationSet& set, const std::string& coordinate_unit,
                  const std::vector<std::string>& excitation_units, const EstimateOptions& options,
                  const EstimatePass& pass) {
  return estimate(std::span(&set, 1), {coordinate_unit, excitation_units}, options, pass);
}

}  // namespace secular
