#include "diagnose/verdict/gap_detection.hpp"

#include <algorithm>

#include "diagnose/thresholds.hpp"
#include "numerics/distribution.hpp"
#include "numerics/third_differences.hpp"

namespace secular {
namespace {

/// A gap is there where noise alone would look like it less often than this.
constexpr auto& false_alarm = diagnose_thresholds().gap_alarm;

/// Repeatability that is overestimated by more than this, as a variance: a gap as large as the noise itself would
/// not be seen.
constexpr auto& most_overestimated = diagnose_thresholds().most_overestimated;

// That the candidate at `c` gains as much without acting (docs/inference.md (32)).
double chance_of_gain(const Inference& inference, const std::vector<Candidate>& candidates, std::size_t c,
                      double scatter_freedom) {
  const auto unknowns = static_cast<double>(candidates[c].strengths.size() + candidates[c].shapes.size());
  const double share = inference.gain_of_records[c];
  return f_upper_tail(inference.linear_gain[c] / unknowns, unknowns, scatter_freedom / (share * share));
}

double chance_of(const RowsLeft& left) {
  return f_upper_tail(left.chi_squared / left.freedom, left.freedom, left.noise_freedom);
}

}  // namespace

RowsLeft rows_left(double chi_squared, double freedom, const Discrepancy& evidence) {
  RowsLeft left{chi_squared, freedom};
  if (const auto measured = static_cast<double>(evidence.measured_rows()); measured > 0)
    left.noise_freedom = freedom * freedom / ((1 / third_difference_freedom - 2) * measured);
  return left;
}

bool is_more_than_noise(const RowsLeft& left) {
  return chance_of(left) < false_alarm;
}

DetectedGap detect_gap(const RowsLeft& left, const Inference& inference, const std::vector<Candidate>& candidates,
                       double scatter_freedom, std::optional<double> moved) {
  const double omnibus = chance_of(left);
  double targeted = 1;
  for (std::size_t c = 0; c < candidates.size(); ++c)
    targeted = std::min(targeted, chance_of_gain(inference, candidates, c, scatter_freedom));
  targeted = std::min(1.0, targeted * static_cast<double>(std::max<std::size_t>(1, candidates.size())));
  DetectedGap gap;
  gap.p_value = std::min(1.0, (moved ? 3 : 2) * std::min({omnibus, targeted, moved.value_or(1)}));
  gap.detected = gap.p_value < false_alarm;
  gap.noise_misjudged = left.chi_squared * most_overestimated < left.freedom && 1 - omnibus < false_alarm;
  return gap;
}

}  // namespace secular
