#pragma once

#include <optional>
#include <span>
#include <vector>

#include "estimator/identification/record_lateness.hpp"
#include "measure/observe/observation_set.hpp"

namespace secular {

/// What makes all records of a campaign late alike may be a low-pass, which takes amplitude off as well.
struct LowPass {
  double late_s = 0;     ///< of all records; negative: the excitation passes it, and is late
  double frequency = 0;  ///< rad/s, the mean one of what is late
  int poles = 1;         ///< equal ones, that together are as late

  double time_constant() const;  ///< s, of each
  double amplitude() const;      ///< what they leave of an amplitude at the frequency
};

/// The lateness that all records of all cases share, docs/inference.md (71): none where delays differ as those that
/// come at random do, where a quarter of a period or more is needed, or where no case's records are late.
/// `measured`: the sets of these cases.
std::optional<LowPass> shared_low_pass(std::span<const CaseLateness> lateness,
                                       std::span<const ObservationSet> measured);

/// The observations before the low-pass, docs/inference.md (72), sets whose phases are unknown and
/// decays: responses, or excitations where these pass it. Other sets are as they were.
std::vector<ObservationSet> before_low_pass(std::span<const ObservationSet> measured, const LowPass& filter);

}  // namespace secular
