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
  double offset_sd = 4;
  double dwell_drift_sd = 4;
  // Tuned.
  double lost_row_off = 0.1;
  double same_rate = 1e-3;
  std::size_t rarest_share = 16;
  std::size_t beside_unrecorded = 32;
  double same_sample = 0.01;
  double largest_jitter = 0.25;
  std::size_t clipped_run = 4;
  std::size_t clipping_points = 4;
  double clipping_depth = 16;
  double clipping_excess = 8;
  double clipping_range = 64;
  std::size_t clipping_levels = 8;
  double resting_share = 0.6;
  double two_level_share = 0.95;
  std::size_t coarse_levels = 64;
  double smallest_offset = 0.05;
  std::ptrdiff_t largest_order = 6;
  std::ptrdiff_t softest = 2;
  std::size_t ringing_block = 64;
  std::size_t impulse_block = 64;
  std::size_t mark_neighbours = 32;
  std::size_t mark_spikes = 3;
  std::size_t motion_phases = 8;
  std::size_t held_block = 256;
  std::size_t held_neighbours = 64;
  std::ptrdiff_t slow_terms = 4;
  std::ptrdiff_t offset_blocks = 8;
  double zero_level = 0.05;
  double usual_residual = 3;
  double tone_reach = 0.2;
  double disturbed_noise = 1.2;
  double disturbed_sd = 5;
  double disturbed_end = 3;
  std::size_t disturbed_neighbours = 12;
  double disturbed_share = 0.25;
  std::ptrdiff_t windows_in_a_stretch = 5;
  double windows_in_a_decay = 24;
  double largest_fall = 0.5;
  double largest_bend = 0.1;
  double decayed_share = 0.02;
  double decayed_noise = 2;
  std::size_t fewest_windows = 6;
  double seen_above_noise = 6;
  double separate_bins = 2.5;
  double comfortable_bins = 3;
  double bins_from_constant = 2;
  double near_harmonic = 0.15;
  double still_the_mode = 0.5;
  double largest_detuning = 0.1;
  double decay_search_range = 0.15;
  double trivial_branch_sd = 8;
  double separate_tone_bins = 2;
  double excitation_purity = 0.5;
  double level_tolerance = 0.2;
  double dwell_drift = 0.01;
  double repeat_frequency = 1e-3;
  double repeat_level = 0.1;
  std::size_t halves_at_first = 7;
};

/// Those in use.
constexpr const MeasureThresholds& measure_thresholds() {
  return thresholds_in_use<MeasureThresholds>;
}

}  // namespace secular
