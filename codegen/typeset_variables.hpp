#pragma once

#include <vector>

#include "codegen/amplitude_relation.hpp"
#include "codegen/modulation_jacobian.hpp"
#include "codegen/typeset.hpp"
#include "codegen/variable_sum.hpp"

namespace secular::typeset {

/// Sums over the excitations' powers (times a factor), over the variables of one amplitude, over those of the
/// Cartesian form.
void add_forced(Sum& sum, const CanonicalModel& model, const VariableSum& value, const Product& factor = {},
                bool imaginary = false);
void add_amplitude(Sum& sum, const CanonicalModel& model, const CanonicalCase& resonance, const VariableSum& value);
Expression cartesian_expression(const CanonicalModel& model, const CanonicalCase& resonance,
                                const VariableSum& value);
Expression amplitude_expression(const CanonicalModel& model, const CanonicalCase& resonance,
                                const VariableSum& value);

}  // namespace secular::typeset
