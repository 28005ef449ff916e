#pragma once

#include "numerics/threshold.hpp"

namespace secular {

/// Of the correction for the truncation. `motion_threshold_list` says of each what it is. What only sets the way on
/// which its iteration gets to the same end stands beside it.
struct MotionThresholds {
  // Tuned.
  double settled_share = 0.1;
  double most_growth = 1000;
  double largest_line = 10;
  double largest_excess = 0.25;
};

/// Those in use.
constexpr const MotionThresholds& motion_thresholds() {
  return thresholds_in_use<MotionThresholds>;
}

}  // namespace secular
