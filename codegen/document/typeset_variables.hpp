#pragma once

#include <vector>

#include "codegen/canonical/amplitude_relation.hpp"
#include "codegen/canonical/modulation_jacobian.hpp"
#include "codegen/canonical/variable_sum.hpp"
#include "codegen/document/typeset.hpp"

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
