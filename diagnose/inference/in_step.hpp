#pragma once

#include <cstddef>
#include <vector>

#include "diagnose/effects/candidate.hpp"
#include "diagnose/evidence/discrepancy.hpp"
#include "diagnose/evidence/frequency_scatter.hpp"
#include "diagnose/inference/refit.hpp"

namespace secular {

/// That natural frequencies which do not differ between records are said to.
inline constexpr double scatter_alarm = 0.001;

/// A fit among records whose natural frequencies are the same, and what it leaves along changes of each record's
/// own.
struct InStep {
  Refit fit;
  FrequencyScatter scatter;
};

/// Freezes the discrepancy at the fit's unknowns, without scatter between records.
InStep in_step(Discrepancy& discrepancy, Refit fit, std::size_t modes, unsigned threads);

/// Whether one candidate more explains what is left along the records' own frequencies, beyond what the likeliest
/// of so many columns does by chance: then a law is missing, and nothing scatters. `discrepancy` as in_step() left
/// it.
bool is_a_law(const InStep& left, Discrepancy& discrepancy, const std::vector<Candidate>& candidates,
              unsigned threads);

}  // namespace secular
