#pragma once

#include <cstddef>

#include "numerics/threshold.hpp"

namespace secular {

/// Of the diagnosis. Alarm levels and tuned numbers alone (numerics/threshold.hpp); `diagnose_threshold_list` says
/// of each what it is.
struct DiagnoseThresholds {
  // Alarm levels.
  double gap_alarm = 0.003;
  double scatter_alarm = 0.01;
  double moved_by = 3;
  double told_apart = 0.05;
  double least_gain = 4;
  double structure_alarm = 1e-4;
  double unsteady_alarm = 1e-6;
  double unsteady_excitation = 1e-3;
  double drift_alarm = 2e-3;
  double lower_line_alarm = 1e-6;
  double most_deviations = 4;
  double quiet_rows_sd = 4;
  // Tuned.
  double most_overestimated = 2;
  double first_scatter = 0.003;
  double same_size = 0.2;
  std::size_t foreign_searches = 3;
  double worth_a_test = 0.5;
  double as_good_as_certain = 0.9;
  double least_range = 0.01;
  double separable = 6;
  double least_share = 0.02;
  double one_sided = 0.8;
  double largest_extra = 4;
  double most_residual = 10;
  double reweighting = 1.3;
  double first_damping = 1e-2;
  double least_structure = 3.5;
  std::size_t balance_rows = 8;
  double same_setting = 1e-3;
  double least_closing = 0.5;
  double most_of_the_gap = 0.9;
  double largest_row = 3;
  double least_length = 1e-3;
  std::size_t fewest_segments = 8;
  double irregular = 0.3;
  double present = 6;
  std::ptrdiff_t fewest_ensembles = 4;
  std::ptrdiff_t usual_ensembles = 8;
  std::ptrdiff_t ensemble_samples = 64;
  double ensemble_turns = 12;
  double largest_drift = 0.05;
  double left_in_the_second_half = 0.05;
  double resonant_reach = 0.12;
  double trusted_share = 1e-5;
  double decay_turns = 6;
  double driven_turns = 40;
  std::ptrdiff_t segment_samples = 48;
  double zero_share = 0.25;
  double end_at_noise = 8;
  double wanted_samples = 24;
  double wanted_steps = 60;
  std::ptrdiff_t fewest_cosines = 4;
  double enough_freedom = 200;
  double disturbed_line = 4;
  double first_look = 1e-2;
  double no_motion = 1e4;
  double drives_from = 0.01;
  double above_rest = 5;
};

/// Those in use.
constexpr const DiagnoseThresholds& diagnose_thresholds() {
  return thresholds_in_use<DiagnoseThresholds>;
}

}  // namespace secular
