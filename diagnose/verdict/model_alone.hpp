#pragma once

#include <optional>
#include <vector>

#include "diagnose/evidence/segment_evidence.hpp"
#include "diagnose/inference/inference.hpp"
#include "diagnose/verdict/campaign_and_model.hpp"
#include "diagnose/verdict/comparison.hpp"
#include "diagnose/verdict/diagnosis_options.hpp"
#include "diagnose/verdict/frequency_scatter.hpp"
#include "diagnose/verdict/gap_detection.hpp"
#include "diagnose/verdict/late_records.hpp"

namespace secular {

/// What the model as it is leaves of a campaign, beside what its records are allowed to have of their own.
struct ModelAlone {
  RowsLeft left;
  FrequencyScatter scatter;  ///< where the options admit it
  LateRecords late;          ///< where the options admit it
  /// Of records that are compared sample by sample, where more than noise is left and records are not allowed to
  /// have anything of their own: what is left in the samples that are compared, and left_of_records().
  std::vector<SegmentEvidence::Left> of_segments, of_records;

  /// Natural frequencies of each record's own, where admitted: of how many modes, and log of how much wider they
  /// are spread before the record is seen than after it, sum over records (docs/inference.md (26a)).
  double scattering_modes = 0, log_width = 0;

  double dispersion() const { return left.chi_squared / left.freedom; }

  /// docs/inference.md (26a), on the scale of Explanation::log_evidence. `price`: of one unknown.
  double log_evidence(double of_dispersion, double price) const {
    return -0.5 * left.chi_squared / of_dispersion - log_width - price * scattering_modes;
  }
};

/// The model as it is beside a campaign, fitted.
struct FittedAlone {
  Comparison comparison;
  Inference inference;  ///< without candidates
  bool late = false;    ///< all responses by one unknown time
};

InferenceOptions options_of_fit(const DiagnosisOptions& options);

/// Takes a small part of the time of a diagnosis. `common_late_s`: with all responses late by one unknown time,
/// from this one on.
FittedAlone fitted_alone(const CampaignAndModel& sides, const DiagnosisOptions& options,
                         std::optional<double> common_late_s = {});
ModelAlone left_by(const FittedAlone& fitted, const CampaignAndModel& sides, const DiagnosisOptions& options);
/// Both in one.
ModelAlone fit_alone(const CampaignAndModel& sides, const DiagnosisOptions& options,
                     std::optional<double> common_late_s = {});

/// Whether lateness of each record's own takes more than chance does of what is left without it.
bool lateness_takes_more_than_chance(const ModelAlone& without, const ModelAlone& with);

/// Scatter of natural frequencies before it is known, by mode, relative.
Eigen::VectorXd first_frequency_scatter(std::size_t modes);

}  // namespace secular
