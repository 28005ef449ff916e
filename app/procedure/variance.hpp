#pragma once

#include "app/procedure/procedure_data.hpp"
#include "thesis/procedures/two_mode_regression.hpp"

namespace secular::app {

/// Analysis of variance of the source's regressions (6.49)-(6.51), terms added last (Tables D.1-D.5).
void thesis_variance(const ProcedureData& test, const TwoModeFit& fit);

/// The same of the generated modulation equations, whatever the model. Throws InputError for a term of the request
/// that they do not have.
void generated_variance(const ProcedureData& test);

}  // namespace secular::app
