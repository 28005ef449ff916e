#pragma once

#include <string>

#include "codegen/canonical/canonical_model.hpp"

namespace secular {

/// "mu = 2, eta = 2, others 0": powers of eps that were chosen for a case.
std::string orders_text(const CanonicalCase& c);

}  // namespace secular
