#pragma once

#include "app/procedure/procedure_data.hpp"

namespace secular::app {

/// Chapter 5: saddle-node regression (5.34)-(5.37), frequency response (5.39), (5.40), drag against cubic damping,
/// harmonics (5.38). Too few levels of excitation: a warning, and harmonics alone.
void one_mode_procedures(const ProcedureData& test);

}  // namespace secular::app
