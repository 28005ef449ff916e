#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "diagnose/effects/candidate.hpp"
#include "diagnose/evidence/discrepancy.hpp"
#include "diagnose/inference/inference.hpp"

namespace secular {

/// What is left of rows that have unit variance where there is no gap.
struct RowsLeft {
  double chi_squared = 0;
  double freedom = 0;  ///< degrees of freedom about whatever was fitted
  /// Of the noise that rows are in units of, as if it were measured apart from them (docs/inference.md (50)).
  double noise_freedom = std::numeric_limits<double>::infinity();
};

/// Of rows of this evidence, at true errors.
RowsLeft rows_left(double chi_squared, double freedom, const Discrepancy& evidence);

/// Whether noise alone would leave so much less often than DiagnoseThresholds::gap_alarm.
bool is_more_than_noise(const RowsLeft& left);

struct DetectedGap {
  double p_value = 1;  ///< of the three tests together (Bonferroni)
  bool detected = false;
  bool noise_misjudged = false;  ///< the rows scatter far less than the repeatability that they are measured in
};

/// Three tests: of all that the judged numbers leave; of what the best single candidate of `inference` gains at
/// first order, however many were looked at (docs/inference.md (32)); and `moved`, p that given numbers are those
/// that fit best (nothing where none were given). `scatter_freedom`: degrees of freedom of what is known of the
/// records' own frequencies.
DetectedGap detect_gap(const RowsLeft& left, const Inference& inference, const std::vector<Candidate>& candidates,
                       double scatter_freedom, std::optional<double> moved);

}  // namespace secular
