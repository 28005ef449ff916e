#pragma once

#include <array>

#include "motion/thresholds.hpp"

namespace secular {

/// What docs/thresholds.md prints, in its order.
inline constexpr std::array motion_threshold_list = {
    Threshold<MotionThresholds>{"settled_share", &MotionThresholds::settled_share, ThresholdKind::tuned,
                                "standard deviations", "numbers that move by less are corrected",
                                "docs/inference.md (11); adds 0.5 % to an error bar",
                                "correction/truncation_correction.cpp"},
    Threshold<MotionThresholds>{"most_growth", &MotionThresholds::most_growth, ThresholdKind::tuned,
                                "standard deviations before",
                                "corrections and numbers hardly determine one another: there is no correction",
                                "no record of the draws", "correction/truncation_correction.cpp"},
    Threshold<MotionThresholds>{"largest_line", &MotionThresholds::largest_line, ThresholdKind::tuned,
                                "largest line measured", "a motion with a larger one is none that was measured",
                                "no record of the draws", "correction/balanced_motions.cpp"},
    Threshold<MotionThresholds>{"largest_excess", &MotionThresholds::largest_excess, ThresholdKind::tuned,
                                "of an amplitude, in a radian", "a motion that changes faster does not stand still",
                                "no record of the draws", "correction/balanced_motions.cpp"},
};
static_assert(sizeof(MotionThresholds) == 8 * motion_threshold_list.size(), "each has its row");

}  // namespace secular
