#pragma once

#include <memory>

#include "codegen/canonical/canonical_model.hpp"
#include "estimator/model/compiled_model.hpp"

namespace secular {

/// The model without a compiler: what generated code would compute, computed from the canonical form. Many times
/// slower, equal up to rounding. Throws InputError where emit_cpp does.
std::shared_ptr<const CompiledModel> interpreted_model(CanonicalModel model);

}  // namespace secular
