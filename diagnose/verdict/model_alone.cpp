#include "diagnose/verdict/model_alone.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "diagnose/thresholds.hpp"
#include "numerics/distribution.hpp"

namespace secular {
namespace {

using Eigen::Index;

/// Of the scatter of natural frequencies before it is known, relative (any that is not far below it does).
constexpr auto& first_scatter = diagnose_thresholds().first_scatter;

}  // namespace

InferenceOptions options_of_fit(const DiagnosisOptions& options) {
  InferenceOptions of_fit;
  of_fit.threads = options.threads;
  of_fit.after_own_fit = options.after_own_fit;
  return of_fit;
}

FittedAlone fitted_alone(const CampaignAndModel& sides, const DiagnosisOptions& options,
                         std::optional<double> common_late_s) {
  Comparison comparison = compare(sides, {}, options);
  std::vector<std::size_t> fitted = comparison.fitted_beside(sides.own);
  if (common_late_s) {
    const std::size_t delay =
        sides.model.symbols.size() + comparison.faults.delay(comparison.sensors.responses.size());
    comparison.start(static_cast<Index>(delay)) = -*common_late_s;
    fitted.push_back(delay);
  }
  Inference alone = infer(comparison.discrepancy, {}, comparison.start, fitted, options_of_fit(options));
  return {std::move(comparison), std::move(alone), common_late_s.has_value()};
}

ModelAlone left_by(const FittedAlone& fitted, const CampaignAndModel& sides, const DiagnosisOptions& options) {
  const Comparison& comparison = fitted.comparison;
  const Inference& alone = fitted.inference;
  double scattering_modes = 0, log_width = 0;
  if (options.frequency_scatter.size() > 0) {
    scattering_modes = static_cast<double>((options.frequency_scatter.array() > no_scatter).count());
    for (const OwnFrequency& frequency : comparison.discrepancy.own_frequencies(alone.null.fit.unknowns)) {
      const double sd = options.frequency_scatter(static_cast<Index>(frequency.mode));
      log_width += 0.5 * std::log1p(sd * sd / frequency.variance);
    }
  }
  const RowsLeft left = rows_left(alone.null.fit.chi_squared, alone.degrees_of_freedom, comparison.discrepancy);
  std::vector<SegmentEvidence::Left> of_segments, of_records;
  if (comparison.segment_evidence && !comparison.discrepancy.admits_own() && !fitted.late &&
      is_more_than_noise(left)) {
    of_segments = comparison.segment_evidence->left(alone.null.fit.unknowns);
    of_records = left_of_records(sides, comparison, options, alone.null.fit.unknowns);
  }
  return {left,
          scatter_about(comparison.discrepancy, alone.null.fit.unknowns, sides.model.modes()),
          lateness_about(comparison.discrepancy),
          std::move(of_segments),
          std::move(of_records),
          scattering_modes,
          log_width};
}

ModelAlone fit_alone(const CampaignAndModel& sides, const DiagnosisOptions& options,
                     std::optional<double> common_late_s) {
  return left_by(fitted_alone(sides, options, common_late_s), sides, options);
}

bool lateness_takes_more_than_chance(const ModelAlone& without, const ModelAlone& with) {
  const double taken = (without.left.chi_squared - with.left.chi_squared) / std::max(1.0, with.dispersion());
  const auto records = static_cast<double>(with.late.records.size());
  return chi_squared_upper_tail(std::max(0.0, taken), records) < diagnose_thresholds().scatter_alarm;
}

Eigen::VectorXd first_frequency_scatter(std::size_t modes) {
  return Eigen::VectorXd::Constant(static_cast<Index>(modes), first_scatter);
}

}  // namespace secular
