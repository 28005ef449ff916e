#pragma once

#include <string>
#include <vector>

#include "blind/measured_run.hpp"
#include "blind/measured_sets.hpp"

namespace secular::blind {

/// Effects that a diagnosis names: those of its cause, its set and what acts together with them. What it calls
/// nearest to an unknown cause is not named.
std::vector<std::string> named_effects(const nlohmann::json& diagnosis);

/// Records that warnings of the diagnosis say are left out.
std::vector<std::string> records_left_out(const nlohmann::json& diagnosis);

/// What of an aim is not met, a phrase a condition; of several aims those of the one that the fewest conditions of
/// are missed, the first of them. Empty: met. `results` are those of all sets of `list`.
std::vector<std::string> missed(std::size_t set, const MeasuredList& list,
                                const std::vector<MeasuredResult>& results);

/// The aims of a set as a sentence's part.
std::string aim_text(const MeasuredSet& set);

}  // namespace secular::blind
