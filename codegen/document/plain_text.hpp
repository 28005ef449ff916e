#pragma once

#include <string>

#include "codegen/document/typeset.hpp"

namespace secular::typeset {

/// A formula as model text: "-mu*x_v + 3*a3/(8*omega0)*x_v^3"; conj(A) and abs(A) where a line or bars would stand.
std::string plain_text(const Expression& formula);

}  // namespace secular::typeset
