#pragma once

#include <cstddef>

#include "numerics/threshold.hpp"

namespace secular {

/// Of reading, observing and watching records. Alarm levels and tuned numbers alone (numerics/threshold.hpp);
/// `measure_threshold_list` says of each what it is.
struct MeasureThresholds {
  // Alarm levels.
  double clipping_false_alarm = 1e-6;
  double jitter_false_alarm = 1e-6;
  double disturbance_false_alarm = 1e-3;
  double weak_partner = 0.01;
  double spikes_not_told = 0.01;
  double combination_by_chance = 0.05;
  double amplitude_change_false_alarm = 0.01;
  double offset_sd = 4;
  double dwell_drift_sd = 4;
  double motion_false_alarm = 1e-6;
  double driven_peak_sd = 4;
  // Tuned.
  double same_setting = 1e-3;
  std::size_t rarest_share = 16;
  double same_sample = 0.01;
  std::size_t clipped_run = 4;
  double clipping_depth = 16;
  double clipping_excess = 8;
  double resting_share = 0.6;
  double two_level_share = 0.95;
  std::size_t coarse_levels = 64;
  double smallest_offset = 0.05;
  std::ptrdiff_t softest = 2;
  std::size_t local_samples = 64;
  std::ptrdiff_t slow_terms = 4;
  double zero_level = 0.05;
  double as_large = 0.99;
  double disturbed_noise = 1.2;
  double disturbed_end = 3;
  double disturbed_share = 0.25;
  std::ptrdiff_t windows_in_a_stretch = 5;
  double windows_in_a_decay = 24;
  double largest_fall = 0.5;
  double largest_bend = 0.1;
  double decayed_share = 0.02;
  double seen_above_noise = 6;
  double largest_detuning = 0.15;
  double same_level = 0.2;
  double dwell_drift = 0.01;
  double driven_range = 0.01;
  double driving_share = 0.01;
  double driving_share_about = 0.1;
};

/// Those in use.
constexpr const MeasureThresholds& measure_thresholds() {
  return thresholds_in_use<MeasureThresholds>;
}

}  // namespace secular
