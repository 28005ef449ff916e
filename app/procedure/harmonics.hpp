#pragma once

#include "app/procedure/procedure_data.hpp"

namespace secular::app {

/// Harmonic regressions: (5.38) of one mode, (6.43)-(6.48) of two, as far as the model's expansion has the
/// harmonic.
void harmonic_procedure(const ProcedureData& test);

}  // namespace secular::app
