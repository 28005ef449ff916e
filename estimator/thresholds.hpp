#pragma once

#include <cstddef>

#include "numerics/threshold.hpp"

namespace secular {

/// Of the regression and the identification. Alarm levels and tuned numbers alone (numerics/threshold.hpp);
/// `estimator_threshold_list` says of each what it is.
struct EstimatorThresholds {
  // Alarm levels.
  double contradiction_alarm = 1e-3;
  double sign_alarm = 0.005;
  double common_delay_alarm = 0.05;
  double false_lateness = 0.001;
  double phase_alarm = 0.001;
  double false_lack_of_fit = 0.001;
  double excluding_probability = 0.005;
  double outlier_false_alarm = 0.01;
  double interval_tail = 0.025;
  double setting_alarm = 0.05;
  // Tuned.
  double fewest_freedom = 4;
  double freedom_beside_settings = 6;
  double repeats_of_short_decays = 3;
  double near_dependency = 30;
  double shared_variance = 0.5;
  std::size_t replicates_needed = 4;
  double frequency_prior_sd = 0.005;
  double noise_ratio = 4;
};

/// Those in use.
constexpr const EstimatorThresholds& estimator_thresholds() {
  return thresholds_in_use<EstimatorThresholds>;
}

}  // namespace secular
