#pragma once

#include "app/procedure/procedure_data.hpp"

namespace secular::app {

/// Excitation frequency at exact resonance, rad/s: from the onsets of a forward and a reverse sweep (a section of
/// its own), otherwise from the model's nominal numbers (a warning). `modes_in_sum`: how often every natural
/// frequency is in it, 2 of one mode, 1 of two. Throws InputError where there are neither.
double exact_resonance(const ProcedureData& test, int modes_in_sum);

}  // namespace secular::app
