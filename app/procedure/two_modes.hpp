#pragma once

#include "app/procedure/procedure_data.hpp"

namespace secular::app {

/// Chapter 6: harmonics, modulation equations (6.49)-(6.52) with the phase from the bispectrum, analysis of
/// variance.
void two_mode_procedures(const ProcedureData& test);

}  // namespace secular::app
