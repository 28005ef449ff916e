#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "motion/correction/corrected_estimate.hpp"

namespace secular {

/// A step of the sensitivity within a decay.
struct GainStep {
  std::size_t record = 0;
  double at_s = 0;      ///< middle of the window in which it is
  double within_s = 0;  ///< length of that window
  double size = 0;      ///< log of the sensitivity behind it over that before
  double counts = 1;    ///< share of it that chance does not make
};

/// docs/inference.md (63): the most significant step of the logarithm of the amplitude of a decay (its largest
/// mode) beside what the full equations' motions at the estimate do and any slow course (level 0.1 % of a
/// campaign). Nothing where the phase steps there, too, as after a knock, or where decays have fewer than seven
/// windows.
std::optional<GainStep> gain_step(const CorrectedEstimate& found);

/// The observations without windows that hold the step, and with the sensitivity that acts before it in all of the
/// record, or the one behind it.
enum class RightGain { before, behind };
std::vector<ObservationSet> with_one_gain(std::vector<ObservationSet> sets, const GainStep& step, RightGain right);

}  // namespace secular
